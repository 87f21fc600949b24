//! Integers of any size.

mod operators;
mod others;

use super::backend::{self, Int};
use super::word::{self, gcd};
use std::borrow::Cow;
use std::cmp::Ordering;
use std::fmt;

/// An integer of any size.
///
/// Integers that fit are stored as `i64`, with arithmetic at the cost of `i64`. The
/// others use the arithmetic chosen at build time: num-bigint, or GMP with the feature
/// `gmp`.
///
/// ```
/// use subcert::exact::Integer;
///
/// let a = Integer::from(2).pow(100) - Integer::from(1);
/// assert_eq!(a.to_string(), "1267650600228229401496703205375");
/// assert_eq!(Integer::from(-7).div_floor(&Integer::from(2)), Integer::from(-4));
/// ```
///
/// `/` and `%` are those of machine integers: `/` drops the fractional part, `%` leaves a remainder of the sign of the
/// dividend, and both panic where the divisor is 0. The traits of [num-traits](super::crates::num_traits) that make
/// sense hold, and integers of num-bigint and rug convert from and to this one. As text it has decimal digits, also in
/// files (serde).
///
/// ```
/// use subcert::exact::Integer;
/// use subcert::exact::crates::num_bigint::BigInt;
///
/// let theirs: BigInt = "-1267650600228229401496703205376".parse()?;
/// assert_eq!(Integer::from(theirs), -Integer::from(2).pow(100));
/// assert_eq!(Integer::from(-7) / Integer::from(2), Integer::from(-3));
/// assert_eq!(u8::try_from(Integer::from(256)).unwrap_err().to_string(), "256 does not fit into u8");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Integer(Form);

