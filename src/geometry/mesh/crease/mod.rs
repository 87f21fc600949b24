//! Creases, corners, boundaries and holes, and the rules that follow from them.

mod blend;
mod sharpness;
mod tags;

pub use blend::{VertexBlend, VertexMask};
pub use sharpness::{INFINITE_FROM, Sharpness};
pub use tags::{Boundary, Creasing, Tags};
