//! Data whose neighbouring differences have bounded ratios.

use crate::exact::{Rational, Real};
use crate::smoothness::symbol::Symbol;

/// Whether one step keeps the bound r ≥ 1 of the ratios of neighbouring differences of order m: whether, for all sequences d with
///
/// d_i ≥ 0, d_{i+1} ≤ r d_i and d_i ≤ r d_{i+1} for all i,
///
/// the sequence d'_j = Σ_i b_{j−ni} d_i, b(z) = a(z)/σ(z)^m, is of this kind too. Then so are the differences at all levels, and
/// the limits of such data are not negative, increase, or are convex, for m = 0, 1, 2. `None` where σ^m does not divide the symbol.
///
/// Each condition on d' says that some Σ_i c_i d_i ≥ 0, i from p to q. For given d_p, …, d_i the least value of the rest is
/// d_i·V_i, with V_q = c_q and V_i = c_i + min(r·V_{i+1}, V_{i+1}/r), as a linear function of d_{i+1} is least at an end of an
/// interval. So the condition holds for all d if and only if V_p ≥ 0. `proofs/THEOREMS.md`, 142.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::scheme::parse_scheme;
/// use subcert::smoothness::{Symbol, keeps_ratios};
///
/// // Second differences become (−d_{i−1} + 10d_i − d_{i+1})/32 and (4d_i + 4d_{i+1})/32.
/// let scheme = parse_scheme("(1+z)^2*(-1+4*z+10*z^2+4*z^3-z^4)/32")?;
/// let kept = |r| keeps_ratios(&Symbol::of(scheme.masks()[0]), 2, &r);
/// assert_eq!(kept(Rational::from(2)), Some(true));
/// assert_eq!(kept(Rational::new(21, 10)), Some(false));
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
#[must_use]
pub fn keeps_ratios<F: Real + PartialEq>(
    symbol: &Symbol<F>,
    order: usize,
    ratio: &F,
) -> Option<bool> {
    let differences = symbol.difference(order, &Rational::one())?;
    let n = i64::try_from(symbol.arity()).ok()?;
    let (low, high) = differences.powers();
    let zero = F::zero();
    let inverse = F::from_rational(&Rational::one()).over(ratio);
    let holds = |functional: &dyn Fn(i64) -> F, first: i64, last: i64| {
        let mut value = functional(last);
        for i in (first..last).rev() {
            // min(x, y) = −max(−x, −y)
            let [more, less] = [value.times(ratio), value.times(&inverse)];
            let least = zero.minus(&zero.minus(&more).greater(&zero.minus(&less)));
            value = functional(i).plus(&least);
        }
        zero.greater(&value) == value
    };
    let image = |j: i64, i: i64| differences.coefficient(j - n * i);
    // d'_j and d'_{j+1} depend on the d_i with low ≤ j + 1 − ni and j − ni ≤ high.
    let kept = |j: i64| {
        let (first, last) = (-(high - j).div_euclid(n), (j + 1 - low).div_euclid(n));
        let next_to = |i| image(j, i).times(ratio).minus(&image(j + 1, i));
        let back = |i| image(j + 1, i).times(ratio).minus(&image(j, i));
        let own = |i| image(j, i);
        first > last
            || [&own as &dyn Fn(i64) -> F, &next_to, &back]
                .into_iter()
                .all(|functional| holds(functional, first, last))
    };
    Some((0..n).all(kept))
}
