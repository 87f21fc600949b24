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
    Between(Box<[Q; 2]>),
    /// The only root of a polynomial between these two. The constant coefficient comes first.
    Root(Vec<Q>, Box<[Q; 2]>),
    /// The real root of this number, counted from 1 in increasing order, of a polynomial without multiple roots.
    RootOf(Vec<Number>, i64),
    /// The value of a polynomial at a number. The constant coefficient comes first.
    At(Vec<Number>, Box<Real>),
    /// A quotient.
    Ratio(Box<Real>, Box<Real>),
    /// A square root.
    SquareRoot(Box<Real>),
}

impl Real {
    /// What is between two bounds, the lower one first.
    pub fn between(low: Q, high: Q) -> Result<Real, Stop> {
        match low.cmp(&high) {
            std::cmp::Ordering::Less => Ok(Real::Between(Box::new([low, high]))),
            std::cmp::Ordering::Equal => Ok(Real::Exact(low.into())),
            std::cmp::Ordering::Greater => Err(Stop::Wrong("bounds contradict each other".into())),
        }
    }

    /// The value of a formula of numbers of fields Q(2cos(2π/n)).
    pub fn value(self) -> Result<Value, Stop> {
        match self {
            Real::Exact(value) => Ok(value),
            _ => Err(Stop::Undecided("a real number where others are needed")),
        }
    }
}
