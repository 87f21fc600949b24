//! Subdivision schemes, and what can be computed of them exactly.
//!
//! | module | what it holds |
//! |---|---|
//! | [`scheme`] | masks, difference masks, tensor products, rings, the catalogue |
//! | [`bound`] | contraction constants, also of rings, displacement, error bounds, depth |
//! | [`limit`] | limits at rational parameters, distances of polygons from them in both parametrisations |
//! | [`float`] | the same in f64, certified against the exact path |
//! | [`joint`] | the joint spectral radius of matrices, from both sides |
//! | [`lattice`] | masks on Z^d with a dilation matrix: facts, constants, smoothness |
//! | [`smoothness`] | how smooth limits are: C^m, and the Hölder exponent |
//! | [`spectrum`] | eigenvalues of the rules around a vertex or on a face, stencils of limits and tangents |
//! | [`characteristic`] | whether surfaces are C¹ at an extraordinary vertex: the characteristic map |
//! | [`facts`] | what all of these say of one scheme |
//!
//! Rooms of the crates below have their names here too, so that `crate::exact` is the same
//! everywhere.

use subcert_numbers::{cap, cores, diagnostic, exact, files, formula, machine, stop, suggestion};

pub mod bound;
pub mod characteristic;
pub mod facts;
pub mod float;
pub mod joint;
pub mod lattice;
pub mod limit;
pub mod scheme;
pub mod smoothness;
pub mod spectrum;
