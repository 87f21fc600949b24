//! Limits of curve schemes, exactly, and how far polygons are from them.
//!
//! The statements that this rests on, with their hypotheses and proofs, are in
//! `proofs/THEOREMS.md`; comments cite them by number.

mod cell;
mod convergence;
mod depth;
mod distance;
mod error;
mod functional;
mod parameter;
mod polygon;
mod remainder;
mod search;
mod value;

pub use depth::TwoSidedDepth;
pub use distance::{Distance, Distances, MAX_CELLS};
pub use error::{LimitError, MAX_LEVEL, MAX_OFFSET, MAX_PARAMETER_DIGITS, MAX_WINDOW};
pub use functional::{ExtremalPolygon, Functional};
pub use polygon::ControlPolygon;
pub use value::Limit;
