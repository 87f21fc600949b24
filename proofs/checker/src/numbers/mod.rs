//! Numbers, polynomials and their signs, and decimals as they are printed.

pub mod decimal;
pub mod element;
pub mod field;
pub mod linear;
pub mod magnitude;
pub mod meter;
pub mod number;
pub mod piece;
pub mod polynomial;
pub mod root;
pub mod rounding;
pub mod show;
pub mod value;
