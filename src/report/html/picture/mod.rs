//! Pictures of findings as SVG: each has a title and a description in words.
//!
//! Positions on a page are f64; what they show is computed exactly before.

mod chart;
mod curve;
mod digits;
mod frame;
mod grid;
mod legend;
mod levels;
mod line;
mod range;
mod readings;
mod ring_places;
mod scale;
mod space;
mod witness;

pub(super) use chart::chart;
pub(super) use digits::digits;
pub(super) use levels::levels;
pub(super) use range::range;
pub(super) use readings::readings;
pub(super) use witness::{Exceeding, witness};
