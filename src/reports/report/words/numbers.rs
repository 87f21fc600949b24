//! Numbers and polygons in words.

use crate::exact::{
    Integer, Rational, RealCyclotomic, format::fixed, format::raised, format::short,
};
use crate::limit::ExtremalPolygon;
use std::fmt::Display;

/// The number of significant digits of a decimal.
pub(crate) const DIGITS: u32 = 12;

/// The places of [`down`] and [`up`].
const PLACES: u32 = 12;

/// A decimal of 12 places that is not above the number.
#[must_use]
pub fn down(x: &Rational) -> String {
    let unit = Rational::from(Integer::power_of_ten(PLACES));
    fixed(&(Rational::from((x * &unit).floor()) / unit), PLACES)
}

/// A decimal of 12 places that is not below the number.
#[must_use]
pub fn up(x: &Rational) -> String {
    fixed(&raised(x, PLACES.cast_signed()), PLACES)
}

/// `x_-2, …, x_1 = 0, 1, 2, 1`.
pub(crate) fn points(letter: &str, ExtremalPolygon { first, points }: &ExtremalPolygon) -> String {
    let list: Vec<String> = points.iter().map(ToString::to_string).collect();
    let last = first + i64::try_from(points.len()).unwrap_or(1) - 1;
    format!("{letter}_{first}, …, {letter}_{last} = {}", list.join(", "))
}

/// `3/2 = 1.5`.
pub(crate) fn exact(value: &RealCyclotomic) -> String {
    let (text, decimal) = (value.to_string(), short(value, DIGITS));
    if text == decimal { text } else { format!("{text} = {decimal}") }
}

/// `280,048`.
pub(crate) fn grouped(number: impl Display + Copy) -> String {
    let digits = number.to_string();
    let commas = |(place, digit): (usize, char)| {
        let comma = place > 0 && (digits.len() - place).is_multiple_of(3);
        comma.then_some(',').into_iter().chain([digit])
    };
    digits.chars().enumerate().flat_map(commas).collect()
}
