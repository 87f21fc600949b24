//! Correctly rounded decimals of exact values, rational or not.
//!
//! Every function rounds to the nearest decimal of the requested length; a tie goes to
//! the even last digit. The enclosure of an irrational value is refined until both its
//! ends round to the same decimal.

use crate::exact::{Enclosed, Integer, Rational};

/// `value` with `places` digits after the point.
///
/// ```
/// use subcert::exact::{Rational, format::fixed};
///
/// assert_eq!(fixed(&Rational::new(-2, 3), 4), "-0.6667");
/// assert_eq!(fixed(&Rational::new(5, 2), 0), "2");
/// ```
#[must_use]
pub fn fixed(value: &impl Enclosed, places: u32) -> String {
    value.step(|value| fixed_rational(value, places))
}

fn fixed_rational(value: &Rational, places: u32) -> String {
    let scaled = (value * Rational::from(Integer::power_of_ten(places))).round_half_even();
    let digits = scaled.abs().to_string();
    let places = places as usize;
    let padded = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = padded.split_at(padded.len() - places);
    let sign = if scaled.sign() < 0 { "-" } else { "" };
    if places == 0 { format!("{sign}{whole}") } else { format!("{sign}{whole}.{fraction}") }
}

/// `value` with `digits` significant digits, as `d.ddde-7`.
///
/// ```
/// use subcert::exact::{Rational, format::scientific};
///
/// assert_eq!(scientific(&Rational::new(1, 3000), 3), "3.33e-4");
/// assert_eq!(scientific(&Rational::new(9996, 10_000), 3), "1.00e0");
/// ```
///
/// # Panics
/// When `digits` is 0.
#[must_use]
pub fn scientific(value: &impl Enclosed, digits: u32) -> String {
    value.step(|value| scientific_rational(value, digits))
}

fn scientific_rational(value: &Rational, digits: u32) -> String {
    let (mantissa, exponent) = significant(value, digits);
    let sign = if mantissa.sign() < 0 { "-" } else { "" };
    let text = mantissa.abs().to_string();
    let text = format!("{text:0<width$}", width = digits as usize);
    let (first, rest) = text.split_at(1);
    let point = if rest.is_empty() { "" } else { "." };
    format!("{sign}{first}{point}{rest}e{exponent}")
}

/// `value` with up to `digits` significant digits, in plain notation if the exponent of
/// ten of the first digit is from −5 to max(`digits`, 6), and otherwise in scientific
/// notation. Trailing zeros after the point are left out.
///
/// ```
/// use subcert::exact::{Rational, format::short};
///
/// assert_eq!(short(&Rational::new(3, 8), 6), "0.375");
/// assert_eq!(short(&Rational::new(1, 3), 6), "0.333333");
/// assert_eq!(short(&Rational::new(1, 3_000_000), 6), "3.33333e-7");
/// ```
///
/// # Panics
/// When `digits` is 0.
#[must_use]
pub fn short(value: &impl Enclosed, digits: u32) -> String {
    value.step(|value| short_rational(value, digits))
}

/// The least decimal with `places` digits after the point that is not below `value`; for negative `places`, the least
/// multiple of 10^−places.
///
/// ```
/// use subcert::exact::{Rational, format::raised};
///
/// assert_eq!(raised(&Rational::new(12_841, 1_000_000), 4), Rational::new(129, 10_000));
/// assert_eq!(raised(&Rational::new(1, 4), 2), Rational::new(1, 4));
/// ```
#[must_use]
pub fn raised(value: &impl Enclosed, places: i32) -> Rational {
    let unit = Rational::power_of_ten(places);
    value.step(|value| Rational::from((value * &unit).ceil()) / &unit)
}

/// The least decimal with `digits` significant digits that is not below `value`.
///
/// ```
/// use subcert::exact::{Rational, format::{raised_digits, short}};
///
/// assert_eq!(short(&raised_digits(&Rational::new(1, 3000), 3), 3), "0.000334");
/// ```
#[must_use]
pub fn raised_digits(value: &impl Enclosed, digits: u32) -> Rational {
    let exponent = |value: &Rational| if value.is_zero() { 0 } else { floor_log10(&value.abs()) };
    raised(value, clamp_exponent(i64::from(digits) - 1 - value.step(exponent)))
}

fn short_rational(value: &Rational, digits: u32) -> String {
    if value.is_zero() {
        return "0".to_owned();
    }
    let (mantissa, exponent) = significant(value, digits);
    let plain = (-5..=i64::from(digits).max(6)).contains(&exponent);
    if !plain {
        let text = scientific_rational(value, digits);
        return match text.split_once('e') {
            Some((number, power)) => format!("{}e{power}", trim_zeros(number)),
            None => text,
        };
    }
    let rounded = Rational::from(mantissa)
        * Rational::power_of_ten(clamp_exponent(exponent - i64::from(digits) + 1));
    let places = u32::try_from(i64::from(digits) - 1 - exponent).unwrap_or(0);
    trim_zeros(&fixed_rational(&rounded, places)).to_owned()
}

fn trim_zeros(number: &str) -> &str {
    if number.contains('.') { number.trim_end_matches('0').trim_end_matches('.') } else { number }
}

fn clamp_exponent(exponent: i64) -> i32 {
    i32::try_from(exponent).expect("numbers of more than 2^31 digits do not fit in memory")
}

/// The first `digits` significant digits of `value`, correctly rounded, as an integer,
/// and the exponent of ten of the first digit. (0, 0) for 0.
fn significant(value: &Rational, digits: u32) -> (Integer, i64) {
    assert!(digits > 0, "at least one significant digit");
    if value.is_zero() {
        return (Integer::zero(), 0);
    }
    let mut exponent = floor_log10(&value.abs());
    let scale = clamp_exponent(i64::from(digits) - 1 - exponent);
    let mut mantissa = (value * Rational::power_of_ten(scale)).round_half_even();
    if mantissa.abs() == Integer::power_of_ten(digits) {
        mantissa = mantissa.div_floor(&Integer::from(10));
        exponent += 1;
    }
    (mantissa, exponent)
}

/// ⌊log10 `value`⌋ for `value` > 0.
fn floor_log10(value: &Rational) -> i64 {
    let length = |integer: &Integer| integer.to_string().len();
    let guess = i64::try_from(length(&value.numerator())).unwrap_or(i64::MAX)
        - i64::try_from(length(&value.denominator())).unwrap_or(i64::MAX);
    // The guess is off by at most one, downwards: 10^(guess-1) < value < 10^(guess+1).
    if *value >= Rational::power_of_ten(clamp_exponent(guess)) { guess } else { guess - 1 }
}
