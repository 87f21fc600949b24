//! Meshes, nets and solids: exact refinement, limits, and how far they are from them.
//!
//! | module | what it holds |
//! |---|---|
//! | [`mesh`] | polygon meshes: files, refinement, limit points and normals |
//! | [`net`] | tensor nets: files, refinement, limit points |
//! | [`solid`] | hexahedral meshes: files, refinement by Bajaj's scheme, limit points |
//! | [`patch`] | how far meshes, nets and solids are from their limits |
//! | [`oracle`] | reference values and checks for other programs' tests |
//!
//! Rooms of the crates below have their names here too, so that `crate::exact` is the same
//! everywhere.

use subcert_numbers::{cores, diagnostic, exact, stop, suggestion};
use subcert_schemes::{bound, characteristic, float, lattice, limit, scheme, spectrum};

mod grouped;
pub mod mesh;
pub mod net;
pub mod oracle;
pub mod patch;
pub mod solid;
