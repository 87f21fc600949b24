//! Theorems, lemmas and corollaries.

use super::table::LocatedReference;
use crate::exact::Rational;
use crate::formula::LocatedFormula;
use crate::limit::Parametrisation;

/// The names with a fixed meaning in every theorem about a bound or a depth: the spread of the
/// control data (of nets also along each direction), the level, and the tolerance. In such a
/// theorem they have no other meaning.
pub const THEOREM_NAMES: [&str; 6] = ["beta", "beta_1", "beta_2", "beta_3", "k", "epsilon"];

/// A theorem: its statement, and the claims on which it rests.
#[derive(Clone, Debug, PartialEq)]
pub struct Theorem {
    /// Its id within the paper.
    pub id: String,
    /// What the paper calls it: `Theorem 2.1`.
    pub locus: String,
    /// Its statement, in words.
    pub title: String,
    /// The scheme it is about; `None` when it speaks of every scheme of the paper.
    pub scheme: Option<LocatedReference>,
    /// The statement.
    pub statement: Statement,
    /// The instances on which it is tried.
    pub tried: Trial,
    /// A proof by hand that this program trusts.
    pub by_hand: Option<ByHand>,
    /// The ids of the claims of this paper that its statement or its proof uses.
    pub rests: Vec<String>,
    /// A note for the reader.
    pub note: Option<String>,
}

/// A proof by hand, or a refutation.
#[derive(Clone, Debug, PartialEq)]
pub struct ByHand {
    /// Where it stands: `THEOREMS 42`.
    pub text: String,
    /// Whether it refutes the theorem.
    pub refutes: bool,
    /// The ids of the claims of this paper that it uses. It is a proof while these hold.
    pub uses: Vec<String>,
}

/// A formula that a reader would put in place of a definition to save a theorem.
#[derive(Clone, Debug, PartialEq)]
pub struct Rewriting {
    /// The definition's name.
    pub of: String,
    /// The correction, in a few words.
    pub says: String,
    /// The formula.
    pub value: LocatedFormula,
}

/// The instances on which a theorem is tried: schemes of its kind at values of its parameters.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trial {
    /// The schemes, where the theorem itself does not name one.
    pub schemes: Vec<LocatedReference>,
    /// Values of the names that the theorem leaves open; all combinations are tried.
    pub values: Vec<(String, Vec<Rational>)>,
    /// The index offset at which the theorem compares polygon and limit; `None` for the schemes'
    /// own offsets.
    pub offset: Option<i64>,
    /// Whether the points of a level are at their natural parameters, and not at i/n^k.
    pub natural: bool,
    /// A ring L. With it, a step is |x^{k+1} − Lx^k|, and distances are compared only at points
    /// that L keeps. Without it, points of two levels are compared by their names.
    pub interpolant: Option<LocatedReference>,
    /// The number c of levels of the constant in the bound, where the printed bound takes one power
    /// of this constant for each level.
    pub block: Option<LocatedFormula>,
    /// Formulas that may stand in place of definitions, to save the theorem where it is false.
    pub rewritings: Vec<Rewriting>,
    /// The hypothesis that the first value is below the second.
    pub supposes: Option<(LocatedFormula, LocatedFormula)>,
}

impl Trial {
    /// Where the points of a level are.
    #[must_use]
    pub fn parametrisation(&self) -> Parametrisation {
        if self.natural { Parametrisation::Natural } else { Parametrisation::Indexed }
    }
}

/// What a theorem states. P^k is the control polygon, or net, after k levels.
///
/// A bound is a formula in k and beta = max ‖Δ^0‖, the largest difference of neighbouring points of
/// P^0. For a surface, it may also use beta_1 and beta_3, the largest difference along the first
/// direction (in a row and in the next one), and beta_2, that along the second direction.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// quantity ≤ by, for every level k ≥ from.
    Bound {
        /// The bounded quantity.
        quantity: Quantity,
        /// The bound.
        by: LocatedFormula,
        /// The first level for which it is stated.
        from: u32,
    },
    /// ‖P^∞ − P^k‖ ≤ ε for every level k that is at least the value of this formula at ε.
    Depth(LocatedFormula),
    /// Another statement, in a few words.
    Other(String),
}

/// A quantity that theorems bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
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
