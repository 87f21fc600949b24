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
//! | [`Distances`] | what both have in common |
//! | [`CurveSets`] | the depth of one control polygon, as sets of points |
//! | [`MeshDistances::of_solid`], [`solid_a_priori`], [`solid_formula_level`] | the same of a hexahedral solid |
//!
//! Points are computed in f64 with a bound of all rounding errors. What that leaves open is
//! decided exactly.

mod apart;
mod apriori;
mod around;
mod bezier;
mod cell;
mod curve;
mod depth;
mod descent;
mod fans;
mod far;
mod formula;
mod geometric;
mod greatest;
mod growth;
mod hexes;
mod judge;
mod kind;
mod levels;
mod measure;
mod mesh;
mod model;
mod neighbourhood;
mod net;
mod number;
mod regular;
mod ring;
mod roots;
mod rules;
mod search;
mod shape;
mod shapes;
mod surface;
mod threads;
mod work;

pub use apriori::{APriori, a_priori};
pub use curve::{CurveDepth, CurvePlace, CurveSets, MAX_CURVE_PIECES};
pub use depth::{Distances, MAX_DEPTH_LEVEL, MeshDepth};
pub use far::FarPlace;
pub use formula::{FORMULA_PAPER, formula_level};
pub use geometric::{
    FaceDepth, FaceSurface, GeometricDepth, GeometricPlace, LEAST_SHARE, SetKind,
    relative_tolerance,
};
pub use hexes::{SOLID_FORMULA_PAPER, solid_a_priori, solid_formula_level};
pub use mesh::MeshDistances;
pub use net::{NET_FORMULA_PAPER, NetAPriori, NetDistances, net_a_priori, net_formula_level};
pub use work::MeshWork;