/// Each value has exactly one form, so that derived equality and hashing are right.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Form {
    Word(i64),
    /// Beyond `i64`.
    Large(Int),
}
use Form::{Large, Word};

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
        Integer::from_digits_in(digits, 10)
    }

    /// The same in base `radix`, from 2 to 36.
    pub(super) fn from_digits_in(digits: &str, radix: u32) -> Option<Integer> {
        let valid = !digits.is_empty() && digits.chars().all(|digit| digit.is_digit(radix));
        valid.then(|| backend::parse_digits(digits, radix).map(Integer::normal)).flatten()
    }

    /// Σ 2^{64i}·words\[i\].
    #[must_use]
    pub fn from_words(words: &[u64]) -> Integer {
        Integer::normal(backend::from_words(words))
    }

    /// ⌊self / divisor⌋.
    ///
    /// # Panics
    /// When `divisor` is 0.
    #[must_use]
    pub fn div_floor(&self, divisor: &Integer) -> Integer {
        assert!(!divisor.is_zero(), "division by zero");
        if let (Word(x), Word(y)) = (&self.0, &divisor.0) {
            // Of all quotients, only −2^63/−1 does not fit.
            if let Some(quotient) = x.checked_div_euclid(*y) {
                let above = *y < 0 && x.rem_euclid(*y) != 0;
                return Integer(Word(quotient - i64::from(above)));
            }
        }
        Integer::normal(backend::div_floor(&self.large(), &divisor.large()))
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
        match (&self.0, &other.0) {
            (Word(x), Word(y)) => Integer::from(gcd(x.unsigned_abs(), y.unsigned_abs())),
            // A large number and a word other than 0: one step of Euclid's algorithm
            // leaves two words.
            (Word(word), Large(large)) | (Large(large), Word(word)) if *word != 0 => {
                let word = word.unsigned_abs();
                Integer::from(gcd(word, backend::residue(large, word)))
            }
            _ => Integer::normal(backend::gcd(&self.large(), &other.large())),
        }
    }

    /// The least common multiple, never negative.
    #[must_use]
    pub fn lcm(&self, other: &Integer) -> Integer {
        if self.is_zero() || other.is_zero() {
            return Integer::zero();
        }
        (self.div_exact(&self.gcd(other)) * other).abs()
    }

    /// self^exponent, with x^0 = 1.
    #[must_use]
    pub fn pow(&self, exponent: u32) -> Integer {
        if let Word(value) = &self.0
            && let Some(power) = value.checked_pow(exponent)
        {
            return Integer(Word(power));
        }
        Integer::normal(backend::pow(&self.large(), exponent))
    }

    /// Adds a·b, for words without a product in between.
    ///
    /// ```
    /// use subcert::exact::Integer;
    ///
    /// let mut sum = Integer::from(1);
    /// sum.add_product(&Integer::from(2), &Integer::from(3));
    /// assert_eq!(sum, Integer::from(7));
    /// ```
    #[inline]
    pub fn add_product(&mut self, a: &Integer, b: &Integer) {
        if let (Word(sum), Word(x), Word(y)) = (&mut self.0, &a.0, &b.0)
            && let Some(value) = x.checked_mul(*y).and_then(|product| sum.checked_add(product))
        {
            *sum = value;
        } else {
            *self += &(a * b);
        }
    }

    /// 10^exponent.
    #[must_use]
    pub fn power_of_ten(exponent: u32) -> Integer {
        Integer::from(10).pow(exponent)
    }

    /// self·2^places.
    #[must_use]
    pub fn shifted_left(&self, places: u32) -> Integer {
        if let Word(value) = &self.0
            && places < 64
        {
            return Integer::from(i128::from(*value) << places);
        }
        Integer::normal(backend::shl(&self.large(), places))
    }

    /// ⌊self/2^places⌋.
    ///
    /// ```
    /// # use subcert::exact::Integer;
    /// assert_eq!(Integer::from(-5).shifted_right(1), Integer::from(-3));
    /// ```
    #[must_use]
    pub fn shifted_right(&self, places: u32) -> Integer {
        match &self.0 {
            Word(value) => Integer(Word(value >> places.min(63))),
            Large(value) => Integer::normal(backend::shr(value, places)),
        }
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
        let residue = match &self.0 {
            Word(value) => value.rem_euclid(modulus.into()).unsigned_abs(),
            Large(value) => backend::residue(value, modulus.into()),
        };
        u32::try_from(residue).expect("less than the modulus")
    }

    /// |self|.
    #[must_use]
    pub fn abs(&self) -> Integer {
        if self.sign() < 0 { -self } else { self.clone() }
    }

    /// −1, 0 or 1.
    #[must_use]
    pub fn sign(&self) -> i8 {
        match &self.0 {
            Word(value) => match value.cmp(&0) {
                Ordering::Less => -1,
                Ordering::Equal => 0,
                Ordering::Greater => 1,
            },
            Large(value) => backend::sign(value),
        }
    }

    /// Whether this is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.0 == Word(0)
    }

    /// Whether 2 divides this.
    #[must_use]
    pub fn is_even(&self) -> bool {
        match &self.0 {
            Word(value) => value % 2 == 0,
            Large(value) => backend::is_even(value),
        }
    }

    /// The number of binary digits of |self|; 0 for 0.
    #[must_use]
    pub fn bits(&self) -> u64 {
        match &self.0 {
            Word(value) => word::bits(*value),
            Large(value) => backend::bits(value),
        }
    }

    /// This as an `i128`, if it fits.
    #[must_use]
    pub fn to_i128(&self) -> Option<i128> {
        match &self.0 {
            Word(value) => Some(i128::from(*value)),
            Large(value) => backend::to_i128(value),
        }
    }

    /// This as an `i64`, if it fits.
    #[must_use]
    pub fn to_i64(&self) -> Option<i64> {
        if let Word(value) = self.0 { Some(value) } else { None }
    }

    /// This as an `i64`, if its absolute value is at most `cap`.
    #[must_use]
    pub fn within(&self, cap: i64) -> Option<i64> {
        word::within(self.to_i64()?, cap)
    }

    /// How often 2 divides this; `None` for 0.
    pub(super) fn trailing_zeros(&self) -> Option<u32> {
        match &self.0 {
            Word(0) => None,
            Word(value) => Some(value.trailing_zeros()),
            Large(value) => backend::trailing_zeros(value),
        }
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

impl Integer {
    /// self / divisor, which is an integer.
    pub(super) fn div_exact(&self, divisor: &Integer) -> Integer {
        match (&self.0, &divisor.0) {
            (_, Word(1)) => self.clone(),
            (Word(x), Word(y)) => Integer::from(i128::from(*x) / i128::from(*y)),
            _ => Integer::normal(backend::div_exact(&self.large(), &divisor.large())),
        }
    }

    fn normal(value: Int) -> Integer {
        Integer(backend::to_i64(&value).map_or_else(|| Large(value), Word))
    }

    fn normalise(&mut self) {
        if let Large(value) = &self.0
            && let Some(word) = backend::to_i64(value)
        {
            self.0 = Word(word);
        }
    }

    fn large(&self) -> Cow<'_, Int> {
        match &self.0 {
            Word(value) => Cow::Owned(Int::from(*value)),
            Large(value) => Cow::Borrowed(value),
        }
    }
}

impl fmt::Display for Integer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Word(value) => fmt::Display::fmt(value, f),
            Large(value) => fmt::Display::fmt(value, f),
        }
    }
}
