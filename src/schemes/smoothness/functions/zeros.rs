//! Zeros of symbols: at 1, and in the left half of the plane.

use crate::exact::{Real, Scalar};
use crate::smoothness::symbol::Symbol;

/// The greatest p for which (1 − z)^p divides the symbol: Σ_k k^j a_k = 0 for all j < p, and not for j = p. A symbol 0 has none.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::smoothness::vanishing_moments;
///
/// let filter = [-1, 3, -3, 1].map(Rational::from);
/// assert_eq!(vanishing_moments(&filter), 3);
/// ```
#[must_use]
pub fn vanishing_moments<F: Scalar + PartialEq>(coefficients: &[F]) -> usize {
    let zero = F::zero();
    let mut rest = coefficients.to_vec();
    let mut order = 0;
    // By Horner's rule: the quotient by z − 1, and the value at 1.
    while rest.len() > 1 {
        let mut sum = F::zero();
        let mut sums: Vec<F> = rest
            .iter()
            .rev()
            .map(|c| {
                sum.accumulate(c);
                sum.clone()
            })
            .collect();
        if sums.pop().is_none_or(|value| value != zero) {
            return order;
        }
        sums.reverse();
        (rest, order) = (sums, order + 1);
    }
    order
}

/// Whether all zeros of the symbol without its power of z have negative real parts. A constant has no zeros.
///
/// By Routh's scheme: with p = c_0x^d + c_1x^{d−1} + …, the rows (c_0, c_2, …), (c_1, c_3, …), and each next one, r'' = r_{j+1} −
/// (r_0/r'_0)·r'_{j+1}, begin with numbers of one sign.
///
/// ```
/// use subcert::scheme::parse_scheme;
/// use subcert::smoothness::{Symbol, is_hurwitz};
///
/// let hurwitz = |name| is_hurwitz(&Symbol::of(parse_scheme(name).unwrap().masks()[0]));
/// assert!(hurwitz("chaikin") && !hurwitz("four-point"));
/// ```
#[must_use]
pub fn is_hurwitz<F: Real + PartialEq>(symbol: &Symbol<F>) -> bool {
    let zero = F::zero();
    let falling: Vec<&F> = symbol.coefficients().iter().rev().collect();
    let Some(leading) = falling.first() else { return false };
    let is_negative = zero.greater(leading) != **leading;
    let sign = |c: &F| if is_negative { zero.minus(c) } else { c.clone() };
    let row = |start: usize| falling.iter().skip(start).step_by(2).map(|c| sign(c)).collect();
    let (mut first, mut second): (Vec<F>, Vec<F>) = (row(0), row(1));
    for _ in 1..falling.len() {
        let (Some(above), Some(pivot)) = (first.first(), second.first()) else { return false };
        if *pivot == zero || zero.greater(pivot) != *pivot {
            return false;
        }
        let factor = above.over(pivot);
        let entry = |j: usize| {
            let below = second.get(j).map_or_else(F::zero, |c| c.times(&factor));
            first[j].minus(&below)
        };
        let third = (1..first.len()).map(entry).collect();
        (first, second) = (second, third);
    }
    true
}
