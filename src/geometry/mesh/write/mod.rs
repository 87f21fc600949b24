//! Meshes as text.

mod json;
mod obj;
mod off;
mod ply;
mod stl;
mod usd;

pub use json::to_json;
pub(crate) use json::{list, numbers};
pub use obj::to_obj;
pub use off::to_off;
pub use ply::to_ply;
pub use stl::to_stl;
pub use usd::to_usda;

use super::point::Point;
use crate::exact::Enclosed;
use crate::float::{nearest, shortest};

/// A coordinate beyond the greatest f64.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("a number is beyond the greatest f64: only JSON, which is exact, can hold it")]
pub struct BeyondF64;

/// The nearest f64 of the coordinates, each as the shortest decimal that reads back.
pub(crate) fn decimals<S: Enclosed>(point: &Point<S>) -> Result<[String; 3], BeyondF64> {
    let decimals = point.each_ref().map(|x| shortest(nearest(x)));
    if decimals.iter().any(|text| text.contains("inf")) {
        return Err(BeyondF64);
    }
    Ok(decimals)
}

/// Text in one line: what a comment can hold. Marks of a writing direction, which compilers refuse, are left out too.
pub(crate) fn one_line(text: &str) -> String {
    let turns = |c: char| matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    text.chars().map(|c| if c.is_control() || turns(c) { ' ' } else { c }).collect()
}
