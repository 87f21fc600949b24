//! The rules of lines that blocks about claims of several kinds contain.

pub mod constant;
pub mod domain;
pub mod limits;
pub mod pieces;
