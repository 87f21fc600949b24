//! Monomials of several variables, and rational matrices of the size of a dilation.

use crate::exact::{Rational, Scalar};
use crate::scheme::Point;

/// The exponents μ of total degree k in d variables, the first variable with the highest power first.
pub(super) fn of_degree(k: u32, dimension: usize) -> Vec<[u32; 3]> {
    let mut all = Vec::new();
    for x in (0..=k).rev() {
        for y in (0..=k - x).rev() {
            let rest = k - x - y;
            match dimension {
                3 => all.push([x, y, rest]),
                _ if rest == 0 => all.push([x, y, 0]),
                _ => {}
            }
        }
    }
    all
}

/// γ^μ.
pub(super) fn power(place: Point, exponents: [u32; 3]) -> Rational {
    let factors = place.into_iter().zip(exponents);
    factors.fold(Rational::one(), |product, (x, e)| product * raised(&Rational::from(x), e))
}

/// x^μ over any numbers.
pub(super) fn power_of<S: Scalar>(place: &[S], exponents: [u32; 3]) -> S {
    let one = S::from_rational(&Rational::one());
    place
        .iter()
        .zip(exponents)
        .fold(one, |product, (x, e)| (0..e).fold(product, |product, _| product.times(x)))
}

fn raised(x: &Rational, e: u32) -> Rational {
    x.pow(i32::try_from(e).expect("a small exponent"))
}
