//! How far a mesh is from its limit surface as a set of points: the two-sided Hausdorff distance
//! (`proofs/THEOREMS.md`, 160 to 163).
//!
//! | file | subject |
//! |---|---|
//! | `patch` | flat and bilinear parts of a mesh |
//! | `shadow` | projections along a direction, and the gap between two things that lie over each other |
//! | `pieces` | what the search needs to know of a surface |
//! | `node` | pieces of the limit, divided when they are needed |
//! | `scene` | a mesh of a level, or a part of it, with its pieces of the limit and their rings |
//! | `cover` | whether a piece of the mesh, or of the limit, is near the other set: the upper side |
//! | `whole` | whether a point is far from a whole set: the lower side |
//! | `sweep` | both sides for many units |
//! | `units`, `sets` | polygon meshes as the search sees them |
//! | `place` | answers: levels, and a point of one set that is far from the other |
//! | `relative` | tolerances as a share of the size of a mesh |
//! | `level` | one level of a polygon mesh; `levels`: from one to the next; `depth`: what a polygon mesh needs |

mod cover;
mod depth;
mod level;
mod level_scene;
mod levels;
mod node;
mod patch;
mod pieces;
mod place;
mod relative;
mod scene;
mod sets;
mod shadow;
mod sweep;
mod units;
mod whole;

pub use levels::LEAST_SHARE;
pub use patch::FaceSurface;
pub use place::{FaceDepth, GeometricDepth, GeometricPlace, SetKind};
pub use relative::relative_tolerance;

pub(crate) use cover::FarPoint;
pub(crate) use levels::{Levels, MAX_LEVEL, MeshNearness, check, distances};
pub(crate) use patch::Patch;
pub(crate) use pieces::{Hull, MeshPart, Pieces, Sets, Unit, Units};
pub(crate) use place::Nearness;
pub(crate) use scene::Scene;
pub(crate) use sweep::{far_distance, first_far, sweep};
pub(crate) use whole::Whole;
