//! Numbers and points in words.

use std::fmt::Display;
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

/// `1 level`, `2 levels`.
pub(super) fn levels<N: Copy + Display + PartialEq + From<u8>>(count: N) -> String {
    if count == N::from(1) { "1 level".to_owned() } else { format!("{count} levels") }
}

/// `; 1 is too few`, `; 2 are too few`.
pub(super) fn too_few(count: u32) -> String {
    format!("; {count} {} too few", if count == 1 { "is" } else { "are" })
}

/// The level that is enough as a set of points, with `more` about it, those that are too few, and why the search ended
/// early.
pub(super) fn depth_text<P>(found: &GeometricDepth<P>, more: &str) -> String {
    let text = match (found.level, found.too_few) {
        (Some(level), few) => format!("{}{more}{}", levels(level), few_text(level, few)),
        (None, None) => format!("open{more}"),
        (None, Some(few)) => format!("more than {}{more}", levels(few)),
    };
    match &found.ended {
        Some(why) => format!("{text}: {why}"),
        None => text,
    }
}

/// Which levels are too few, after the level that is enough.
pub(super) fn few_text(level: u32, few: Option<u32>) -> String {
    match few {
        None if level == 0 => String::new(),
        Some(few) if few + 1 == level => too_few(few),
        Some(few) => format!("{}, and those between are open", too_few(few)),
        None => "; fewer are open".to_owned(),
    }
}
