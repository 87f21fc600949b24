//! The tests, in one program: folders and files are those of `src` that they are about.
//!
//! One program links the crate once. `cargo test exact::` runs one folder.

#![allow(missing_docs)]

mod architecture;
mod audit;
mod bound;
mod certificate;
mod characteristic;
mod claim;
#[cfg(feature = "cli")]
mod cli;
mod common;
mod digest;
mod exact;
mod facts;
mod float;
mod formula;
mod fuzz;
mod joint;
mod judge;
mod lattice;
mod limit;
mod literal;
mod mesh;
mod net;
mod oracle;
mod patch;
mod random_papers;
mod report;
mod scheme;
mod shipped;
mod smoothness;
mod solid;
mod spectrum;
