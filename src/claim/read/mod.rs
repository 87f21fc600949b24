//! Reading claim files.
//!
//! `reader` has what all parts need; the files of the claims' kinds stand on it; `file` is a claim
//! file as TOML gives it; `roles` and `indices` check its names; `paper` reads it all.

mod axis;
mod contents;
mod equation;
mod fields;
mod file;
mod function;
mod indices;
mod paper;
mod reader;
mod roles;
mod table;
mod theorem;
mod trial;

pub use paper::{MAX_CLAIM_FILE_BYTES, read_paper, read_paper_file, read_whole_paper};
pub use reader::is_id;
