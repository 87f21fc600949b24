//! The comparison of printed decimals with exact values.

use super::decimal::{Decimal, Q, int};
use super::piece::Piece;
use super::polynomial::signum;
use super::value::Value;
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{One, Pow, Signed, Zero};

/// The rounding that leads from `value` to `decimal`: `nearest`, otherwise `cut` towards zero or
/// `away` from it, but not to one unit of the last place, or `neither`.
pub fn rounding(decimal: &Decimal, value: &Value) -> Result<&'static str, Stop> {
    rounding_on(decimal, value, None)
}

/// The rounding that leads from a polynomial on a piece to `decimal`.
pub fn rounding_on(
    decimal: &Decimal,
    value: &Value,
    piece: Option<&Piece<'_>>,
) -> Result<&'static str, Stop> {
    let (shown, unit) = (Value::from(decimal.value.clone()), Value::from(decimal.unit.clone()));
    let off = shown.minus(value)?.abs(piece)?;
    if off.plus(1, &off)?.compare_on(&unit, piece)?.is_le() {
        return Ok("nearest");
    }
    if off.compare_on(&unit, piece)?.is_ge() {
        return Ok("neither");
    }
    let less = shown.abs(None)?.compare_on(&value.abs(piece)?, piece)?.is_lt();
    Ok(match less {
        true => "cut",
        // Nobody rounds a value below half a unit away from zero to one unit.
        false if is_one_unit(decimal) => "neither",
        false => "away",
    })
}

/// Whether `value` becomes `decimal` if decimals are rounded in this way.
pub fn gives(decimal: &Decimal, value: &Value, decimals: &str) -> Result<bool, Stop> {
    let shown = Value::from(decimal.value.abs());
    let beyond = shown.compare(&value.abs(None)?)?;
    Ok(match (rounding(decimal, value)?, decimals) {
        ("neither", _) => false,
        (_, "cut") => beyond.is_le(),
        (_, "away") => beyond.is_ge(),
        (found, _) => found == "nearest",
    })
}

/// Whether a decimal is one unit of its last digit, or its negative. A fraction has none.
pub fn is_one_unit(decimal: &Decimal) -> bool {
    decimal.digits.abs().is_one() && !decimal.unit.is_zero()
}

/// Whether the end of a range may be rounded: a decimal with two digits, counted from the first that is not 0.
pub fn is_rounded(end: &Decimal) -> bool {
    !end.unit.is_zero() && !end.digits.is_zero() && end.digits.abs().to_string().len() >= 2
}

/// The digits as one integer; of a fraction those of its numerator in lowest terms.
fn integer(decimal: &Decimal) -> BigInt {
    if decimal.unit.is_zero() { decimal.value.numer().abs() } else { decimal.digits.abs() }
}

/// The number of digits without leading and trailing zeros.
pub fn telling(decimal: &Decimal) -> usize {
    integer(decimal).to_string().trim_matches('0').len()
}

/// The telling part of a number: the integer of the digits of a decimal, or of a fraction that is one, divided by 10
/// and then by 5 as often as this leaves an integer; of any other fraction its numerator, divided so by 2 and 5.
pub fn telling_part(decimal: &Decimal) -> BigInt {
    let divided = |mut number: BigInt, factor: u8| {
        let mut count = 0_u64;
        while !number.is_zero() && (&number % factor).is_zero() {
            number /= factor;
            count = count.saturating_add(1);
        }
        (number, count)
    };
    let mut part = integer(decimal);
    if decimal.unit.is_zero() {
        let (rest, twos) = divided(decimal.value.denom().clone(), 2);
        let (rest, fives) = divided(rest, 5);
        if !rest.is_one() {
            return divided(divided(part, 2).0, 5).0;
        }
        // One digit behind the point for each 10 of the denominator, and one for each 2 or 5 that is left.
        part *= BigInt::from(2).pow(fives.saturating_sub(twos));
    }
    divided(divided(part, 10).0, 5).0
}

/// Whether a decimal has enough digits for this kind of slip, or for a `rounding` that differs from
/// the rounding of the table.
pub fn has_digits(decimal: &Decimal, slip: &str) -> bool {
    let needed = match slip.split(' ').next() {
        Some("rounding") => 3,
        // The slip itself has a condition on the digits of both numbers.
        Some("exchanged") => 1,
        _ => 5,
    };
    telling(decimal) >= needed
}

