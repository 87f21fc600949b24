//! Real numbers that functions find: exactly, as roots, or between two bounds.

#![warn(clippy::arithmetic_side_effects)]

use crate::numbers::{Q, Value};
use crate::text::Stop;
use std::cmp::Ordering;

/// A real number.
pub enum Real {
    /// This one.
    Exact(Value),
    /// One between these two, of which no more is known.
    Between(Box<[Q; 2]>),
    /// The only root of a polynomial between these two. The constant coefficient comes first.
    Root(Vec<Q>, Box<[Q; 2]>),
}

impl Real {
    /// What is between two bounds, the lower one first.
    pub fn between(low: Q, high: Q) -> Result<Real, Stop> {
        match low.cmp(&high) {
            Ordering::Less => Ok(Real::Between(Box::new([low, high]))),
            Ordering::Equal => Ok(Real::Exact(low.into())),
            Ordering::Greater => Err(Stop::Wrong("bounds contradict each other".into())),
        }
    }

    /// The value of a formula. Here other real numbers than those of the fields become values, once formulas have such.
    pub fn value(self) -> Result<Value, Stop> {
        match self {
            Real::Exact(value) => Ok(value),
            Real::Root(..) | Real::Between(_) => {
                Err(Stop::Undecided("a number between two bounds"))
            }
        }
    }
}
