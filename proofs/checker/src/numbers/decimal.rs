//! Rational numbers and decimals as text.

#![warn(clippy::arithmetic_side_effects)]

use crate::text::Stop;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Pow, Zero};
use std::ops::Neg;

/// A rational number.
pub type Q = BigRational;

/// The most digits of a number: as many as a value of 500,000 binary digits has.
const MAX_DIGITS: usize = 150_516;

/// The greatest exponent.
const MAX_EXPONENT: i64 = 1_000;

/// The most binary digits of a common denominator.
const MAX_BITS: u64 = 1 << 16;

/// An integer as a rational number.
pub fn int(value: i64) -> Q {
    Q::from_integer(value.into())
}

/// A count as a rational number.
pub fn count(value: usize) -> Q {
    Q::from_integer(value.into())
}

/// An integer from −cap to cap.
pub fn capped(integer: impl TryInto<i64>, cap: i64) -> Option<i64> {
    integer.try_into().ok().filter(|integer: &i64| integer.unsigned_abs() <= cap.unsigned_abs())
}

/// The binary digits of the numerator and the denominator.
pub fn bits(value: &Q) -> u64 {
    [value.numer(), value.denom()].into_iter().map(BigInt::bits).sum()
}

/// A decimal or a fraction as printed.
#[derive(Clone, Debug)]
pub struct Decimal {
    /// The digits as one integer; the numerator of a fraction.
    pub digits: BigInt,
    /// One unit of the last digit; 0 of a fraction, to which nothing is rounded.
    pub unit: Q,
    /// The value.
    pub value: Q,
}

/// Reads digits.
fn digits(text: &str) -> Option<BigInt> {
    let proper = !text.is_empty() && text.len() <= MAX_DIGITS;
    (proper && text.bytes().all(|b| b.is_ascii_digit())).then(|| text.parse().ok())?
}

/// The characters that are fractions, with numerator and denominator.
const FRACTIONS: &str = "½12 ⅓13 ⅔23 ¼14 ¾34 ⅕15 ⅖25 ⅗35 ⅘45 ⅙16 ⅚56 ⅐17 ⅛18 ⅜38 ⅝58 ⅞78 ⅑19 ↉03";

/// The fraction that this character is.
fn one_character(c: char) -> Option<(BigInt, BigInt)> {
    if c == '⅒' {
        return Some((1.into(), 10.into()));
    }
    let found = FRACTIONS.split(' ').find_map(|entry| entry.strip_prefix(c))?;
    Some((digits(found.get(..1)?)?, digits(found.get(1..)?)?))
}

/// Whether this character is a fraction.
pub fn is_fraction(c: char) -> bool {
    c == '⅒' || !c.is_ascii() && FRACTIONS.contains(c)
}

/// Whether nothing is printed: up to three dashes of one kind, or none.
pub fn is_blank(text: &str) -> bool {
    let dashes: Vec<char> = text.trim().chars().collect();
    let dash = dashes.first().is_none_or(|c| "-\u{2212}\u{2013}\u{2014}".contains(*c));
    dash && dashes.len() <= 3 && dashes.iter().all(|c| dashes.first() == Some(c))
}

/// Whether a minus stands before a number, and the number without a sign.
fn sign(text: &str) -> (bool, &str) {
    match text.strip_prefix(['-', '\u{2212}', '\u{2013}']) {
        Some(rest) => (true, rest.trim_start()),
        None => (false, text.strip_prefix('+').map_or(text, str::trim_start)),
    }
}

/// The number, or its negative.
fn signed<T: Neg<Output = T>>(negative: bool, value: T) -> T {
    if negative { value.neg() } else { value }
}

impl Decimal {
    /// Reads a decimal such as `-0.0266`, `+.5`, `4.35e-5` or `1.99×10^-10`. Blanks may stand around it, behind its sign and
    /// around `×`.
    pub fn read(text: &str) -> Option<Decimal> {
        // Most decimals are short integers.
        if let Some(digits) = digits(text) {
            let value = Q::from_integer(digits.clone());
            return Some(Decimal { digits, unit: int(1), value });
        }
        let (negative, text) = sign(text.trim());
        let times = |mark: &'static str| {
            let (number, power) = text.split_once(mark)?;
            Some((number.trim_end(), power.trim_start().strip_prefix("10^")?))
        };
        let power = ["×", "x", "*", "·"].into_iter().find_map(times);
        let power = power.or_else(|| text.split_once(['e', 'E']));
        let (number, exponent) = power.unwrap_or((text, "0"));
        let (down, exponent) = sign(exponent);
        let exponent = capped(signed(down, digits(exponent)?), MAX_EXPONENT)?;
        let (whole, fraction) = number.split_once('.').unwrap_or((number, ""));
        let place = exponent.checked_sub(i64::try_from(fraction.len()).ok()?)?;
        let unit = int(10).pow(i32::try_from(place).ok()?);
        // Digits stand on one side of the point at least.
        let digits = signed(negative, digits(&format!("{whole}{fraction}"))?);
        Some(Decimal { value: &unit * &digits, digits, unit })
    }

    /// Reads a decimal, or a fraction such as `-35/1296`, `½` or `1½`.
    pub fn printed(text: &str) -> Option<Decimal> {
        Decimal::fraction(text).or_else(|| Decimal::read(text))
    }

    /// The same number with all digits before the point: `1e1` as `10`.
    pub fn whole(self) -> Decimal {
        if self.unit <= int(1) {
            return self;
        }
        Decimal { digits: self.value.to_integer(), unit: int(1), value: self.value }
    }

    fn fraction(text: &str) -> Option<Decimal> {
        let (negative, text) = sign(text.trim());
        let last = text.chars().next_back()?;
        let (top, bottom) = if let Some((top, bottom)) = one_character(last) {
            let whole = text.strip_suffix(last)?;
            let whole = if whole.is_empty() { BigInt::zero() } else { digits(whole)? };
            (whole * &bottom + top, bottom)
        } else {
            let (top, bottom) = text.split_once(['/', '\u{2044}', '\u{2215}'])?;
            (digits(top.trim_end())?, digits(bottom.trim_start())?)
        };
        let value = (!bottom.is_zero()).then(|| Q::new(top.clone(), bottom))?;
        let (digits, value) = (signed(negative, top), signed(negative, value));
        Some(Decimal { digits, unit: int(0), value })
    }
}

/// The least common multiple.
pub fn common_multiple<'i>(numbers: impl IntoIterator<Item = &'i BigInt>) -> Result<BigInt, Stop> {
    numbers.into_iter().try_fold(BigInt::one(), |common, number| {
        let common = common.lcm(number);
        let fits = common.bits() <= MAX_BITS;
        fits.then_some(common).ok_or(Stop::Capped("the size of a common denominator"))
    })
}

/// Writes rows as integers over one denominator.
pub fn over_one_denominator(rows: &[Vec<Q>]) -> Result<(Vec<Vec<BigInt>>, BigInt), Stop> {
    let over = common_multiple(rows.iter().flatten().map(Q::denom))?;
    let integer = |x: &Q| x.numer() * (&over / x.denom());
    Ok((rows.iter().map(|row| row.iter().map(integer).collect()).collect(), over))
}

/// Reads a fraction such as `-35/1296`, or a decimal.
pub fn read_rational(text: &str) -> Option<Q> {
    Decimal::printed(text).map(|decimal| decimal.value)
}
