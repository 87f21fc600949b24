//! f64 as hexadecimal text, without any rounding.

use super::convert::{binary, nearest, parts};
use crate::exact::{Integer, Rational, within};

/// The greatest number of hexadecimal digits.
const MAX_HEX_DIGITS: usize = 2_000;

/// The largest absolute value of the binary exponent.
const MAX_BINARY_EXPONENT: i64 = 20_000;

/// Why a text is not a hexadecimal float.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum HexadecimalError {
    /// The text does not have the form `[-]0xh.hhhp±d`.
    #[error("`{0}` is not a hexadecimal float; write one such as -0x1.8p-3, inf or nan")]
    Form(String),
    /// The text has too many digits, or too large an exponent.
    #[error(
        "a hexadecimal float beyond the caps: at most {MAX_HEX_DIGITS} digits and an exponent \
         up to {MAX_BINARY_EXPONENT}"
    )]
    TooLong,
}

/// `value` as the conversion `%a` of C99 prints it: `0x1.8p-3`, with a leading 1
/// for normal numbers and 0 for subnormal ones, without trailing zeros, the binary
/// exponent always signed; `inf`, `-inf` and `nan`.
///
/// ```
/// use subcert::float::hexadecimal;
///
/// assert_eq!(hexadecimal(0.1), "0x1.999999999999ap-4");
/// assert_eq!(hexadecimal(-1.0), "-0x1p+0");
/// assert_eq!(hexadecimal(f64::from_bits(1)), "0x0.0000000000001p-1022");
/// ```
#[must_use]
pub fn hexadecimal(value: f64) -> String {
    let sign = if value.is_sign_negative() { "-" } else { "" };
    if value.is_nan() {
        return "nan".to_owned();
    }
    if value.is_infinite() {
        return format!("{sign}inf");
    }
    let (mantissa, exponent) = parts(value);
    let exponent = if mantissa == 0 { 0 } else { exponent + 52 };
    let digits = format!("{:013x}", mantissa & ((1 << 52) - 1));
    let digits = digits.trim_end_matches('0');
    let point = if digits.is_empty() { "" } else { "." };
    format!("{sign}0x{}{point}{digits}p{exponent:+}", mantissa >> 52)
}

/// Reads the text of [`hexadecimal`], and any `[±]0xhh.hhhp±d` (in upper or lower case,
/// with or without the exponent), `inf` or `nan`. A number with more digits than an f64
/// is rounded to the nearest f64.
///
/// # Errors
/// When the text has another form, or exceeds the caps.
///
/// ```
/// use subcert::float::parse_hexadecimal;
///
/// assert_eq!(parse_hexadecimal("0x1.8p-3")?, 0.1875);
/// assert_eq!(parse_hexadecimal("-0X18P-7")?, -0.1875);
/// assert!(parse_hexadecimal("1.8p-3").is_err());
/// # Ok::<(), subcert::float::HexadecimalError>(())
/// ```
pub fn parse_hexadecimal(text: &str) -> Result<f64, HexadecimalError> {
    let form = || HexadecimalError::Form(text.chars().take(80).collect());
    let (negative, rest) = match text.strip_prefix(['-', '+']) {
        Some(rest) => (text.starts_with('-'), rest),
        None => (false, text),
    };
    let magnitude = match rest {
        "inf" => f64::INFINITY,
        "nan" => f64::NAN,
        _ => {
            let body = rest.strip_prefix("0x").or_else(|| rest.strip_prefix("0X"));
            nearest(&magnitude(body.ok_or_else(form)?)?.ok_or_else(form)?)
        }
    };
    Ok(if negative { -magnitude } else { magnitude })
}

/// The value of a text `hh.hhhp±d`; `Ok(None)` when the text has another form.
fn magnitude(body: &str) -> Result<Option<Rational>, HexadecimalError> {
    let (digits, power) = match body.split_once(['p', 'P']) {
        Some((digits, power)) => (digits, Some(power)),
        None => (body, None),
    };
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let count = whole.len() + fraction.len();
    if count > MAX_HEX_DIGITS {
        return Err(HexadecimalError::TooLong);
    }
    let mut mantissa = Integer::zero();
    for digit in whole.chars().chain(fraction.chars()) {
        let Some(digit) = digit.to_digit(16) else { return Ok(None) };
        mantissa = mantissa * Integer::from(16) + Integer::from(digit);
    }
    let Some(power) = power.map_or(Ok(Some(0)), exponent)? else { return Ok(None) };
    let places = i64::try_from(fraction.len()).expect("capped");
    Ok((count > 0).then(|| binary(mantissa, power - 4 * places)))
}

/// A signed decimal integer; `Ok(None)` when the text has another form.
fn exponent(text: &str) -> Result<Option<i64>, HexadecimalError> {
    let digits = text.strip_prefix(['-', '+']).unwrap_or(text);
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return Ok(None);
    }
    let size = digits.parse().ok().and_then(|size| within(size, MAX_BINARY_EXPONENT));
    let size = size.ok_or(HexadecimalError::TooLong)?;
    Ok(Some(if text.starts_with('-') { -size } else { size }))
}
