//! The result of a search for a norm, and the choice between a search and a visit of all
//! rows.

use super::problem::Greatest;
use super::scaled::Scaled;
use crate::bound::budget::Budget;
use crate::bound::power::{ClassCap, MAX_WORK, PowerNorm};
use crate::bound::walk::price;
use crate::exact::Rational;
use crate::scheme::Rules;

/// A search is given up for a visit of all classes after this many times the work of such
/// a visit.
const VISITS: u64 = 8;

/// Up to this number of residue classes, all classes are visited.
const FEW_CLASSES: u64 = 1 << 12;

/// A norm, the class that attains it, and the effort of the search.
#[derive(Clone, Debug, PartialEq)]
pub struct Searched {
    /// The norm.
    pub norm: PowerNorm,
    /// The number of nodes that the search for this norm alone split, into n parts each.
    pub nodes: u64,
}

/// The norm by visiting every class, if there are few; otherwise by the search. If the
/// search does not end, every class is visited if that is within the caps.
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

/// Converts the result for the scaled operators to the result for the original ones.
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
