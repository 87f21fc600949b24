//! Claims about smoothness as JSON.

pub(crate) mod exponent;
pub(crate) mod smoothness;
pub(super) mod vertex;
