//! Depths and distances of whatever consists of pieces.

pub(super) mod depth;
pub(super) mod descent;
pub(super) mod judge;
pub(super) mod maximum;
pub(super) mod measure;
pub(super) mod surface;
pub(super) mod whole_mesh;
