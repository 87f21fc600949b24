//! Monomials of several variables, and rational matrices of the size of a dilation.

use crate::exact::{Rational, Scalar};
use crate::scheme::{Dilation, Point};

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

/// M^{−1}x.
pub(super) fn divided(dilation: &Dilation, x: &[Rational]) -> Vec<Rational> {
    let d = dilation.dimension();
    let inverse = Rational::from(dilation.determinant()).recip();
    let unit = |j: usize| std::array::from_fn(|i| i64::from(i == j));
    let columns: Vec<Point> = (0..d).map(|j| dilation.adjugate_times(unit(j))).collect();
    let entry = |i: usize| {
        let terms = columns.iter().zip(x).map(|(column, x)| x * &Rational::from(column[i]));
        terms.sum::<Rational>() * &inverse
    };
    (0..d).map(entry).collect()
}
