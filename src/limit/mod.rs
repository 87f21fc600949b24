//! Limits of curve schemes, exactly, and how far polygons are from them.
//!
//! The statements that this rests on, with their hypotheses and proofs, are in
//! `proofs/THEOREMS.md`; comments cite them by number.

mod convergence;
mod error;
mod functional;
mod parameter;
mod value;

pub use error::{LimitError, MAX_LEVEL, MAX_OFFSET, MAX_PARAMETER_DIGITS, MAX_WINDOW};
pub use functional::{ExtremalPolygon, Functional};
pub use value::Limit;
