//! Pieces of solids: hexahedra with all hexahedra that share a corner with them.

mod across;
mod grid;
mod guarantee;
mod layers;
mod local;
mod neighbourhood;
mod roots;

pub(super) use across::{Across, AcrossPart};
pub use guarantee::{SOLID_FORMULA_PAPER, solid_a_priori, solid_formula_level};
pub(super) use layers::Layers;
pub(super) use local::{HexLocal, parts_of};
pub(super) use roots::hex_roots;
