//! Reading claim files.
//!
//! `reader` holds what all parts share. Each kind of claim has a file. `file` is a claim file as
//! TOML gives it, `roles` and `indices` check its names, and `paper` reads the whole file.

#![deny(clippy::arithmetic_side_effects)]

mod axis;
mod contents;
mod equation;
mod exponent;
mod fields;
mod figure;
mod file;
mod foreign;
mod function;
mod indices;
mod kind;
mod paper;
mod reader;
mod regularity;
mod relation;
mod roles;
mod smoothness;
mod table;
mod theorem;
mod trial;

#[cfg(feature = "schema")]
pub use paper::paper_schema;
pub use paper::{MAX_CLAIM_FILE_BYTES, read_paper, read_paper_file, read_whole_paper};
pub use reader::is_id;
