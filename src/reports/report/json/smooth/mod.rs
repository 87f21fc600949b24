//! Claims about smoothness as JSON.

pub(crate) mod smoothness;
pub(super) mod vertex;
