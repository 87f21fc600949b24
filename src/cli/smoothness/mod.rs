//! `subcert smoothness` and `jsr`.

mod curve;
mod jsr;
mod mask;
pub(super) mod radius;
mod vertex;

pub(super) use jsr::jsr;
pub(super) use mask::smoothness;
