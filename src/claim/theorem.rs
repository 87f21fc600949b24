//! Theorems, lemmas and corollaries.

use super::table::LocatedReference;
use crate::formula::LocatedFormula;

/// A theorem: what it states, and what that rests on.
#[derive(Clone, Debug)]
pub struct Theorem {
    /// Its id within the paper.
    pub id: String,
    /// What the paper calls it: `Theorem 2.1`.
    pub locus: String,
    /// What it says.
    pub title: String,
    /// The scheme it is about; `None` when it speaks of every scheme of the paper.
    pub scheme: Option<LocatedReference>,
    /// What it states.
    pub statement: Statement,
    /// The ids of the claims of this paper that its statement or its proof uses.
    pub rests: Vec<String>,
    /// What a reader should know.
    pub note: Option<String>,
}

/// What a theorem states. P^k is the control polygon, or net, after k levels.
///
/// A bound is a formula in k and beta = max ‖Δ^0‖, the largest difference of
/// neighbouring points of P^0; of a surface, also in beta_1, beta_2 and beta_3, its
/// largest differences along the first and the second direction, and again along the
/// first one, a row further.
#[derive(Clone, Debug)]
pub enum Statement {
    /// quantity ≤ by, for every level k ≥ from.
    Bound {
        /// What is bounded.
        quantity: Quantity,
        /// The bound.
        by: LocatedFormula,
        /// The first level for which it is stated.
        from: u32,
    },
    /// ‖P^∞ − P^k‖ ≤ ε for every level k that is at least this formula in ε.
    Depth(LocatedFormula),
    /// Something else, in a few words.
    Other(String),
}

/// What a theorem bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// ‖P^∞ − P^k‖.
    Distance,
    /// ‖P^{k+1} − P^k‖.
    Step,
    /// max ‖Δ^k‖, the largest difference of neighbouring points of P^k.
    Difference,
}

impl Quantity {
    /// Every quantity.
    pub const ALL: [Quantity; 3] = [Quantity::Distance, Quantity::Step, Quantity::Difference];

    /// Its name in claim files: `distance`, `step` or `difference`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Quantity::Distance => "distance",
            Quantity::Step => "step",
            Quantity::Difference => "difference",
        }
    }

    /// Its usual notation.
    #[must_use]
    pub fn notation(self) -> &'static str {
        match self {
            Quantity::Distance => "‖P^∞ − P^k‖",
            Quantity::Step => "‖P^{k+1} − P^k‖",
            Quantity::Difference => "max ‖Δ^k‖",
        }
    }
}
