//! Whether limits keep the shape of the data, over any ordered field.

use super::values::LimitValues;
use crate::exact::{Rational, Real};
use crate::smoothness::shape::Shape;
use crate::smoothness::symbol::{Symbol, with_level};

/// The most coefficients of a product of symbols.
const MAX_COEFFICIENTS: usize = 256;

/// Whether the limits of all data with this shape have it, as [`shape_kept`](crate::smoothness::shape_kept) says; `None` if products of up to
/// 256 coefficients do not decide it, or σ^m does not divide the symbol.
///
/// `values` are those of the basic limit function of the symbol.
///
/// ```
/// use subcert::scheme::parse_scheme;
/// use subcert::smoothness::{LimitValues, Shape, Symbol, is_shape_kept};
///
/// let kept = |text, shape| {
///     let symbol = Symbol::of(parse_scheme(text).unwrap().masks()[0]);
///     is_shape_kept(&symbol, &LimitValues::new(&symbol).unwrap(), shape)
/// };
/// assert_eq!(kept("chaikin", Shape::Convex), Some(true));
/// assert_eq!(kept("four-point", Shape::Positive), Some(false));
/// ```
#[must_use]
pub fn is_shape_kept<F: Real + PartialEq>(
    symbol: &Symbol<F>,
    values: &LimitValues<F>,
    shape: Shape,
) -> Option<bool> {
    let n = symbol.arity();
    let differences = symbol.difference(shape.order() as usize, &Rational::one())?;
    let factors = differences.coefficients();
    // φ(−r), for all r for which it is not 0.
    let (first, last) = symbol.support();
    let (low, high) = ((-last).ceil().to_i64()?, (-first).floor().to_i64()?);
    let weights: Option<Vec<F>> = (low..=high).map(|r| values.at(&Rational::from(-r))).collect();
    let weights = weights?;
    let zero = F::zero();
    let is_negative = |x: &F| zero.greater(x) != *x;
    // Powers of z only shift the coefficients.
    let (mut product, mut scale) = (vec![F::from_rational(&Rational::one())], 1_usize);
    loop {
        let length = product.len() + (factors.len() - 1) * scale;
        if length > MAX_COEFFICIENTS {
            return None;
        }
        (product, scale) = (with_level(&product, factors, scale), scale * n);
        if !product.iter().any(is_negative) {
            return Some(true);
        }
        let padded = |at: usize| at.checked_sub(weights.len()).and_then(|at| product.get(at));
        let sum = |at: usize| {
            let terms = weights.iter().enumerate();
            let terms = terms.filter_map(|(r, weight)| Some(weight.times(padded(at + r)?)));
            terms.fold(F::zero(), |sum, term| sum.plus(&term))
        };
        if (0..product.len() + weights.len()).any(|at| is_negative(&sum(at))) {
            return Some(false);
        }
    }
}
