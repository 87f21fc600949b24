//! f64 as a [`Real`]: the arithmetic of the machine.

use super::convert::nearest;
use crate::exact::{Rational, Real, Scalar};

/// The operations are those of IEEE 754, rounded to nearest. They form a ring only up to
/// rounding: sums depend on their order. Overflow gives infinities and NaN, never a
/// panic.
///
/// ```
/// use subcert::exact::{Rational, Scalar};
///
/// let tenth = f64::from_rational(&Rational::new(1, 10));
/// assert_eq!(f64::total(&[tenth; 10]), 0.999_999_999_999_999_9);
/// ```
impl Scalar for f64 {
    /// The nearest f64, as for a literal in source code.
    fn from_rational(value: &Rational) -> f64 {
        nearest(value)
    }
    fn plus(&self, other: &f64) -> f64 {
        self + other
    }
    fn minus(&self, other: &f64) -> f64 {
        self - other
    }
    fn times(&self, other: &f64) -> f64 {
        self * other
    }
    fn zero() -> f64 {
        0.0
    }
}

/// Every operation with a NaN gives NaN, also [`Real::greater`], so that a failure stays
/// visible.
impl Real for f64 {
    fn magnitude(&self) -> f64 {
        self.abs()
    }
    fn greater(&self, other: &f64) -> f64 {
        if self < other || other.is_nan() { *other } else { *self }
    }
    fn over(&self, other: &f64) -> f64 {
        self / other
    }
}
