//! Reference values for the tests of other programs.
//!
//! An f64 implementation of subdivision must be tested against numbers that were not
//! computed in f64. This module computes the mask, the difference mask, the constants and
//! refined control polygons of a scheme exactly. It gives each value as p/q, as a
//! correctly rounded decimal, and as the nearest f64.
//!
//! Exact values go in as numbers of any type that converts into a
//! [`Rational`](crate::exact::Rational), and come out as one, which converts back.
//!
//! | item | what it is |
//! |---|---|
//! | [`reference_values`], [`OracleRequest`], [`OracleValues`] | all values of a scheme, as plain data |
//! | [`ring_reference_values`], [`LocalRequest`] | all values of a ring |
//! | [`to_json`], [`to_csv`], [`write_json`], [`write_csv`] | these values as JSON and CSV |
//! | [`to_table`], [`write_table`] | the same as CSV without comment lines |
//! | [`to_matlab`], [`matlab_name`] | a function of MATLAB that tests |
//! | [`to_source`], [`mesh_to_source`], [`OracleMesh`] | the values as arrays in C or Rust; those of meshes too |
//! | [`mesh_to_csv`] | the values of meshes as CSV |
//! | [`refine_polygon`], [`refine_grid`], [`refine_ring`], [`Control`] | exact refinement |
//! | [`check_within_ulps`], [`check_slice_within_ulps`], [`check_within`] | checks of f64 against exact values |
//! | [`assert_within_ulps!`](crate::assert_within_ulps), [`assert_slice_within_ulps!`](crate::assert_slice_within_ulps), [`assert_within!`](crate::assert_within) | these checks as assertions |

mod check;
mod control;
mod header;
mod lattice;
mod local_rules;
mod macros;
mod matlab;
mod mesh_table;
mod mismatch;
mod refine;
mod source;
mod table;
mod values;
mod write;

pub use check::{check_slice_within_ulps, check_within, check_within_ulps};
pub use control::{Control, SplitMix64};
pub use header::{Header, LocalShape, MaskShape};
pub use lattice::{LatticeRequest, lattice_reference_values};
pub use local_rules::{LocalRequest, refine_ring, ring_reference_values};
pub use matlab::{matlab_name, to_matlab};
pub use mesh_table::mesh_to_csv;
pub use mismatch::{Deviation, Mismatch, Tolerance};
pub use refine::{
    Boundary, MAX_BITS, MAX_REFINED_LEVEL, MAX_VALUES, OracleError, refine_grid, refine_polygon,
};
pub use source::{OracleMesh, mesh_to_source, to_source};
pub use table::{to_table, write_table};
pub use values::{Group, OracleRequest, OracleValues, Value, reference_values};
pub use write::{to_csv, to_json, write_csv, write_json};
