//! Numbers and points in words.

use subcert::exact::format::short;
use subcert::float::{exact, shortest};
use subcert::patch::GeometricDepth;

/// An f64 in at most nine digits.
pub(super) fn digits(value: f64) -> String {
    exact(value).map_or_else(|| shortest(value), |value| short(&value, 9))
}

pub(super) fn point(point: &[f64]) -> String {
    let numbers: Vec<String> = point.iter().map(|x| digits(*x)).collect();
    format!("({})", numbers.join(", "))
}

/// Which levels are too few as a set of points, after the level that is enough.
pub(super) fn few_text<P>(found: &GeometricDepth<P>) -> String {
    match found.too_few {
        None if found.level == 0 => String::new(),
        Some(few) if few + 1 == found.level => format!("; {few} are too few"),
        Some(few) => format!("; {few} are too few, and those between are open"),
        None => "; fewer are open".to_owned(),
    }
}
