//! Rational numbers of other types: integers of the machine, and numbers of num-bigint, num-rational and rug.

use super::Rational;
use crate::exact::{ConversionError, Integer};
use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};

macro_rules! from_integers {
    ($($type:ty),*) => {$(
        impl From<$type> for Rational {
            fn from(value: $type) -> Rational {
                Rational::from(Integer::from(value))
            }
        }
    )*};
}
from_integers!(i8, u8, i16, u16, i32, u32, i64, u64, i128, u128, isize, usize, BigInt, &BigInt);
#[cfg(feature = "gmp")]
from_integers!(rug::Integer, &rug::Integer);

/// A `BigRational`, or a `Ratio` of machine integers.
///
/// # Panics
/// When the denominator is 0, which only `Ratio::new_raw` makes.
impl<T: Into<Integer>> From<Ratio<T>> for Rational {
    fn from(value: Ratio<T>) -> Rational {
        let (p, q) = value.into_raw();
        Rational::new(p, q)
    }
}

/// As that of the value.
impl<T: Clone + Into<Integer>> From<&Ratio<T>> for Rational {
    fn from(value: &Ratio<T>) -> Rational {
        Rational::new(value.numer().clone(), value.denom().clone())
    }
}

impl From<Rational> for BigRational {
    fn from(value: Rational) -> BigRational {
        BigRational::from(&value)
    }
}

impl From<&Rational> for BigRational {
    fn from(value: &Rational) -> BigRational {
        // Both have lowest terms and a positive denominator.
        Ratio::new_raw(BigInt::from(value.numerator()), BigInt::from(value.denominator()))
    }
}

macro_rules! into_ratio {
    ($($type:ty),*) => {$(
        impl TryFrom<Rational> for Ratio<$type> {
            type Error = ConversionError;
            fn try_from(value: Rational) -> Result<Ratio<$type>, ConversionError> {
                Ratio::try_from(&value)
            }
        }
        impl TryFrom<&Rational> for Ratio<$type> {
            type Error = ConversionError;
            fn try_from(value: &Rational) -> Result<Ratio<$type>, ConversionError> {
                let word = |part| <$type>::try_from(part);
                match (word(value.numerator()), word(value.denominator())) {
                    (Ok(p), Ok(q)) => Ok(Ratio::new_raw(p, q)),
                    _ => Err(ConversionError::new(value, concat!("Ratio<", stringify!($type), ">"))),
                }
            }
        }
    )*};
}
into_ratio!(i32, i64, i128, isize);

impl TryFrom<Rational> for Integer {
    type Error = ConversionError;
    fn try_from(value: Rational) -> Result<Integer, ConversionError> {
        Integer::try_from(&value)
    }
}

impl TryFrom<&Rational> for Integer {
    type Error = ConversionError;
    fn try_from(value: &Rational) -> Result<Integer, ConversionError> {
        if value.is_integer() {
            Ok(value.numerator())
        } else {
            Err(ConversionError::new(value, "Integer"))
        }
    }
}

#[cfg(feature = "gmp")]
impl From<rug::Rational> for Rational {
    fn from(value: rug::Rational) -> Rational {
        let (p, q) = value.into_numer_denom();
        Rational::of(p.into(), q.into())
    }
}

#[cfg(feature = "gmp")]
impl From<&rug::Rational> for Rational {
    fn from(value: &rug::Rational) -> Rational {
        Rational::from(value.clone())
    }
}

#[cfg(feature = "gmp")]
impl From<Rational> for rug::Rational {
    fn from(value: Rational) -> rug::Rational {
        rug::Rational::from(&value)
    }
}

#[cfg(feature = "gmp")]
impl From<&Rational> for rug::Rational {
    fn from(value: &Rational) -> rug::Rational {
        let part = rug::Integer::from;
        rug::Rational::from((part(value.numerator()), part(value.denominator())))
    }
}
