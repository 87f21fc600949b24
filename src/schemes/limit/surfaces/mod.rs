//! The distance of nets from their limits.

pub(super) mod axis;
pub(super) mod search;
pub(super) mod surface;
