//! Whether limits keep the shape of the data: positivity, monotonicity, convexity.

use super::error::LimitError;
use super::value::Limit;
use crate::exact::Rational;
use crate::scheme::Mask;
use crate::smoothness::Symbol;

/// The most coefficients of a product of symbols.
const MAX_COEFFICIENTS: usize = 1 << 14;

/// A property of data and of limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// No value is negative.
    Positive,
    /// No difference is negative: what stands further to the right is not lower.
    Monotone,
    /// No second difference is negative.
    Convex,
}

impl Shape {
    /// The order m of the differences that are not negative.
    #[must_use]
    pub fn order(self) -> u32 {
        match self {
            Shape::Positive => 0,
            Shape::Monotone => 1,
            Shape::Convex => 2,
        }
    }
}

/// Whether the limits of all data with a shape have it too.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kept {
    /// They have: so many levels take such data to such data.
    Always {
        /// j.
        levels: u32,
    },
    /// Not all have. Of the data x_i = 1 for i = 0 and 0 elsewhere (positive), 1 for i ≥ 1 and 0 elsewhere (monotone),
    /// max(i − 1, 0) (convex), an m-th difference of values of the limit is negative.
    NotAlways {
        /// The first of the m + 1 equidistant parameters of these values, with points i at i.
        at: Rational,
        /// Their distance.
        step: Rational,
        /// The difference.
        difference: Rational,
    },
    /// Not all have: the limits of the data i are no lines.
    NoLines,
    /// Neither is found.
    Open {
        /// How many levels were tried.
        levels: u32,
    },
}

/// Whether all limits of data with this shape have it.
///
/// Let c_j be the coefficients of the product b(z)·b(z^n)⋯b(z^{n^{j−1}}), b = z^{m(n−1)}a/σ^m with σ(z) = 1 + z + … + z^{n−1}: the m-th differences of
/// level j are Σ_i c_{s − n^j i} (Δ^m x)_i. If no c_j is negative, j levels keep the shape, and so do 2j, 3j, … and the limit of
/// their polygons. With w_r the weights of the limit at 0, P^∞(s/n^j) = Σ_r w_r x^j_{s+r}, so that the m-th differences at the distance 1/n^j of the
/// limit of data with Δ^m x = 1 at 0 and 0 elsewhere are Σ_r w_r c_{s+r}. If σ^m does not divide a, m = 2, then data i and −i, which are
/// both convex, do not both have a convex limit.
///
/// ```
/// use subcert::limit::{Kept, Limit, Shape, shape_kept};
/// use subcert::scheme::parse_scheme;
///
/// let kept = |name: &str, shape| {
///     let scheme = parse_scheme(name).unwrap();
///     shape_kept(&Limit::new(scheme.masks()[0]).unwrap(), shape)
/// };
/// assert_eq!(kept("chaikin", Shape::Convex)?, Kept::Always { levels: 1 });
/// assert!(matches!(kept("four-point:w=1/16", Shape::Positive)?, Kept::NotAlways { .. }));
/// # Ok::<(), subcert::limit::LimitError>(())
/// ```
///
/// # Errors
/// When the limit at 0 has no value.
pub fn shape_kept(limit: &Limit, shape: Shape) -> Result<Kept, LimitError> {
    let mask: &Mask = limit.mask();
    let n = mask.arity();
    let order = shape.order();
    let Some(symbol) = Symbol::of(mask).difference(order as usize, &Rational::one()) else {
        return Ok(Kept::NoLines);
    };
    let weights = limit.at(&Rational::zero())?;
    let zero = Rational::zero();
    let steps = i64::from(order) * (i64::try_from(n).expect("a small arity") - 1);
    let lowest = symbol.powers().0 + steps;
    // The coefficients of the product, and the power of the first.
    let (mut product, mut first) = (vec![Rational::one()], 0_i64);
    let mut levels = 0;
    let mut scale = 1_usize;
    loop {
        let length = (symbol.coefficients().len() - 1).saturating_mul(scale);
        if product.len().saturating_add(length) > MAX_COEFFICIENTS {
            return Ok(Kept::Open { levels });
        }
        // Level j + 1 from level j: b(z^{n^j}) is the factor.
        let mut next = vec![zero.clone(); product.len() + length];
        for (i, factor) in symbol.coefficients().iter().enumerate() {
            for (k, value) in product.iter().enumerate() {
                next[i * scale + k] += &(factor * value);
            }
        }
        first += lowest * i64::try_from(scale).expect("below the cap");
        (product, levels, scale) = (next, levels + 1, scale * n);
        if product.iter().all(|c| *c >= zero) {
            return Ok(Kept::Always { levels });
        }
        if let Some((s, difference)) = negative(&product, first, &weights) {
            let step = Rational::from(scale).recip();
            let at = Rational::from(s) * &step;
            return Ok(Kept::NotAlways { at, step, difference });
        }
    }
}

/// A place s where Σ_r w_r c_{s+r} is negative, with this number.
fn negative(
    product: &[Rational],
    first: i64,
    weights: &super::functional::Functional,
) -> Option<(i64, Rational)> {
    let (low, high) = weights.support()?;
    let last = first + i64::try_from(product.len()).ok()?;
    let coefficient = |k: i64| {
        let place = usize::try_from(k - first).ok();
        place.and_then(|place| product.get(place)).cloned().unwrap_or_else(Rational::zero)
    };
    (first - high..last - low).find_map(|s| {
        let difference = weights.apply(|r| coefficient(s + r));
        (difference.sign() < 0).then_some((s, difference))
    })
}
