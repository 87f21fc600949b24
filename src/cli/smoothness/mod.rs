//! `subcert smoothness` and `jsr`.

mod curve;
mod jsr;
mod lattice;
mod mask;
mod radius;
mod vertex;

pub(super) use jsr::jsr;
pub(super) use mask::smoothness;
#[cfg(feature = "schema")]
pub(super) use {jsr::JointRadius, lattice::LatticeSmoothness, mask::Smoothness, vertex::Vertices};
