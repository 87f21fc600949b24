//! Whether limits keep the shape of the data: positivity, monotonicity, convexity.

use super::symbol::Symbol;
use crate::exact::{CommonDenominator, Integer, Rational};
use crate::limit::{Limit, LimitError};
use crate::scheme::Mask;

/// The most coefficients of a product of symbols.
const MAX_COEFFICIENTS: usize = 1 << 14;

/// The most bits of all its coefficients together.
const MAX_BITS: u64 = 1 << 22;

/// The smallest distance at which the limit of a line is looked at is the inverse of at most this.
const MAX_PARTS: usize = 256;

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
/// limit of data with Δ^m x = 1 at 0 and 0 elsewhere are Σ_r w_r c_{s+r}. If σ^m does not divide a, m = 2, and the limit of the data i is no line,
/// then data i and −i, which are both convex, do not both have a convex limit.
///
/// ```
/// use subcert::limit::Limit;
/// use subcert::smoothness::{Kept, Shape, shape_kept};
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
/// When the limit has no value at a parameter.
///
/// # Panics
/// Never: a mask has a small arity.
pub fn shape_kept(limit: &Limit, shape: Shape) -> Result<Kept, LimitError> {
    let mask: &Mask = limit.mask();
    let n = mask.arity();
    let order = shape.order();
    let Some(symbol) = Symbol::of(mask).difference(order as usize, &Rational::one()) else {
        return lines(limit);
    };
    let at_zero = limit.at(&Rational::zero())?;
    let (low, high) = at_zero.support().unwrap_or_default();
    let weights: Vec<Rational> = (low..=high).map(|r| at_zero.coefficient(r)).collect();
    // w_r over the common denominator q.
    let weights = CommonDenominator::of(&[weights]);
    let steps = i64::from(order) * (i64::try_from(n).expect("a small arity") - 1);
    let lowest = symbol.powers().0 + steps;
    // Positive factors change no sign, so that integers do.
    let common = CommonDenominator::of(&[symbol.coefficients().to_vec()]);
    let factors = &common.numerators[0];
    let longest = factors.iter().map(Integer::bits).max().unwrap_or(0);
    // The coefficients of the product, and the power of the first.
    let (mut product, mut first) = (vec![Integer::one()], 0_i64);
    let (mut levels, mut scale) = (0_u32, 1_usize);
    loop {
        let length = product.len().saturating_add((factors.len() - 1).saturating_mul(scale));
        let bits = (length as u64).saturating_mul(longest * u64::from(levels + 1));
        if length > MAX_COEFFICIENTS || bits > MAX_BITS {
            return Ok(Kept::Open { levels });
        }
        // Level j + 1 from level j: b(z^{n^j}) is the factor.
        let mut next = vec![Integer::zero(); length];
        for (i, factor) in factors.iter().enumerate() {
            for (k, value) in product.iter().enumerate() {
                next[i * scale + k] += factor * value;
            }
        }
        first += lowest * i64::try_from(scale).expect("below the cap");
        (product, levels, scale) = (next, levels + 1, scale * n);
        if product.iter().all(|c| c.sign() >= 0) {
            return Ok(Kept::Always { levels });
        }
        if let Some((s, sum)) = negative(&product, first, (&weights.numerators[0], low)) {
            let step = Rational::from(scale).recip();
            let at = Rational::from(s) * &step;
            let over = common.denominator.pow(levels) * weights.denominator;
            let difference = Rational::new(sum, over);
            return Ok(Kept::NotAlways { at, step, difference });
        }
    }
}

/// Whether the limit of the data i is a line, of a mask without a scheme of second differences.
///
/// It is a line plus a function of period 1. If its second differences at some distance are not all 0, some are negative, and those of
/// the limit of −i too.
fn lines(limit: &Limit) -> Result<Kept, LimitError> {
    let n = limit.mask().arity();
    let mut parts = n;
    let mut levels = 0;
    while parts <= MAX_PARTS {
        let step = Rational::from(parts).recip();
        let value = |s: usize| {
            let at = limit.at(&(Rational::from(s) * &step))?;
            Ok(at.apply(Rational::from))
        };
        let values = (0..parts + 2).map(value).collect::<Result<Vec<Rational>, LimitError>>()?;
        let bends = |three: &[Rational]| &three[0] + &three[2] != &three[1] + &three[1];
        if values.windows(3).any(bends) {
            return Ok(Kept::NoLines);
        }
        (parts, levels) = (parts * n, levels + 1);
    }
    Ok(Kept::Open { levels })
}

/// A place s where Σ_r w_r c_{s+r} is negative, with q times this number.
fn negative(
    product: &[Integer],
    first: i64,
    (weights, low): (&[Integer], i64),
) -> Option<(i64, Integer)> {
    let last = first + i64::try_from(product.len()).ok()?;
    let high = low + i64::try_from(weights.len()).ok()?;
    (first - high..last - low).find_map(|s| {
        let mut sum = Integer::zero();
        for (place, weight) in (s + low - first..).zip(weights) {
            if let Some(c) = usize::try_from(place).ok().and_then(|place| product.get(place)) {
                sum += weight * c;
            }
        }
        (sum.sign() < 0).then_some((s, sum))
    })
}
