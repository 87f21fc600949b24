//! Theorems in every shift of the parameter.

use crate::audit::{self, Unshiftable};
use crate::exact::{Rational, RealCyclotomic};
use crate::limit::{ExtremalPolygon, Overshoot, ProofOfGreatest};
use crate::report::json::exact::Exact;
use serde::Serialize;

/// Whether a theorem is refuted in every shift s of the parameter: with x^k_i at (i + s)/n^k, for
/// every real number s.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct EveryShift<'a> {
    /// Whether it is refuted: false where it holds at the natural parameters, at the levels that
    /// were looked at, and null where neither is known.
    pub refuted: Option<bool>,
    /// The data that refute it; missing where it is not refuted. Their fields stand here.
    #[serde(flatten)]
    pub by: Option<Greatest<'a>>,
}

/// Control data of spread 1. Their greatest values at a level and at the next one, or in the limit,
/// differ by more than the theorem's bound of a step or a distance.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Greatest<'a> {
    /// The scheme and the values of the parameters.
    pub case: &'a str,
    /// The polygon, or two polygons a and b of the net a_i + b_j; constant beyond both ends.
    pub control: Vec<Polygon<'a>>,
    /// The level.
    pub level: u32,
    /// Its greatest point.
    pub greatest: Exact,
    /// The greatest point of the next level, or a bound of the supremum of the limit.
    pub later: Exact,
    /// `next-level`, `limit-at-most` or `limit-at-least`: what `later` is.
    pub kind: &'static str,
    /// The levels that show that the limit is at most `later`, or the parameters at which the limit
    /// has this value.
    pub at: Vec<String>,
    /// The difference of `greatest` and `later`: in every shift, the quantity is at least this.
    pub value: Exact,
    /// The bound that the theorem states for the quantity.
    pub bound: Exact,
}

/// A piece of a control polygon.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Polygon<'a> {
    /// The index of its first point.
    pub first: i64,
    /// Its points.
    pub points: &'a [i64],
}

impl<'a> EveryShift<'a> {
    pub(crate) fn of(found: &'a audit::EveryShift) -> EveryShift<'a> {
        match found {
            audit::EveryShift::Refuted { case, data, .. } => {
                EveryShift { refuted: Some(true), by: Some(Greatest::of(case, data)) }
            }
            audit::EveryShift::Holds => EveryShift { refuted: Some(false), by: None },
            audit::EveryShift::Open => EveryShift { refuted: None, by: None },
        }
    }
}

impl<'a> Greatest<'a> {
    fn of(case: &'a str, data: &'a Unshiftable) -> Greatest<'a> {
        let Unshiftable { level, overshoot, bound, .. } = data;
        let Overshoot { polygons, greatest, later, shown } = overshoot;
        let exact = |value: &Rational| Exact::of(&RealCyclotomic::from(value.clone()));
        let polygon = |ExtremalPolygon { first, points }: &'a ExtremalPolygon| Polygon {
            first: *first,
            points,
        };
        let (kind, at) = match shown {
            ProofOfGreatest::Points => ("next-level", Vec::new()),
            ProofOfGreatest::AtMost(levels) => {
                ("limit-at-most", levels.iter().map(ToString::to_string).collect())
            }
            ProofOfGreatest::AtLeast(places) => {
                ("limit-at-least", places.iter().map(ToString::to_string).collect())
            }
        };
        Greatest {
            case,
            control: polygons.iter().map(polygon).collect(),
            level: *level,
            greatest: exact(greatest),
            later: exact(later),
            kind,
            at,
            value: exact(&overshoot.gap()),
            bound: Exact::of(bound),
        }
    }
}
