//! The rules of lines that blocks about claims of several kinds contain.

pub mod constant;
pub mod curve;
pub mod domain;
pub mod lattice;
pub mod limits;
pub mod pieces;
