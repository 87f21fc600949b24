//! f64 as a [`Real`]: the arithmetic of the machine.

use super::convert::nearest;
use crate::exact::{Rational, Real, Scalar};

/// Each operation is the one of IEEE 754, rounded to nearest. What is a ring only
/// up to rounding: sums depend on their order, and overflow gives infinities and
/// NaN, never a panic.
///
/// ```
/// use subcert::exact::{Rational, Scalar};
///
/// let tenth = f64::from_rational(&Rational::new(1, 10));
/// assert_eq!(f64::total(&[tenth; 10]), 0.999_999_999_999_999_9);
/// ```
impl Scalar for f64 {
    /// The nearest f64, as of a literal in source code.
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

/// NaN where a NaN takes part, also in [`Real::greater`]: a failure stays visible.
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