/// The digits that a number needs for a slip from the value cut.
const DIGITS_FOR_CUT: usize = 6;

/// The slips `sign`, `exponent p`, `digit i` and `swap i` that lead from `value` to `decimal`, if
/// the rounding is `neither`. The number of digits matters here only for the value
/// cut.
pub fn slips(decimal: &Decimal, value: &Value) -> Result<Vec<String>, Stop> {
    let mut slips = Vec::new();
    // A slip changes a number by a factor of less than 10^5.
    if let Some(value) = value.rational()
        && magnitude(&value).abs_diff(magnitude(&decimal.value)) > 20
        && !value.is_zero()
        && !decimal.value.is_zero()
    {
        return Ok(slips);
    }
    if rounding(decimal, &value.negated()?)? != "neither" {
        slips.push("sign".to_owned());
    }
    // A fraction has no point to move, and no value was rounded to its digits.
    if decimal.unit.is_zero() {
        return Ok(slips);
    }
    for places in [-3, -2, -1, 1, 2, 3] {
        let moved = value.times(&Value::from(int(10).pow(places)))?;
        if rounding(decimal, &moved)? == "nearest" {
            slips.push(format!("exponent {places}"));
        }
    }
    if signum(&decimal.digits) != value.sign(None)? {
        return Ok(slips);
    }
    let scaled = value.over(&Value::from(decimal.unit.clone()))?.abs(None)?;
    let cut = scaled.floor()?;
    slips.extend(digit_slip(&decimal.digits.abs(), &nearest(&scaled, &cut)?));
    // With fewer digits, luck finds a digit of the cut value too often.
    if telling(decimal) >= DIGITS_FOR_CUT {
        slips.extend(digit_slip(&decimal.digits.abs(), &cut));
    }
    slips.dedup();
    Ok(slips)
}

/// The binary logarithm of a number that is not 0, up to one.
fn magnitude(value: &Q) -> i64 {
    let [numerator, denominator] = [value.numer(), value.denom()].map(|x| x.bits().cast_signed());
    numerator.saturating_sub(denominator)
}

/// The integer nearest to a number. If two are equally near, it is the even one.
fn nearest(value: &Value, floor: &BigInt) -> Result<BigInt, Stop> {
    let middle = Q::from_integer(floor.clone()) + Q::new(BigInt::one(), BigInt::from(2));
    let side = value.compare(&middle.into())?;
    let up = side.is_gt() || side.is_eq() && floor.bit(0);
    Ok(if up { floor + BigInt::one() } else { floor.clone() })
}

/// The slip that changes one digit, or exchanges two neighbouring ones. A change of the last
/// digit alone is no slip, since inexact arithmetic gives it too.
fn digit_slip(printed: &BigInt, correct: &BigInt) -> Option<String> {
    let (printed, correct) = (printed.to_string(), correct.to_string());
    match differing(&printed, &correct)[..] {
        [i] if i + 1 < printed.len() => Some(format!("digit {}", i + 1)),
        [i, _] if is_exchanged(&printed, &correct) => Some(format!("swap {}", i + 1)),
        _ => None,
    }
}

/// The places at which two texts of one length differ.
pub fn differing(typed: &str, right: &str) -> Vec<usize> {
    let (typed, right) = (typed.as_bytes(), right.as_bytes());
    if typed.len() != right.len() {
        return Vec::new();
    }
    (0..typed.len()).filter(|&at| typed[at] != right[at]).collect()
}

/// Whether two neighbouring digits are exchanged.
pub fn is_exchanged(typed: &str, right: &str) -> bool {
    let (one, other) = (typed.as_bytes(), right.as_bytes());
    matches!(differing(typed, right)[..],
        [i, j] if j == i + 1 && one[i] == other[j] && one[j] == other[i])
}

/// The ends of the interval of values that have this decimal under a rounding.
pub fn interval(decimal: &Decimal, decimals: &str) -> (Q, Q) {
    let (shown, unit) = (decimal.value.abs(), &decimal.unit);
    let half = unit / int(2);
    match decimals {
        "cut" => (shown.clone(), shown + unit),
        "away" if is_one_unit(decimal) => (half, shown),
        "away" => (&shown - unit, shown),
        _ => (&shown - &half, shown + half),
    }
}
