//! Claims about smoothness as JSON.

pub(super) mod claim;
pub(super) mod smoothness;
pub(super) mod vertex;
