//! Claims about smoothness in words, of limits and at vertices.

pub(super) mod regularity;
pub(super) mod smoothness;
pub(super) mod vertex;
