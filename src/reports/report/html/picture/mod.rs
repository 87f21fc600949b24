//! Pictures of findings as SVG: each has a title and a description in words.
//!
//! Positions on a page are f64; what they show is computed exactly before.

mod basic;
mod chart;
mod control_polygon;
mod curve;
mod digits;
mod faces;
mod family;
mod figure;
mod grid;
mod lattice;
mod level_chart;
mod levels;
mod plane;
mod range;
mod readings;
mod ring;
mod ring_places;
mod smooth_range;
mod space;
mod witness;

pub(super) use basic::basic;
pub(super) use chart::chart;
pub use control_polygon::FarPolygon;
pub(super) use control_polygon::control_polygon;
pub(super) use digits::digits;
pub use faces::ColouredFaces;
pub(super) use faces::faces;
pub(super) use family::family;
pub(super) use figure::figure;
pub(super) use lattice::{contours, surface};
pub(super) use level_chart::{LevelChart, Line};
pub(super) use levels::levels;
pub(super) use plane::panel::{Panel, standalone};
pub(super) use plane::sample::sample;
pub(crate) use range::range;
pub(super) use readings::readings;
pub(super) use ring::ring;
pub(crate) use smooth_range::smooth_range;
pub(crate) use witness::{Exceeding, witness};
