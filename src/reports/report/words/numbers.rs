//! Numbers and polygons in words.

use crate::exact::{RealCyclotomic, format::short};
use crate::limit::ExtremalPolygon;

/// The number of significant digits of a decimal.
pub(crate) const DIGITS: u32 = 12;

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
