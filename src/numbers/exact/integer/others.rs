//! Integers of other types: of the machine, of num-bigint, and of rug.

use super::Form::{Large, Word};
use super::Integer;
use crate::exact::{ConversionError, backend};
use num_bigint::BigInt;

/// Clones, so that `impl Into` accepts references.
impl From<&Integer> for Integer {
    fn from(value: &Integer) -> Integer {
        value.clone()
    }
}

impl From<BigInt> for Integer {
    fn from(value: BigInt) -> Integer {
        Integer::normal(backend::from_big(value))
    }
}

impl From<&BigInt> for Integer {
    fn from(value: &BigInt) -> Integer {
        Integer::from(value.clone())
    }
}

impl From<Integer> for BigInt {
    fn from(value: Integer) -> BigInt {
        BigInt::from(&value)
    }
}

impl From<&Integer> for BigInt {
    fn from(value: &Integer) -> BigInt {
        match &value.0 {
            Word(word) => BigInt::from(*word),
            Large(large) => backend::to_big(large),
        }
    }
}

#[cfg(feature = "gmp")]
impl From<rug::Integer> for Integer {
    fn from(value: rug::Integer) -> Integer {
        Integer::normal(value)
    }
}

#[cfg(feature = "gmp")]
impl From<&rug::Integer> for Integer {
    fn from(value: &rug::Integer) -> Integer {
        Integer::normal(value.clone())
    }
}

#[cfg(feature = "gmp")]
impl From<Integer> for rug::Integer {
    fn from(value: Integer) -> rug::Integer {
        value.large().into_owned()
    }
}

#[cfg(feature = "gmp")]
impl From<&Integer> for rug::Integer {
    fn from(value: &Integer) -> rug::Integer {
        value.large().into_owned()
    }
}

macro_rules! into_machine {
    ($($type:ty),*) => {$(
        impl TryFrom<Integer> for $type {
            type Error = ConversionError;
            fn try_from(value: Integer) -> Result<$type, ConversionError> {
                <$type>::try_from(&value)
            }
        }
        impl TryFrom<&Integer> for $type {
            type Error = ConversionError;
            fn try_from(value: &Integer) -> Result<$type, ConversionError> {
                let fits = match &value.0 {
                    Word(word) => <$type>::try_from(*word).ok(),
                    Large(large) => <$type>::try_from(backend::to_big(large)).ok(),
                };
                fits.ok_or_else(|| ConversionError::new(value.clone(), stringify!($type)))
            }
        }
    )*};
}
into_machine!(i8, u8, i16, u16, i32, u32, i64, u64, i128, u128, isize, usize);
