//! The limit of a ring, and the distance from it.

pub(super) mod distance;
pub(super) mod flows;
pub(super) mod limit;
