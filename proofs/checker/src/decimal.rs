//! Rational numbers and decimals as text.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

/// A rational number.
pub type Q = BigRational;

/// An integer as a rational number.
pub fn int(value: i64) -> Q {
    Q::from_integer(value.into())
}

/// 10^places.
pub fn power_of_ten(places: i64) -> Q {
    let power = BigInt::from(10).pow(u32::try_from(places.unsigned_abs()).unwrap_or(u32::MAX));
    if places < 0 { Q::new(BigInt::one(), power) } else { Q::from_integer(power) }
}

/// A decimal as printed: all its digits as one integer, and the place of the last.
#[derive(Clone, Debug)]
pub struct Decimal {
    /// The digits.
    pub digits: BigInt,
    /// The power of ten of the last digit.
    pub place: i64,
}

impl Decimal {
    /// Reads `-0.0266`, `4.35e-5`, `1.99×10^-10`; nothing else.
    pub fn read(text: &str) -> Option<Decimal> {
        let negative = text.starts_with(['-', '\u{2212}']);
        let rest = text.trim_start_matches('\u{2212}');
        let rest = if text.starts_with('-') { &rest[1..] } else { rest };
        let mark = ["e", "E", "×10^", "x10^", "*10^"].iter().find(|mark| rest.contains(**mark));
        let (number, exponent) = match mark {
            Some(mark) => rest.split_once(*mark)?,
            None => (rest, "0"),
        };
        let (whole, fraction) = number.split_once('.').unwrap_or((number, "0"));
        let fraction = if number.contains('.') { fraction } else { "" };
        let minus = exponent.starts_with(['-', '\u{2212}']);
        let power = exponent.strip_prefix(['-', '\u{2212}', '+']).unwrap_or(exponent);
        let is_digits = |text: &str| text.bytes().all(|b| b.is_ascii_digit());
        let proper = !whole.is_empty() && !power.is_empty() && text.len() <= 10_000;
        let proper = proper && !(number.contains('.') && fraction.is_empty());
        if !proper || text.starts_with("\u{2212}\u{2212}") {
            return None;
        }
        if ![whole, fraction, power].into_iter().all(is_digits) {
            return None;
        }
        let power: i64 = power.parse().ok().filter(|power| *power <= 10_000)?;
        let digits: BigInt = format!("{whole}{fraction}").parse().ok()?;
        let place = if minus { -power } else { power } - i64::try_from(fraction.len()).ok()?;
        Some(Decimal { digits: if negative { -digits } else { digits }, place })
    }

    /// Its value.
    pub fn value(&self) -> Q {
        Q::from_integer(self.digits.clone()) * self.unit()
    }

    /// One unit of its last place.
    pub fn unit(&self) -> Q {
        power_of_ten(self.place)
    }
}

/// Reads `-35/1296` or a decimal.
pub fn read_rational(text: &str) -> Option<Q> {
    let Some((top, bottom)) = text.split_once('/') else {
        return Decimal::read(text).map(|decimal| decimal.value());
    };
    let whole = |text: &str| text.bytes().all(|b| b.is_ascii_digit()) && text.len() <= 10_000;
    let digits = top.strip_prefix(['-', '\u{2212}']).unwrap_or(top);
    if digits.is_empty() || !whole(digits) || !whole(bottom) {
        return None;
    }
    let (top_value, bottom): (BigInt, BigInt) = (digits.parse().ok()?, bottom.parse().ok()?);
    let value = (!bottom.is_zero()).then(|| Q::new(top_value, bottom))?;
    Some(if digits.len() < top.len() { -value } else { value })
}
