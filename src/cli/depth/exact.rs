//! The true depth for every control polygon of a spread.

use super::distance::{Distance, Interval, TwoSided};
use super::place::Place;
use crate::cli::console::quantity::{Number, Text, above};
use serde::Serialize;
use subcert::audit::{Attained, Control, Place as AttainedAt};
use subcert::exact::{Enclosure, Rational};
use subcert::float::nearest;
use subcert::limit::{self, Comparison, Distances, LimitError, Parametrisation};
use subcert::scheme::Mask;

/// The longest polygon or ring that is shown in a text.
const MAX_SHOWN_POINTS: usize = 32;

/// A tolerance ε for the control polygons with max|Δ| ≤ β.
pub(super) struct Asked<'a> {
    pub(super) tolerance: &'a Rational,
    pub(super) spread: &'a Rational,
    /// How narrow the intervals of distances are to be.
    pub(super) width: &'a Rational,
    /// Whether the distances of the levels before the depth are asked for, for a picture.
    pub(super) levels: bool,
}

/// The true depth for every control polygon or net of the spread.
#[derive(Clone, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct Exactly {
    /// The depth; its fields stand here.
    #[serde(flatten)]
    pub(super) depth: TwoSided,
    /// Where the points are; its fields stand here.
    #[serde(flatten)]
    pub(super) place: Place,
    /// The greatest distance at the upper side of the depth.
    pub(super) distance: Distance,
    /// Control data that are too far from their limit at the level below the depth.
    pub(super) witness: Option<Witness>,
    /// These data, of spread 1.
    #[serde(skip)]
    pub(super) attained: Option<Attained>,
    /// The distances of levels up to the depth, where they are asked for and the caps allow.
    #[serde(skip)]
    pub(super) levels: Vec<(u32, f64)>,
    /// The caps of the search.
    #[serde(skip)]
    pub(super) caps: String,
}

/// Control data that are too far from their limit.
#[derive(Clone, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub(super) enum Witness {
    /// A piece of a control polygon.
    Polygon {
        /// The level.
        level: u32,
        /// The index of its first point.
        first: i64,
        /// Its points.
        points: Vec<i64>,
        /// What the points are multiplied by.
        times: Text<Rational>,
        /// The parameter at which the distance is too large.
        parameter: Text<Rational>,
        /// The distance there.
        distance: Number,
    },
    /// A piece of a control net.
    Net {
        /// The level.
        level: u32,
        /// The indices of its first point.
        first: [i64; 2],
        /// Its points, row by row.
        net: Vec<Vec<i64>>,
        /// What the points are multiplied by.
        times: Text<Rational>,
        /// The parameters at which the distance is too large.
        parameters: [Text<Rational>; 2],
        /// The distance there.
        distance: Number,
    },
}

/// The most rows of a net that are shown in a text.
const MAX_SHOWN_ROWS: usize = 6;

impl Witness {
    pub(super) fn level(&self) -> u32 {
        match self {
            Witness::Polygon { level, .. } | Witness::Net { level, .. } => *level,
        }
    }

    fn words(&self, tolerance: &Rational) -> String {
        match self {
            Witness::Polygon { first, points, parameter, distance, .. } => format!(
                "β times {}, from index {first}: {} from its limit at t = {parameter}",
                points_text(points),
                above(distance, tolerance)
            ),
            Witness::Net { first: [i, j], net, parameters: [s, t], distance, .. } => {
                let rows = net.iter().take(MAX_SHOWN_ROWS).map(|row| points_text(row));
                let more =
                    if net.len() > MAX_SHOWN_ROWS { " / … (all in --format json)" } else { "" };
                format!(
                    "β times {}{more}, from index ({i}, {j}): {} from its limit at ({s}, {t})",
                    rows.collect::<Vec<String>>().join(" / "),
                    above(distance, tolerance)
                )
            }
        }
    }
}

impl Exactly {
    pub(super) fn of(
        mask: &Mask,
        parametrisation: Parametrisation,
        distances: &Distances,
        asked: &Asked<'_>,
    ) -> Result<Exactly, LimitError> {
        let depth = distances.depth(asked.spread, asked.tolerance)?;
        let width = asked.width / asked.spread;
        let mut distance = Distance::of(distances.constant(depth.upper, &width), depth.upper)?;
        let Interval(of_one) = &distance.interval;
        let [lower, upper] = [of_one.lower(), of_one.upper()].map(|end| end * asked.spread);
        distance.interval = Interval(Enclosure::new(lower, upper));
        let threshold = asked.tolerance / asked.spread;
        let below = depth.lower.checked_sub(1).map(|level| distances.compare(level, &threshold));
        let (witness, attained) = match below.transpose()? {
            Some(Comparison::Exceeds(found)) => {
                let limit::Witness { polygon, parameter, level, distance } = found;
                let witness = Witness::Polygon {
                    level,
                    first: polygon.first,
                    points: polygon.points.clone(),
                    times: Text(asked.spread.clone()),
                    parameter: Text(parameter.clone()),
                    distance: (&(&distance * asked.spread)).into(),
                };
                let (control, place) =
                    (Control::Polygon(polygon), AttainedAt::Parameter(parameter));
                (Some(witness), Some(Attained { control, place, value: distance.into() }))
            }
            Some(Comparison::Within | Comparison::Undecided(_)) | None => (None, None),
        };
        let shifts = vec![distances.shift().clone()];
        Ok(Exactly {
            place: Place::of(&[mask], parametrisation, shifts),
            levels: if asked.levels { levels(distances, depth.upper, asked) } else { Vec::new() },
            depth: depth.into(),
            distance,
            witness,
            attained,
            caps: distances.caps(),
        })
    }

    /// All facts about the depth.
    pub(super) fn facts(&self, tolerance: &Rational) -> Vec<(String, String)> {
        let mut facts = vec![
            ("exact depth".to_owned(), self.depth_text()),
            ("points of level k at".to_owned(), self.place.text()),
            (format!("distance C_{}·β", self.distance.level), self.distance.words(&self.caps)),
        ];
        if let Some(witness) = &self.witness {
            facts.push((format!("too far at level {}", witness.level()), witness.words(tolerance)));
        }
        facts
    }

    /// The depth alone.
    pub(super) fn depth_text(&self) -> String {
        self.depth.words(self.place.whom(), &self.caps)
    }

    /// The depth, and where the points are.
    pub(super) fn short(&self) -> String {
        format!("with the points at {}, {}", self.place.parameters(), self.depth_text())
    }
}

/// The most levels of a picture.
const MAX_LEVELS: u32 = 16;

/// The distances of the levels up to the depth, as far as the caps allow.
fn levels(distances: &Distances, depth: u32, asked: &Asked<'_>) -> Vec<(u32, f64)> {
    let width = asked.tolerance / asked.spread / Rational::from(WIDTHS);
    let distance = |level: u32| {
        let found = distances.constant(level, &width).ok()?;
        Some((level, nearest(&(found.enclosure.upper() * asked.spread))))
    };
    (depth.saturating_sub(MAX_LEVELS)..=depth).map_while(distance).collect()
}

/// How much narrower than the tolerance the intervals for a picture are.
const WIDTHS: i64 = 20;

/// Points; of many, the first ones.
pub(super) fn points_text(points: &[i64]) -> String {
    let shown = points.iter().take(MAX_SHOWN_POINTS).map(i64::to_string);
    let more = if points.len() > MAX_SHOWN_POINTS { " … (all in --format json)" } else { "" };
    format!("{}{more}", shown.collect::<Vec<_>>().join(" "))
}
