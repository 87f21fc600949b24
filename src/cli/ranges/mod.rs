//! `subcert range`.

mod best;
mod level;
mod range;
pub(super) mod sets;
pub(super) mod smooth_map;
mod smooth_range;
pub(super) mod special;
mod vertex_range;

pub(super) use range::range;
#[cfg(feature = "schema")]
pub(super) use {
    best::{BestContraction, BestExponentAnswer},
    range::Range,
    smooth_map::SmoothMap,
    smooth_range::SmoothRange,
    vertex_range::VertexRange,
};
