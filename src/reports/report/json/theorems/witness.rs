//! The data that refute a theorem.

use super::shift::EveryShift;
use crate::audit::{self, Attained, Naturally, Refutation, Violation};
use crate::limit::ExtremalPolygon;
use crate::report::json::exact::{Exact, Named};
use crate::report::words::data::name;
use serde::Serialize;

/// What refutes a theorem.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Witness<'a> {
    /// The data; their fields stand here.
    #[serde(flatten)]
    pub exceeding: Exceeding<'a>,
    /// The best true bound at this level, as far as it is known.
    pub supremum: Option<Supremum>,
    /// The sound bound.
    pub sound: Option<Exact>,
    /// The result with each point at its natural parameter; null where i/n^k are the natural
    /// parameters, and for differences.
    pub natural: Option<Natural<'a>>,
    /// The result in every shift of the parameter; null for differences and for rings.
    pub every_shift: Option<EveryShift<'a>>,
}

/// Whether a refuted theorem is also refuted with each point at its natural parameter.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Natural<'a> {
    /// Whether it is refuted there too; null where that is open.
    pub refuted: Option<bool>,
    /// The data that refute it there; missing where it is not refuted, and where the data that
    /// refute it in every shift do so. Their fields stand here.
    #[serde(flatten)]
    pub by: Option<Exceeding<'a>>,
}

/// Control data of spread 1, and a place where a quantity is greater than a theorem says.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Exceeding<'a> {
    /// The scheme and the values of the parameters.
    pub case: &'a str,
    /// The control data.
    pub control: Control<'a>,
    /// The level.
    pub level: u32,
    /// Where the quantity has the value.
    pub place: Place,
    /// The value.
    pub value: Exact,
    /// The bound that the theorem states for the value.
    pub bound: Exact,
}

/// Control data of integers.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum Control<'a> {
    /// A piece of a control polygon.
    Polygon {
        /// The index of its first point.
        first: i64,
        /// Its points.
        points: &'a [i64],
    },
    /// A piece of a control net.
    Net {
        /// The indices of its first point.
        first: [i64; 2],
        /// Its points, row by row.
        rows: &'a [Vec<i64>],
    },
    /// The points of a ring.
    Points {
        /// Their values by their names.
        points: Named<i64>,
    },
}

/// Where a quantity has a value.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum Place {
    /// A parameter t.
    Parameter {
        /// t.
        parameter: String,
    },
    /// Two parameters.
    Parameters {
        /// s and t.
        parameters: [String; 2],
    },
    /// A point.
    Point {
        /// Its index at the next level.
        point: i64,
    },
    /// A difference of neighbouring points.
    Difference {
        /// Its index.
        difference: i64,
    },
    /// Another place.
    Name {
        /// The place in a few words.
        name: String,
    },
}

/// Bounds of a supremum.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Supremum {
    /// A value that is attained.
    pub lower: Exact,
    /// An upper bound.
    pub upper: Option<Exact>,
}

impl<'a> Witness<'a> {
    pub(crate) fn of(refutation: &'a Refutation) -> Witness<'a> {
        let Refutation { case, violation, supremum, sound, natural, every_shift, .. } = refutation;
        Witness {
            exceeding: Exceeding::of(case, violation),
            supremum: supremum.as_ref().map(|supremum| Supremum {
                lower: Exact::of(&supremum.lower),
                upper: supremum.upper.as_ref().map(Exact::of),
            }),
            sound: sound.as_ref().map(Exact::of),
            natural: natural.as_ref().map(Natural::of),
            every_shift: every_shift.as_ref().map(EveryShift::of),
        }
    }
}

impl<'a> Natural<'a> {
    fn of(natural: &'a Naturally) -> Natural<'a> {
        match natural {
            Naturally::Refuted { case, violation, .. } => {
                Natural { refuted: Some(true), by: Some(Exceeding::of(case, violation)) }
            }
            Naturally::AsInEveryShift => Natural { refuted: Some(true), by: None },
            Naturally::Holds => Natural { refuted: Some(false), by: None },
            Naturally::Open => Natural { refuted: None, by: None },
        }
    }
}

impl<'a> Exceeding<'a> {
    fn of(case: &'a str, violation: &'a Violation) -> Exceeding<'a> {
        let (control, place) = data(&violation.attained);
        Exceeding {
            case,
            control,
            level: violation.level,
            place,
            value: Exact::of(&violation.attained.value),
            bound: Exact::of(&violation.bound),
        }
    }
}

fn data(attained: &Attained) -> (Control<'_>, Place) {
    let control = match &attained.control {
        audit::Control::Polygon(ExtremalPolygon { first, points }) => {
            Control::Polygon { first: *first, points }
        }
        audit::Control::Net { first, rows } => Control::Net { first: *first, rows },
        audit::Control::Points(points) => Control::Points { points: Named(points.clone()) },
    };
    let place = match &attained.place {
        audit::Place::Parameter(t) => Place::Parameter { parameter: t.to_string() },
        audit::Place::Parameters(both) => {
            Place::Parameters { parameters: both.each_ref().map(ToString::to_string) }
        }
        audit::Place::Point(i) => Place::Point { point: *i },
        audit::Place::Difference(i) => Place::Difference { difference: *i },
        place => Place::Name { name: name(place) },
    };
    (control, place)
}
