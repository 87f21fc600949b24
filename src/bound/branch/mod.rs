//! Norms of powers by branch and bound: few rows are visited, and the value is exact.
//!
//! A word of digits leads from E^0 to a row of E^c, the coarse digit first. What is known of
//! all rows below a node — their coefficients in those of the node sum to 1, have a known
//! first moment, and their absolute values sum to at most ‖E^m‖ — bounds their sums, and a
//! node whose bound is not above the best row found is not split.
//!
//! Source: `proofs/THEOREMS.md`, 60 to 64.

mod descent;
mod estimate;
mod growth;
mod joint;
mod leaf;
mod number;
mod reach;
mod scaled;
mod search;
mod sweep;
mod tree;
mod uniform;
mod wide;

use super::contraction::{ClassCap, Order, PowerNorm, oriented, walked_norm};
use crate::exact::Rational;
use crate::scheme::Rules;
use growth::Growth;
pub use joint::JointSearch;
pub use leaf::{Closed, Leaf, SearchTree, SearchedOperator};
use scaled::Scaled;
use search::Greatest;
pub use uniform::UniformBound;

/// The greatest number of levels of a search.
pub const MAX_LEVELS: u32 = 256;

/// The most products of words that are computed for one norm.
const MAX_WORK: u64 = 1 << 33;

/// Up to so many residue classes are visited one by one.
const FEW_CLASSES: u64 = 1 << 12;

/// A norm, where it is attained, and what the search for it took.
#[derive(Clone, Debug, PartialEq)]
pub struct Searched {
    /// The norm.
    pub norm: PowerNorm,
    /// The nodes that were split into n parts each, by the search for this norm alone.
    pub nodes: u64,
}

/// ‖R^c‖ for several c: what one search finds out about R serves the next ones.
///
/// ```
/// use subcert::bound::{Order, PowerSearch};
/// use subcert::exact::Rational;
/// use subcert::scheme::parse_scheme;
///
/// let scheme = parse_scheme("four-point")?;
/// let mut search = PowerSearch::new(&scheme.masks()[0].difference(), Order::Adjoint);
/// let found = search.search(64).expect("the work suffices");
/// // 2^c·T_c tends to 4/3.
/// let rest = Rational::new(4, 3) - &found.norm.value * Rational::from(2).pow(64);
/// assert!(rest.sign() > 0 && rest < Rational::from(4).pow(-63));
/// assert!(found.nodes < 2000);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct PowerSearch {
    /// As they are read.
    rules: Rules,
    growth: Growth,
}

impl PowerSearch {
    /// The powers of the operator of these rules, read in this order.
    #[must_use]
    pub fn new(rules: &Rules, order: Order) -> PowerSearch {
        let rules = oriented(rules, order);
        let [growth] = Growth::of([&rules]);
        PowerSearch { rules, growth }
    }

    /// ‖R^c‖ and the least row that attains it, as [`power_norm`](super::power_norm).
    ///
    /// # Errors
    /// When c is above [`MAX_LEVELS`], or when the search does not end within 2^33 products
    /// and there are more than 2^24 residue classes.
    pub fn norm(&mut self, levels: u32) -> Result<PowerNorm, ClassCap> {
        let arity = self.rules.arity();
        either(
            arity,
            levels,
            || walked_norm(&self.rules, levels, Order::Adjoint),
            || Some(found(&mut self.growth, levels, &mut { MAX_WORK })?.norm),
        )
    }

    /// The same by branch and bound, however few residue classes there are; `None` when it
    /// does not end within 2^33 products, or c is above [`MAX_LEVELS`].
    pub fn search(&mut self, levels: u32) -> Option<Searched> {
        self.search_within(levels, &mut { MAX_WORK })
    }

    /// The same within so many products, less those computed.
    pub(crate) fn search_within(&mut self, levels: u32, work: &mut u64) -> Option<Searched> {
        found(&mut self.growth, levels, work)
    }

    /// A tree of bounds that shows ‖E^c‖, and what they rest on; `None` as for
    /// [`search`](PowerSearch::search). Its nodes are bounded each by its own rows, so that it
    /// may be larger than the tree of the search.
    pub fn tree(&mut self, levels: u32) -> Option<SearchTree> {
        (levels <= MAX_LEVELS).then(|| self.growth.tree(levels, &mut { MAX_WORK }))?
    }
}

fn found(growth: &mut Growth, levels: u32, work: &mut u64) -> Option<Searched> {
    let found = (levels <= MAX_LEVELS).then(|| growth.greatest(levels, work))??;
    Some(unscaled([growth.operator()], levels, found))
}

/// By visiting every class if there are few; else by the search, or if it does not end, by
/// visiting every class if that is possible.
fn either(
    arity: usize,
    levels: u32,
    walk: impl Fn() -> Result<PowerNorm, ClassCap>,
    search: impl FnOnce() -> Option<PowerNorm>,
) -> Result<PowerNorm, ClassCap> {
    let classes = (arity as u64).checked_pow(levels);
    if classes.is_some_and(|classes| classes <= FEW_CLASSES) {
        return walk();
    }
    search().map_or_else(walk, Ok)
}

/// From the scaled operators to their own.
fn unscaled<const K: usize>(operators: [&Scaled; K], levels: u32, found: Greatest) -> Searched {
    let scale =
        |operator: &Scaled| operator.factor.abs() / Rational::from(operator.denominator.clone());
    let scale =
        operators.iter().fold(Rational::one(), |product, operator| product * scale(operator));
    let value = Rational::from(found.value) * scale.pow(levels.cast_signed());
    Searched { norm: PowerNorm { value, class: found.class }, nodes: found.split }
}
