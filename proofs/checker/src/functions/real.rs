//! Real numbers that functions find: exactly, or between two bounds.

#![warn(clippy::arithmetic_side_effects)]

use super::call::Call;
use super::{exponent, limits, peaks};
use crate::formulas::{Asked, Scope};
use crate::numbers::{Number, Q, Value};
use crate::schemes::Library;
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
    /// The real root of this number, counted from 1 in increasing order, of a polynomial without multiple roots.
    RootOf(Vec<Number>, i64),
    /// A quotient.
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

    /// The value of a formula of numbers of fields Q(2cos(2π/n)).
    pub fn value(self) -> Result<Value, Stop> {
        match self {
            Real::Exact(value) => Ok(value),
            _ => Err(Stop::Undecided("a real number where others are needed")),
        }
    }
}

/// The value of a function that may be any real number; `None` if the function is none of these.
pub fn real(library: &Library<'_>, scope: &Scope<'_>, of: Asked<'_>) -> Result<Option<Real>, Stop> {
    let mut call = Call::new(library, scope, of);
    for group in [exponent::real, peaks::real, limits::real] {
        if let Some(found) = group(&mut call)? {
            call.finished()?;
            return Ok(Some(found));
        }
    }
    Ok(None)
}
