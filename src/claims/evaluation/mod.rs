//! Evaluation: from the formulas of a claim to exact values.
//!
//! A table's formula is evaluated cell by cell, under a reading ([`settings`]) that may differ from
//! the printed text in a few [`choices`]; identities are evaluated as polynomials, claims about a
//! free parameter as piecewise polynomial functions.

pub(crate) mod arguments;
mod choice;
pub(crate) mod choices;
pub(crate) mod context;
pub(crate) mod copied;
mod elsewhere;
mod functions;
pub(crate) mod identities;
pub(crate) mod library;
pub(crate) mod limits;
pub(crate) mod masks;
mod options;
pub(crate) mod parametric;
pub(crate) mod quantity;
pub(crate) mod reals;
pub(crate) mod reference;
mod row;
mod series;
pub(crate) mod settings;
pub(crate) mod shape;
pub(crate) mod table;
pub(crate) mod trace;

pub use choice::{Choice, Effect, Way};
pub use choices::FAMILY;
pub use copied::Copied;
pub use functions::QUANTITIES;
pub use reals::Limits;
