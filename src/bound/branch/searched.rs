//! What a search for a norm finds, its cap on work, and when it is better to visit all rows.

use super::problem::Greatest;
use super::scaled::Scaled;
use crate::bound::budget::Budget;
use crate::bound::power::{ClassCap, MAX_WORK, PowerNorm};
use crate::bound::walk::price;
use crate::exact::Rational;
use crate::scheme::Rules;

/// A search that takes as much work as so many visits of all classes is given up for one.
const VISITS: u64 = 8;

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
pub(super) fn either<const K: usize>(
    rules: [&Rules; K],
    levels: u32,
    budget: &Budget,
    walk: impl Fn() -> Result<PowerNorm, ClassCap>,
    search: impl FnOnce(&mut u64) -> Option<PowerNorm>,
) -> Result<PowerNorm, ClassCap> {
    let arity = rules[0].arity();
    let classes = (arity as u64).checked_pow(levels);
    let visit = ClassCap::check(arity, levels).map(|()| rules.map(|one| price(one, levels)));
    let visit = visit.map(|prices| prices.into_iter().sum::<u64>());
    if classes.is_none_or(|classes| classes > FEW_CLASSES) {
        let visits = visit.map_or(u64::MAX, |visit| visit.saturating_mul(VISITS));
        if let Some(found) = budget.spend(MAX_WORK.min(visits), search) {
            return Ok(found);
        }
    }
    let work = MAX_WORK.min(budget.total());
    match visit {
        Ok(visit) if budget.take(visit) => walk(),
        _ => Err(ClassCap { arity, levels, work }),
    }
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
