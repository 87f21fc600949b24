//! Reference values for the tests of other programs.
//!
//! Whoever writes subdivision in f64 needs numbers to test against that are not
//! from f64 themselves. This module computes the mask, the difference mask, the
//! constants and refined control polygons of a scheme exactly, and gives each
//! value as p/q, as a correctly rounded decimal, and as the nearest f64.
//!
//! | item | what it is |
//! |---|---|
//! | [`reference_values`], [`OracleRequest`], [`OracleValues`] | all values of a scheme, as plain data |
//! | [`ring_reference_values`], [`LocalRequest`] | the same of a ring |
//! | [`to_json`], [`to_csv`], [`write_json`], [`write_csv`] | the same as a file |
//! | [`refine_polygon`], [`refine_grid`], [`refine_ring`], [`Control`] | exact refinement |
//! | [`check_within_ulps`], [`check_slice_within_ulps`], [`check_within`] | an f64 against an exact value |
//! | [`assert_within_ulps!`](crate::assert_within_ulps), [`assert_slice_within_ulps!`](crate::assert_slice_within_ulps), [`assert_within!`](crate::assert_within) | the same as assertions |

mod check;
mod control;
mod header;
mod local_rules;
mod macros;
mod mismatch;
mod refine;
mod values;
mod write;

pub use check::{check_slice_within_ulps, check_within, check_within_ulps};
pub use control::{Control, SplitMix64};
pub use header::{Header, LocalShape, MaskShape};
pub use local_rules::{LocalRequest, refine_ring, ring_reference_values};
pub use mismatch::{Deviation, Mismatch, Tolerance};
pub use refine::{
    Boundary, MAX_REFINED_LEVEL, MAX_VALUES, OracleError, refine_grid, refine_polygon,
};
pub use values::{Group, OracleRequest, OracleValues, Value, reference_values};
pub use write::{to_csv, to_json, write_csv, write_json};
