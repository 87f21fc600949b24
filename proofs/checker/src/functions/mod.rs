//! The functions of formulas. FORMAT.md defines them.

pub mod call;
pub mod depth;
pub mod exponent;
mod limits;
mod masks;
mod named;
mod peaks;
mod real;
mod reproduction;
mod shape;
mod steps;
pub mod sums;
mod vertices;
