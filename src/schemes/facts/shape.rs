//! What one sees of a mask: points, symmetry, primal or dual, interpolating or not.

use crate::exact::{Rational, Scalar};
use crate::joint::Entry;
use crate::scheme::Mask;
use crate::smoothness::Symbol;

/// Where new points stand between old ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointPlacement {
    /// Old points have the parameters of some new ones: (n − 1)s is an integer.
    Primal,
    /// New points stand symmetrically around the old parameters, half a step off: (n − 1)s + 1/2 is an integer.
    Dual,
}

impl PointPlacement {
    /// `primal` or `dual`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            PointPlacement::Primal => "primal",
            PointPlacement::Dual => "dual",
        }
    }
}

/// The greatest number of points from the first to the last coefficient of a rule that is not 0.
#[must_use]
pub fn points<F: Entry>(mask: &Mask<F>) -> usize {
    let zero = F::zero();
    let points = mask.rules().rows().iter().map(|row| {
        let first = row.iter().position(|c| *c != zero);
        let last = row.iter().rposition(|c| *c != zero);
        first.zip(last).map_or(0, |(first, last)| last - first + 1)
    });
    points.max().unwrap_or(0)
}

/// Whether one rule has a single coefficient that is not 0: it is 1, and all points are kept.
#[must_use]
pub fn is_interpolating<F: Scalar + PartialEq>(mask: &Mask<F>) -> bool {
    let zero = F::zero();
    mask.rules().rows().iter().any(|row| row.iter().filter(|c| **c != zero).count() == 1)
}

/// The centre of the basic limit function, when x^k_i belongs to i/n^k; `None` where the mask is not symmetric.
///
/// With coefficients a_s = a_{u−s}, it is u/(2(n − 1)).
#[must_use]
pub fn centre<F: Scalar + PartialEq>(symbol: &Symbol<F>) -> Option<Rational> {
    let coefficients = symbol.coefficients();
    let symmetric = coefficients.iter().eq(coefficients.iter().rev());
    let (low, high) = symbol.support();
    symmetric.then(|| (low + high) * Rational::new(1, 2))
}

/// Whether a scheme of arity n is primal or dual, from the place s of x^0_0 on the limit: x^k_i belongs to
/// (i + s)/n^k. An old parameter i + s is that of a new point where n(i + s) − s is an integer.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::facts::{PointPlacement, kind};
///
/// assert_eq!(kind(2, &Rational::new(-1, 2)), Some(PointPlacement::Dual));
/// assert_eq!(kind(3, &Rational::new(1, 2)), Some(PointPlacement::Primal));
/// assert_eq!(kind(3, &Rational::new(-1, 4)), Some(PointPlacement::Dual));
/// assert_eq!(kind(2, &Rational::new(1, 3)), None);
/// ```
#[must_use]
pub fn kind(arity: usize, place: &Rational) -> Option<PointPlacement> {
    let steps = place * &(Rational::from(arity) - Rational::one());
    if steps.is_integer() {
        return Some(PointPlacement::Primal);
    }
    (steps + Rational::new(1, 2)).is_integer().then_some(PointPlacement::Dual)
}
