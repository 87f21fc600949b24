//! Integers of any size.

use super::backend;
use super::ops::{binary_operator, ring_basics};
use std::fmt;

/// An integer of any size.
///
/// A thin wrapper of the arithmetic chosen at build time: num-bigint, or GMP
/// with the feature `gmp`.
///
/// ```
/// use subcert::exact::Integer;
///
/// let a = Integer::from(2).pow(100) - Integer::from(1);
/// assert_eq!(a.to_string(), "1267650600228229401496703205375");
/// assert_eq!(Integer::from(-7).div_floor(&Integer::from(2)), Integer::from(-4));
/// ```
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Integer(pub(super) backend::Int);

binary_operator!(Integer, backend::Int, Add, add, AddAssign, add_assign);
binary_operator!(Integer, backend::Int, Sub, sub, SubAssign, sub_assign);
binary_operator!(Integer, backend::Int, Mul, mul, MulAssign, mul_assign);
ring_basics!(Integer, backend::Int);

impl Integer {
    /// The name of the arithmetic that this build runs on: `num-bigint` or `GMP`.
    pub const ARITHMETIC: &'static str = backend::NAME;

    /// 0.
    #[must_use]
    pub fn zero() -> Integer {
        Integer::from(0)
    }

    /// 1.
    #[must_use]
    pub fn one() -> Integer {
        Integer::from(1)
    }

    /// The integer with these decimal digits and no sign; `None` unless
    /// `digits` is one or more of `0`…`9`.
    #[must_use]
    pub fn from_digits(digits: &str) -> Option<Integer> {
        let valid = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
        valid.then(|| backend::parse_digits(digits).map(Integer)).flatten()
    }

    /// Σ 2^{64i}·words[i].
    pub(crate) fn from_words(words: &[u64]) -> Integer {
        Integer(backend::from_words(words))
    }

    /// ⌊self / divisor⌋.
    ///
    /// # Panics
    /// When `divisor` is 0.
    #[must_use]
    pub fn div_floor(&self, divisor: &Integer) -> Integer {
        assert!(!divisor.is_zero(), "division by zero");
        Integer(backend::div_floor(&self.0, &divisor.0))
    }

    /// ⌊self / divisor⌋ and the remainder, which has the sign of `divisor`.
    ///
    /// # Panics
    /// When `divisor` is 0.
    #[must_use]
    pub fn div_rem_floor(&self, divisor: &Integer) -> (Integer, Integer) {
        let quotient = self.div_floor(divisor);
        let remainder = self - &quotient * divisor;
        (quotient, remainder)
    }

    /// The greatest common divisor, never negative.
    #[must_use]
    pub fn gcd(&self, other: &Integer) -> Integer {
        Integer(backend::gcd(&self.0, &other.0))
    }

    /// The least common multiple, never negative.
    #[must_use]
    pub fn lcm(&self, other: &Integer) -> Integer {
        if self.is_zero() || other.is_zero() {
            return Integer::zero();
        }
        (self.div_floor(&self.gcd(other)) * other).abs()
    }

    /// self^exponent, with x^0 = 1.
    #[must_use]
    pub fn pow(&self, exponent: u32) -> Integer {
        Integer(backend::pow(&self.0, exponent))
    }

    /// 10^exponent.
    #[must_use]
    pub fn power_of_ten(exponent: u32) -> Integer {
        Integer::from(10).pow(exponent)
    }

    /// self·2^places.
    #[must_use]
    pub fn shifted_left(&self, places: u32) -> Integer {
        Integer(backend::shl(&self.0, places))
    }

    /// ⌊self/2^places⌋.
    ///
    /// ```
    /// # use subcert::exact::Integer;
    /// assert_eq!(Integer::from(-5).shifted_right(1), Integer::from(-3));
    /// ```
    #[must_use]
    pub fn shifted_right(&self, places: u32) -> Integer {
        Integer(backend::shr(&self.0, places))
    }

    /// self mod `modulus`, from 0 to `modulus` − 1.
    ///
    /// # Panics
    /// When `modulus` is 0.
    ///
    /// ```
    /// # use subcert::exact::Integer;
    /// assert_eq!(Integer::from(-5).residue(3), 1);
    /// ```
    #[must_use]
    pub fn residue(&self, modulus: u32) -> u32 {
        assert!(modulus > 0, "division by zero");
        backend::residue(&self.0, modulus)
    }

    /// |self|.
    #[must_use]
    pub fn abs(&self) -> Integer {
        Integer(backend::abs(&self.0))
    }

    /// −1, 0 or 1.
    #[must_use]
    pub fn sign(&self) -> i8 {
        backend::sign(&self.0)
    }

    /// Whether this is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.sign() == 0
    }

    /// Whether 2 divides this.
    #[must_use]
    pub fn is_even(&self) -> bool {
        backend::is_even(&self.0)
    }

    /// The number of binary digits of |self|; 0 for 0.
    #[must_use]
    pub fn bits(&self) -> u64 {
        backend::bits(&self.0)
    }

    /// This as an `i128`, if it fits.
    #[must_use]
    pub fn to_i128(&self) -> Option<i128> {
        backend::to_i128(&self.0)
    }

    /// This as an `i64`, if it fits.
    #[must_use]
    pub fn to_i64(&self) -> Option<i64> {
        self.to_i128().and_then(|value| i64::try_from(value).ok())
    }

    /// The binomial coefficient C(top, bottom); 0 when `bottom` > `top`.
    ///
    /// ```
    /// # use subcert::exact::Integer;
    /// assert_eq!(Integer::binomial(10, 3), Integer::from(120));
    /// ```
    #[must_use]
    pub fn binomial(top: u32, bottom: u32) -> Integer {
        if bottom > top {
            return Integer::zero();
        }
        let bottom = bottom.min(top - bottom);
        (0..bottom).fold(Integer::one(), |value, i| {
            (value * Integer::from(top - i)).div_floor(&Integer::from(i + 1))
        })
    }
}

macro_rules! from_machine {
    ($($type:ty),*) => {$(
        impl From<$type> for Integer {
            fn from(value: $type) -> Integer {
                Integer(backend::Int::from(value))
            }
        }
    )*};
}
from_machine!(i32, u32, i64, u64, i128, usize);

impl fmt::Display for Integer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}
