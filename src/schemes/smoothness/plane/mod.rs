//! Planes of two parameters: maps of boxes, and polygons in which limits are C^m.

mod best;
mod map;
mod polygon;
mod region;

pub use best::{BestExponent, best_exponent};
pub use map::{MAX_BOXES, MapBox, SmoothMap, smooth_map};
pub use polygon::{RegionProof, polygon_contraction};
pub use region::{Certain, Sides};
