//! Levels and points in words.

use crate::cli::console::quantity::Float;
use std::fmt::Display;

/// Coordinates that f64 arithmetic found, beside `all` others of their kind. One of at most 2^−45 of the greatest is a rounding
/// error, and is 0.
pub(super) fn found<'a>(all: impl Iterator<Item = &'a f64>) -> impl Fn(f64) -> Float + Copy {
    let least = all.fold(0.0, |most: f64, x| most.max(x.abs())) * f64::powi(2.0, -45);
    move |x| Float(if (-least..=least).contains(&x) { 0.0 } else { x })
}

/// A point in words.
pub(super) fn point(point: &[Float]) -> String {
    let numbers: Vec<String> = point.iter().map(Float::to_string).collect();
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

/// `at most ` before a level that is enough, where the search ended early and left the level below it open.
pub(super) fn at_most(level: u32, few: Option<u32>, ended: bool) -> &'static str {
    if ended && few != level.checked_sub(1) { "at most " } else { "" }
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
