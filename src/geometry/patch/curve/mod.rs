//! How far a control polygon of points is from its limit curve as a set of points: the two-sided Hausdorff
//! distance (`proofs/THEOREMS.md`, 164 and 165).
//!
//! | file | subject |
//! |---|---|
//! | `points` | the refined points of all levels, computed when they are needed, with bounds of their errors |
//! | `cells` | pieces of the curve and of a polygon, and how far both may be from a chord |
//! | `find` | whether a set has a point near another |
//! | `level` | one level; `depth`: the least level that is sufficient |

mod cells;
mod depth;
mod find;
mod level;
mod points;

pub use depth::{CurveDepth, CurvePlace, CurveSets, MAX_CURVE_PIECES};
