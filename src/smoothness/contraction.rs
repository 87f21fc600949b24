//! Derived schemes whose differences contract.

use super::symbol::Symbol;
use crate::bound::{Budget, Order, PowerSearch};
use crate::exact::Rational;

/// The most levels at a time.
const MAX_LEVELS: u32 = 24;

/// The most steps of the search for each order.
const MAX_STEPS: u64 = 20_000_000;

/// For each m = 0, …, `most` the least c ≤ 24 with ‖(n^m S_{m+1})^c‖_∞ < 1, and this norm, where S_{m+1}
/// refines the differences of order m + 1. This proves that the limits are C^m (`proofs/THEOREMS.md`, 107).
/// `None` where the search finds no such c.
#[must_use]
pub fn contractions(symbol: &Symbol, most: usize) -> Vec<Option<(u32, Rational)>> {
    (0..=most).map(|m| derived(symbol, m)).collect()
}

/// The same for one m.
pub(super) fn derived(symbol: &Symbol, m: usize) -> Option<(u32, Rational)> {
    let n = Rational::from(symbol.arity());
    let power = (0..m).fold(Rational::one(), |power, _| power * &n);
    contraction(&symbol.difference(m + 1, &power)?)
}

fn contraction(difference: &Symbol) -> Option<(u32, Rational)> {
    let rules = difference.rules();
    let mut search = PowerSearch::new(&rules, Order::Adjoint).with_budget(Budget::new(MAX_STEPS));
    let norms = (1..=MAX_LEVELS).map_while(|c| Some((c, search.norm(c).ok()?.value)));
    norms.into_iter().find(|(_, norm)| *norm < Rational::one())
}
