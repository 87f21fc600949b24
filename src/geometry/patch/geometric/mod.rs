//! How far a mesh is from its limit surface as a set of points: the two-sided Hausdorff distance
//! (`proofs/THEOREMS.md`, 160 to 163).
//!
//! | file | subject |
//! |---|---|
//! | `patch` | flat and bilinear parts of a mesh |
//! | `shadow` | projections along a direction, and the gap between two things that lie over each other |
//! | `node` | pieces of the limit with the hulls that they are in |
//! | `scene` | a mesh of a level, or a part of it, with its pieces of the limit and their rings |
//! | `cover` | whether a piece of the mesh, or of the limit, is near the other set: the upper side |
//! | `whole` | whether a point is far from a whole set: the lower side |
//! | `region` | which faces are looked at, and the parts of a mesh that they need |
//! | `place` | a point of one set that is far from the other |
//! | `relative` | tolerances as a share of the size of a mesh |
//! | `level` | one level; `depth`: the least level that is sufficient |

mod cover;
mod depth;
mod level;
mod node;
mod patch;
mod place;
mod region;
mod relative;
mod scene;
mod shadow;
mod whole;

pub use depth::{FaceDepth, GeometricDepth};
pub use level::LEAST_SHARE;
pub use patch::FaceSurface;
pub use place::{GeometricPlace, SetKind};
pub use relative::relative_tolerance;
