//! Sets of values of a parameter, as JSON.

use super::exact::Exact;
use crate::exact::{self, IntervalSet, RealAlgebraic};
use crate::report::words::set::polynomial;
use serde::Serialize;
use std::ops::Bound;

/// An open interval.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Interval {
    /// Its lower end; null where it has none.
    pub low: Option<Number>,
    /// Its upper end; null where it has none.
    pub high: Option<Number>,
}

/// A real algebraic number.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Number {
    /// The value; its fields stand here.
    #[serde(flatten)]
    pub value: Exact,
    /// A polynomial with this root: the minimal one, unless its text says that it may have factors.
    pub minimal_polynomial: String,
    /// The number is the only root between these two.
    pub enclosure: [String; 2],
}

impl Interval {
    /// The intervals of a set of values of a parameter.
    #[must_use]
    pub fn all(set: &IntervalSet, parameter: &str) -> Vec<Interval> {
        let end = |end: &Bound<RealAlgebraic>| match end {
            Bound::Unbounded => None,
            Bound::Included(place) | Bound::Excluded(place) => Some(Number::of(place, parameter)),
        };
        let interval = |interval: &exact::Interval| Interval {
            low: end(&interval.low),
            high: end(&interval.high),
        };
        set.intervals().iter().map(interval).collect()
    }
}

impl Number {
    /// The form of a number, whose polynomial is one in the parameter.
    #[must_use]
    pub fn of(number: &RealAlgebraic, parameter: &str) -> Number {
        let (low, high) = number.bounds();
        Number {
            value: Exact::of(number),
            minimal_polynomial: polynomial(number, parameter),
            enclosure: [low.to_string(), high.to_string()],
        }
    }
}
