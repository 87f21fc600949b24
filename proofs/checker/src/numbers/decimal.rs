//! Rational numbers and decimals as text.

#![warn(clippy::arithmetic_side_effects)]

use crate::text::Stop;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Pow, Zero};

/// A rational number.
pub type Q = BigRational;

/// The most digits of a number.
const MAX_DIGITS: usize = 10_000;

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

/// A decimal as printed.
#[derive(Clone, Debug)]
pub struct Decimal {
    /// The digits as one integer.
    pub digits: BigInt,
    /// One unit of the last digit.
    pub unit: Q,
    /// The value.
    pub value: Q,
}

/// Reads digits. A sign may precede them if `signed`.
fn digits(text: &str, signed: bool) -> Option<BigInt> {
    let digits = text.strip_prefix('-').filter(|_| signed).unwrap_or(text);
    let proper = !digits.is_empty() && digits.len() <= MAX_DIGITS;
    (proper && digits.bytes().all(|b| b.is_ascii_digit())).then(|| text.parse().ok())?
}

impl Decimal {
    /// Reads a decimal such as `-0.0266`, `4.35e-5` or `1.99×10^-10`.
    pub fn read(text: &str) -> Option<Decimal> {
        // Most decimals are short integers.
        if let Some(digits) = digits(text, false) {
            let value = Q::from_integer(digits.clone());
            return Some(Decimal { digits, unit: int(1), value });
        }
        let text = text.replace('\u{2212}', "-").replace("×10^", "e").replace("x10^", "e");
        let text = text.replace("*10^", "e").replace('E', "e");
        let (number, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        let unsigned = exponent.strip_prefix('+');
        let exponent = digits(unsigned.unwrap_or(exponent), unsigned.is_none())?;
        let exponent = capped(exponent, MAX_EXPONENT)?;
        let (whole, fraction) = number.split_once('.').unwrap_or((number, ""));
        // Digits stand on both sides of the point.
        digits(whole, true).filter(|_| !number.ends_with('.'))?;
        let place = exponent.checked_sub(i64::try_from(fraction.len()).ok()?)?;
        let unit = int(10).pow(i32::try_from(place).ok()?);
        let digits = digits(&format!("{whole}{fraction}"), true)?;
        Some(Decimal { value: &unit * &digits, digits, unit })
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
    let Some((top, bottom)) = text.split_once('/') else {
        return Decimal::read(text).map(|decimal| decimal.value);
    };
    let top = digits(&top.replace('\u{2212}', "-"), true)?;
    let bottom = digits(bottom, false).filter(|bottom| !bottom.is_zero())?;
    Some(Q::new(top, bottom))
}
