//! The traits of num-traits from and to numbers of the machine.

use super::convert::{exact, nearest, nearest_f32};
use crate::exact::{Integer, Rational};
use num_traits::{FromPrimitive, ToPrimitive};

/// Integers are exact, and `None` where the type does not hold them; of a rational, they are its integer part. `to_f64`
/// and `to_f32` are the [`nearest`] and [`nearest_f32`], an infinity beyond the greatest.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::exact::crates::num_traits::{FromPrimitive, ToPrimitive};
///
/// assert_eq!(Rational::new(1, 10).to_f64(), Some(0.1));
/// assert_eq!(Rational::new(-7, 2).to_i64(), Some(-3));
/// assert_eq!(Rational::from_f64(-0.375), Some(Rational::new(-3, 8)));
/// assert_eq!(Rational::from_f64(f64::NAN), None);
/// ```
impl ToPrimitive for Rational {
    fn to_i64(&self) -> Option<i64> {
        self.trunc().to_i64()
    }
    fn to_u64(&self) -> Option<u64> {
        self.trunc().to_u64()
    }
    fn to_i128(&self) -> Option<i128> {
        self.trunc().to_i128()
    }
    fn to_u128(&self) -> Option<u128> {
        self.trunc().to_u128()
    }
    fn to_f64(&self) -> Option<f64> {
        Some(nearest(self))
    }
    fn to_f32(&self) -> Option<f32> {
        Some(nearest_f32(self))
    }
}

/// As that of a [`Rational`].
impl ToPrimitive for Integer {
    fn to_i64(&self) -> Option<i64> {
        Integer::to_i64(self)
    }
    fn to_u64(&self) -> Option<u64> {
        u64::try_from(self).ok()
    }
    fn to_i128(&self) -> Option<i128> {
        Integer::to_i128(self)
    }
    fn to_u128(&self) -> Option<u128> {
        u128::try_from(self).ok()
    }
    fn to_f64(&self) -> Option<f64> {
        Rational::from(self).to_f64()
    }
    fn to_f32(&self) -> Option<f32> {
        Rational::from(self).to_f32()
    }
}

macro_rules! from_primitive {
    ($type:ident, $float:expr) => {
        impl FromPrimitive for $type {
            fn from_i64(value: i64) -> Option<$type> {
                Some(value.into())
            }
            fn from_u64(value: u64) -> Option<$type> {
                Some(value.into())
            }
            fn from_i128(value: i128) -> Option<$type> {
                Some(value.into())
            }
            fn from_u128(value: u128) -> Option<$type> {
                Some(value.into())
            }
            /// Exact; of an integer, the fractional part is dropped, as num-bigint does. `None` for NaN and the
            /// infinities.
            fn from_f64(value: f64) -> Option<$type> {
                exact(value).map($float)
            }
        }
    };
}
from_primitive!(Integer, |value| value.trunc());
from_primitive!(Rational, |value| value);
