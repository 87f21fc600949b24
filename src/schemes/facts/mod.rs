//! What is known of a scheme, gathered from the other modules: nothing is computed here alone.
//!
//! Each fact has a cap on its work. What is not decided within it, or has no meaning for the scheme, is open, with
//! the reason.
//!
//! ```
//! use subcert::facts::{CurveFacts, PointPlacement};
//! use subcert::scheme::parse_scheme;
//!
//! let scheme = parse_scheme("chaikin")?;
//! let facts = CurveFacts::of_rational(scheme.masks()[0]);
//! assert_eq!((facts.kind, facts.points, facts.sum_rules), (Some(PointPlacement::Dual), 2, 3));
//! # Ok::<(), subcert::scheme::SchemeError>(())
//! ```

mod curve;
mod distance;
mod drawing;
mod family_drawing;
mod lattice;
mod lattice_shape;
mod ranges;
mod scheme;
mod shape;

pub use curve::{Columns, CurveFacts, MAX_LEVELS};
pub use distance::{Depths, LimitFacts};
pub use drawing::{CurveDrawing, CurveShape, Drawing, LEVELS, MAX_DERIVATIVES, SAMPLE};
pub use family_drawing::FamilyDrawing;
pub use lattice::{LatticeFacts, placement};
pub use lattice_shape::LatticeShape;
pub use ranges::{FamilyFacts, ParameterFacts, parameter_facts};
pub use scheme::{AtlasEntry, SchemeFacts, VALENCES, ValenceFacts, atlas_entry, atlas_references};
pub use shape::{PointPlacement, centre, is_interpolating, kind, points};
