//! Claims about smoothness in words, of limits and at vertices.

pub(super) mod limits;
pub(super) mod range;
pub(super) mod regularity;
pub(super) mod smoothness;
pub(super) mod vertex;
