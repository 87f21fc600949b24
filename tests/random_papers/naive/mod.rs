//! Schemes refined by the letter of their definition, in fractions of another library.
//!
//! All of it follows from x'_{ni+α} = Σ_j a_{α,j} x_{i+o+j}: nothing of the program is used.

mod curve;
mod local_rules;
mod net;

pub use curve::{Curve, Row};
pub use local_rules::LocalRules;
pub use net::Net;

use num_bigint::BigInt;

pub type Q = num_rational::Ratio<BigInt>;

pub fn int(value: i64) -> Q {
    Q::from_integer(value.into())
}
