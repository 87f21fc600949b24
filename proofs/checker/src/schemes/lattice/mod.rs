//! Masks on Z^d, d = 2 or 3 (proofs/format/lattice.md).

mod boxes;
mod dilation;
mod fields;
mod lists;
mod mask;
mod tables;
mod vectors;

pub use dilation::Dilation;
pub use fields::{is_lattice, variables};
pub use mask::Lattice;
pub use vectors::{Vector, plus, times};
