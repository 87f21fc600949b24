//! The exact distance of polygons from their limits.

pub(super) mod cell;
pub(super) mod comparison;
pub(super) mod depth;
pub(super) mod distance;
pub(super) mod fraction;
pub(super) mod middles;
pub(super) mod polygon;
pub(super) mod remainder;
pub(super) mod search;
