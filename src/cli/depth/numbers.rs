//! Numbers and points in words.

use subcert::exact::format::short;
use subcert::float::{exact, shortest};

/// An f64 in at most nine digits.
pub(super) fn digits(value: f64) -> String {
    exact(value).map_or_else(|| shortest(value), |value| short(&value, 9))
}

pub(super) fn point(point: &[f64]) -> String {
    let numbers: Vec<String> = point.iter().map(|x| digits(*x)).collect();
    format!("({})", numbers.join(", "))
}
