//! What a search for a norm finds, its cap on work, and when it is better to visit all rows.

use super::problem::Greatest;
use super::scaled::Scaled;
use crate::bound::power::{ClassCap, PowerNorm};
use crate::exact::Rational;

/// The most products of words that are computed for one norm.
pub(super) const MAX_WORK: u64 = 1 << 33;

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

/// By visiting every class if there are few; else by the search, or if it does not end, by
/// visiting every class if that is possible.
pub(super) fn either(
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
pub(super) fn unscaled<const K: usize>(
    operators: [&Scaled; K],
    levels: u32,
    found: Greatest,
) -> Searched {
    let scale =
        |operator: &Scaled| operator.factor.abs() / Rational::from(operator.denominator.clone());
    let scale =
        operators.iter().fold(Rational::one(), |product, operator| product * scale(operator));
    let value = Rational::from(found.value) * scale.pow(levels.cast_signed());
    Searched { norm: PowerNorm { value, class: found.class }, nodes: found.split }
}
