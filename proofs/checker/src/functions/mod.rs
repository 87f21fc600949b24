//! The functions of formulas. FORMAT.md defines them.

pub mod call;
pub mod depth;
pub mod exponent;
mod named;
pub mod sums;
