//! Pictures of findings as SVG: each has a title and a description in words.
//!
//! Positions on a page are f64; what they show is computed exactly before.

mod chart;
mod curve;
mod digits;
mod frame;
mod levels;
mod range;
mod readings;
mod scale;
mod smooth_range;
mod witness;

pub(super) use chart::chart;
pub(super) use digits::digits;
pub(super) use levels::levels;
pub(super) use range::range;
pub(super) use readings::readings;
pub(super) use smooth_range::smooth_range;
pub(super) use witness::{Exceeding, witness};
