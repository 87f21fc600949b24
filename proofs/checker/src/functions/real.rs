//! Real numbers that functions find: exactly, or between two bounds.

#![warn(clippy::arithmetic_side_effects)]

use crate::numbers::{Number, Q, Value};
use crate::text::Stop;

/// A real number.
#[derive(Clone)]
pub enum Real {
    /// This one.
    Exact(Value),
    /// One between these two.
    Between(Q, Q),
    /// The only root of a polynomial between these two. The constant coefficient comes first.
    Root(Vec<Q>, Q, Q),
    /// The i-th of the real roots of a polynomial without multiple roots, from 1 on, ascending. The constant coefficient comes first.
    #[expect(dead_code, reason = "no comparison reads it yet")]
    RootOf(Vec<Number>, i64),
    /// A quotient. The divisor is not 0.
    #[expect(dead_code, reason = "no comparison reads it yet")]
    Ratio(Box<Real>, Box<Real>),
}

impl Real {
    /// What is between two bounds, the lower one first.
    pub fn between(low: Q, high: Q) -> Result<Real, Stop> {
        match low.cmp(&high) {
            std::cmp::Ordering::Less => Ok(Real::Between(low, high)),
            std::cmp::Ordering::Equal => Ok(Real::Exact(low.into())),
            std::cmp::Ordering::Greater => Err(Stop::Wrong("bounds contradict each other".into())),
        }
    }

    /// The value of a formula.
    pub fn value(self) -> Result<Value, Stop> {
        match self {
            Real::Exact(value) => Ok(value),
            Real::Root(_, low, high) | Real::Between(low, high) => {
                Err(Stop::Wrong(format!("DEBUG {low} {high}")))
            }
            Real::RootOf(..) | Real::Ratio(..) => Err(Stop::Undecided("a real number")),
        }
    }
}
