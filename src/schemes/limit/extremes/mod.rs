//! Data with the greatest steps, overshoots and distances.

pub(super) mod far_polygon;
pub(super) mod overshoot;
pub(super) mod step;
pub(super) mod summit;
pub(super) mod supremum;
