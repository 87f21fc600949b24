//! Derived schemes whose differences contract.

use super::coefficient::Coefficient;
use super::symbol::Symbol;
use crate::exact::Rational;
use crate::stop::Stop;

/// For each m = 0, …, `most` the least c ≤ 24 with ‖(n^m S_{m+1})^c‖_∞ < 1, and this norm, where S_{m+1}
/// refines the differences of order m + 1. This proves that the limits are C^m (`proofs/THEOREMS.md`, 107).
/// `None` where the search finds no such c, or is stopped, and for irrational coefficients.
#[must_use]
pub fn contractions<F: Coefficient>(
    symbol: &Symbol<F>,
    most: usize,
    stop: &Stop,
) -> Vec<Option<(u32, Rational)>> {
    (0..=most).map(|m| stop.run(|| derived(symbol, m)).ok().flatten()).collect()
}

/// The same for one m.
pub(super) fn derived<F: Coefficient>(symbol: &Symbol<F>, m: usize) -> Option<(u32, Rational)> {
    let n = Rational::from(symbol.arity());
    let power = (0..m).fold(Rational::one(), |power, _| power * &n);
    F::contraction(&symbol.difference(m + 1, &power)?.rules())
}
