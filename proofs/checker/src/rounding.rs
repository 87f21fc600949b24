//! Printed decimals against exact values.

use crate::decimal::{Decimal, Q, int, power_of_ten};
use crate::number::Number;
use crate::value::{Stop, Value};
use num_bigint::BigInt;
use num_traits::{One, Signed};

/// How a decimal came from a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// It is a decimal of its length that is nearest to the value.
    Nearest,
    /// Not that, but cut towards zero.
    Cut,
    /// Not that, but rounded away from zero.
    Away,
    /// A unit of its last place off, or more.
    Neither,
}

fn sign(value: &Value) -> Result<i8, Stop> {
    value.sign(None)
}

/// How `decimal` came from `value`.
pub fn rounding(decimal: &Decimal, value: &Value) -> Result<Rounding, Stop> {
    let (shown, unit) = (Value::from(decimal.value()), Value::from(decimal.unit()));
    let off = shown.plus(-1, value)?.abs(None)?;
    if sign(&off.plus(1, &off)?.plus(-1, &unit)?)? <= 0 {
        return Ok(Rounding::Nearest);
    }
    if sign(&off.plus(-1, &unit)?)? >= 0 {
        return Ok(Rounding::Neither);
    }
    let less = sign(&shown.abs(None)?.plus(-1, &value.abs(None)?)?)? < 0;
    Ok(if less { Rounding::Cut } else { Rounding::Away })
}

/// Whether `value` becomes `decimal` where decimals are rounded in this way.
pub fn gives(decimal: &Decimal, value: &Value, decimals: &str) -> Result<bool, Stop> {
    let found = rounding(decimal, value)?;
    let shown = Value::from(decimal.value()).abs(None)?;
    let beyond = sign(&shown.plus(-1, &value.abs(None)?)?)?;
    Ok(found != Rounding::Neither
        && match decimals {
            "cut" => beyond <= 0,
            "away" => beyond >= 0,
            _ => found == Rounding::Nearest,
        })
}

/// The digits of a decimal that tell something: without zeros before and behind.
fn telling(decimal: &Decimal) -> usize {
    decimal.digits.abs().to_string().trim_matches('0').len()
}

/// Whether a decimal has the digits that this kind of slip needs; or `rounding`, not as the
/// rest of the table.
pub fn has_digits(decimal: &Decimal, slip: &str) -> bool {
    let needed = match slip.split(' ').next() {
        Some("digit" | "swap") => 5,
        Some("rounding") => 3,
        _ => 4,
    };
    telling(decimal) >= needed
}

/// The slips that lead from `value` to `decimal`, when that is `Neither`: `sign`,
/// `exponent p`, `digit i`, `swap i`, whatever their number of digits.
pub fn slips(decimal: &Decimal, value: &Value) -> Result<Vec<String>, Stop> {
    let mut slips = Vec::new();
    if rounding(decimal, &Value::int(0).plus(-1, value)?)? != Rounding::Neither {
        slips.push("sign".to_owned());
    }
    for places in [-3, -2, -1, 1, 2, 3] {
        let moved = value.times(&Value::from(power_of_ten(places)))?;
        if rounding(decimal, &moved)? == Rounding::Nearest {
            slips.push(format!("exponent {places}"));
        }
    }
    if sign(&Value::from(decimal.value()))? != sign(value)? {
        return Ok(slips);
    }
    let scaled = value.over(&Value::from(decimal.unit()))?.abs(None)?;
    let cut = scaled.floor()?;
    for correct in [nearest(&scaled, &cut)?, cut] {
        slips.extend(digit_slip(&decimal.digits.abs(), &correct));
    }
    slips.dedup();
    Ok(slips)
}

/// The integer nearest to a number; of two, the even one.
fn nearest(value: &Value, floor: &BigInt) -> Result<BigInt, Stop> {
    let middle = Q::from_integer(floor.clone()) + Q::new(BigInt::one(), BigInt::from(2));
    let up = match sign(&value.plus(-1, &Value::Number(Number::from(middle)))?)? {
        0 => floor.bit(0),
        sign => sign > 0,
    };
    Ok(if up { floor + BigInt::one() } else { floor.clone() })
}

/// One digit that is another, or two neighbours exchanged. The last digit alone is none:
/// inexact computing gives that too.
fn digit_slip(printed: &BigInt, correct: &BigInt) -> Option<String> {
    let (printed, correct) = (printed.to_string().into_bytes(), correct.to_string().into_bytes());
    if printed.len() != correct.len() {
        return None;
    }
    let differing: Vec<usize> = (0..printed.len()).filter(|&i| printed[i] != correct[i]).collect();
    match differing[..] {
        [i] if i + 1 < printed.len() => Some(format!("digit {}", i + 1)),
        [i, j] if j == i + 1 && printed[i] == correct[j] && printed[j] == correct[i] => {
            Some(format!("swap {}", i + 1))
        }
        _ => None,
    }
}

/// The ends of the interval of values that a decimal stands for in this rounding.
pub fn interval(decimal: &Decimal, decimals: &str) -> (Q, Q) {
    let (shown, unit) = (decimal.value().abs(), decimal.unit());
    let half = &unit / int(2);
    match decimals {
        "cut" => (shown.clone(), shown + unit),
        "away" => (&shown - unit, shown),
        _ => (&shown - &half, shown + half),
    }
}
