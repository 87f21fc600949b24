//! Creases, corners, boundaries and holes, and the rules that follow from them.

mod blend;
mod cut;
mod sharpness;
mod tags;

pub(crate) use cut::cut_at_creases;

pub use blend::{VertexBlend, VertexMask};
pub use sharpness::{INFINITE_FROM, Sharpness};
pub use tags::{Boundary, Creasing, Tags};
