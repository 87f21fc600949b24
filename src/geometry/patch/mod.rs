//! How far a mesh or a net is from its limit surface, and how many levels a tolerance needs.
//!
//! A limit surface is cut into pieces, one for each face of a level (Catmull–Clark, Loop) or for
//! each vertex (Doo–Sabin). On a piece, mesh and limit are compared point by point in their natural
//! parameters. `proofs/THEOREMS.md`, 91 to 97, says so precisely, and proves the bounds; 100 to 102 do so for
//! solids, with a piece for each hexahedron.
//!
//! | item | what it is |
//! |---|---|
//! | [`MeshDistances`], [`MeshDepth`] | the depth of one mesh, from both sides |
//! | [`a_priori`] | what its longest edge and its valences guarantee |
//! | [`formula_level`] | what a paper's formula promises |
//! | [`NetDistances`], [`net_a_priori`], [`net_formula_level`] | the same of one tensor net (98 and 99) |
//! | [`LatticeNetDistances`] | the same of one net with a mask on Z² (153) |
//! | [`Distances`] | what both have in common |
//! | [`CurveSets`] | the depth of one control polygon, as sets of points |
//! | [`MeshDistances::of_solid`], [`solid_a_priori`], [`solid_formula_level`] | the same of a hexahedral solid |
//!
//! Points are computed in f64 with a bound of all rounding errors. What that leaves open is
//! decided exactly.

mod curve;
mod distance;
mod geometric;
mod hexes;
mod lattice;
mod mesh;
mod net;
mod number;
mod place;
mod progress;
mod range;
mod shapes;
mod threads;

pub use curve::{CurveDepth, CurvePlace, CurveSets, MAX_CURVE_PIECES};
pub use distance::depth::{Distances, MAX_DEPTH_LEVEL, MeshDepth};
pub use geometric::{
    FaceDepth, FaceSurface, GeometricDepth, GeometricPlace, LEAST_SHARE, SetKind,
    relative_tolerance,
};
pub use hexes::{SOLID_FORMULA_PAPER, solid_a_priori, solid_formula_level};
pub use lattice::LatticeNetDistances;
pub use mesh::apriori::{APriori, a_priori};
pub use mesh::distances::MeshDistances;
pub use mesh::formula::{FORMULA_PAPER, formula_level};
pub use net::{NET_FORMULA_PAPER, NetAPriori, NetDistances, net_a_priori, net_formula_level};
pub use place::FarPlace;
pub use progress::MeshWork;
