//! Meshes as text.

mod json;
mod obj;
mod ply;

pub use json::to_json;
pub(crate) use json::{list, numbers};
pub use obj::to_obj;
pub use ply::to_ply;

use super::point::Point;
use crate::exact::Enclosed;
use crate::float::{nearest, shortest};

/// A coordinate beyond the greatest f64.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("a coordinate is beyond the greatest f64: only JSON, which is exact, can hold this mesh")]
pub struct BeyondF64;

/// The nearest f64 of the coordinates, each as the shortest decimal that reads back.
pub(crate) fn decimals<S: Enclosed>(point: &Point<S>) -> Result<[String; 3], BeyondF64> {
    let decimals = point.each_ref().map(|x| shortest(nearest(x)));
    if decimals.iter().any(|text| text.contains("inf")) {
        return Err(BeyondF64);
    }
    Ok(decimals)
}

/// Text in one line: what a comment can hold.
pub(crate) fn one_line(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}
