//! The functions of formulas. FORMAT.md defines them.

pub mod call;
pub mod depth;
pub mod exponent;
mod extremes;
pub mod families;
mod found;
pub mod lattice;
mod limits;
mod masks;
mod modulus;
mod named;
mod peaks;
mod ratios;
mod real;
mod reproduction;
mod roots;
mod shape;
mod shape_on;
mod steps;
pub mod sums;
mod vertices;
mod zeros;

pub use found::real;
pub use real::Real;
