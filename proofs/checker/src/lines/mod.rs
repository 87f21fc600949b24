//! The rules of lines that blocks about claims of several kinds contain.

pub mod constant;
pub mod limits;
pub mod pieces;
