//! The true depth for every control polygon of a spread.

use super::interval::{interval_form, interval_text};
use super::numbers;
use super::place::Place;
use crate::cli::json::depth as form;
use subcert::audit::{Attained, Control, Place as AttainedAt};
use subcert::exact::{Enclosure, Rational, format::short};
use subcert::float::nearest;
use subcert::limit::{
    Comparison, Distance, Distances, LimitError, Parametrisation, TwoSidedDepth, Witness,
};
use subcert::report::json::Exact as ExactForm;
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

/// The true depth, the distance constant at that level, and data that show that one level less is
/// too few.
pub(super) struct Exact {
    pub(super) place: Place,
    pub(super) depth: TwoSidedDepth,
    /// C_k·β at the upper side k of the depth.
    pub(super) distance: Known,
    /// Control data that are too far from their limit at the level below the depth.
    pub(super) too_far: Option<TooFar>,
    /// The distances of levels up to the depth, where they are asked for and the caps allow.
    pub(super) levels: Vec<(u32, f64)>,
    /// The caps of the search.
    pub(super) caps: String,
}

/// Control data that are too far from their limit at a level.
pub(super) struct TooFar {
    pub(super) level: u32,
    pub(super) text: String,
    pub(super) form: form::Witness,
    /// The data of spread 1.
    pub(super) attained: Attained,
}

/// An enclosure of a distance.
pub(super) struct Known {
    pub(super) enclosure: Enclosure,
    /// Whether it is as narrow as was asked for.
    pub(super) narrow: bool,
    /// A parameter t at which the distance has the value of the lower end.
    pub(super) parameter: Option<Rational>,
}

impl Known {
    /// The enclosure of a distance, also if the caps leave it wide.
    pub(super) fn of(distance: Result<Distance, LimitError>) -> Result<Known, LimitError> {
        match distance {
            Ok(Distance { enclosure, parameter }) => {
                Ok(Known { enclosure, narrow: true, parameter: Some(parameter) })
            }
            Err(LimitError::TooFine { reached, .. }) => {
                Ok(Known { enclosure: *reached, narrow: false, parameter: None })
            }
            Err(error) => Err(error),
        }
    }

    pub(super) fn text(&self, caps: &str) -> String {
        let text = interval_text(&self.enclosure);
        if self.narrow { text } else { format!("{text}, as narrow as the caps allow: {caps}") }
    }
}

impl Exact {
    pub(super) fn of(
        mask: &Mask,
        parametrisation: Parametrisation,
        distances: &Distances,
        asked: &Asked<'_>,
    ) -> Result<Exact, LimitError> {
        let depth = distances.depth(asked.spread, asked.tolerance)?;
        let width = asked.width / asked.spread;
        let mut distance = Known::of(distances.constant(depth.upper, &width))?;
        let scaled = |end: &Rational| end * asked.spread;
        let enclosure = &distance.enclosure;
        distance.enclosure = Enclosure::new(scaled(enclosure.lower()), scaled(enclosure.upper()));
        let threshold = asked.tolerance / asked.spread;
        let too_far = match depth.lower.checked_sub(1) {
            None => None,
            Some(level) => match distances.compare(level, &threshold)? {
                Comparison::Exceeds(witness) => Some(too_far(&witness, asked.spread)),
                Comparison::Within | Comparison::Undecided(_) => None,
            },
        };
        let (shifts, caps) = (vec![distances.shift().clone()], distances.caps());
        let place = Place::of(&[mask], parametrisation, shifts);
        let levels = if asked.levels { levels(distances, depth.upper, asked) } else { Vec::new() };
        Ok(Exact { place, depth, distance, too_far, levels, caps })
    }

    /// All facts about the depth.
    pub(super) fn facts(&self) -> Vec<(String, String)> {
        let whom = self.place.whom();
        let mut facts = vec![
            ("exact depth".to_owned(), depth_text(self.depth, whom, &self.caps)),
            ("points of level k at".to_owned(), self.place.text()),
            (format!("distance C_{}·β", self.depth.upper), self.distance.text(&self.caps)),
        ];
        if let Some(TooFar { level, text, .. }) = &self.too_far {
            facts.push((format!("too far at level {level}"), text.clone()));
        }
        facts
    }

    /// The depth alone.
    pub(super) fn depth_text(&self) -> String {
        depth_text(self.depth, self.place.whom(), &self.caps)
    }

    /// The depth, and where the points are.
    pub(super) fn short(&self) -> String {
        let depth = depth_text(self.depth, self.place.whom(), &self.caps);
        format!("with the points at {}, {depth}", self.place.parameters())
    }

    pub(super) fn form(&self) -> form::Exactly<'_> {
        form::Exactly {
            depth: depth_form(self.depth),
            offsets: &self.place.offsets,
            shifts: self.place.shifts.iter().map(Rational::to_string).collect(),
            keeps_lines: &self.place.keeps_lines,
            distance: distance_form(&self.distance, self.depth.upper),
            witness: self.too_far.as_ref().map(|too_far| &too_far.form),
        }
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

pub(super) fn depth_text(depth: TwoSidedDepth, whom: &str, caps: &str) -> String {
    let TwoSidedDepth { lower, upper } = depth;
    if lower == upper {
        return format!("{}, for {whom}{}", numbers::levels(upper), too_few(lower));
    }
    let below = too_few(lower);
    format!(
        "from {lower} to {upper} levels, for {whom}{below}; the caps of the search leave it open: {caps}"
    )
}

fn too_few(lower: u32) -> String {
    if lower == 0 { String::new() } else { numbers::too_few(lower - 1) }
}

pub(super) fn depth_form(depth: TwoSidedDepth) -> form::TwoSided {
    let TwoSidedDepth { lower, upper } = depth;
    form::TwoSided { level: upper, lower, upper, minimal: lower == upper }
}

pub(super) fn distance_form(distance: &Known, level: u32) -> form::Distance {
    form::Distance {
        interval: interval_form(&distance.enclosure),
        level,
        within_width: distance.narrow,
        parameter: distance.parameter.as_ref().map(Rational::to_string),
    }
}

fn too_far(witness: &Witness, spread: &Rational) -> TooFar {
    let Witness { polygon, parameter, level, distance } = witness;
    let distance = distance * spread;
    let text = format!(
        "β times {}, from index {}: {} from its limit at t = {parameter}",
        points_text(&polygon.points),
        polygon.first,
        short(&distance, 9)
    );
    let form = form::Witness::Polygon {
        level: *level,
        first: polygon.first,
        points: polygon.points.clone(),
        times: spread.to_string(),
        parameter: parameter.to_string(),
        distance: ExactForm::of(&distance),
    };
    let attained = Attained {
        control: Control::Polygon(polygon.clone()),
        place: AttainedAt::Parameter(parameter.clone()),
        value: witness.distance.clone().into(),
    };
    TooFar { level: *level, text, form, attained }
}

/// Points; of many, the first ones.
pub(super) fn points_text(points: &[i64]) -> String {
    let shown = points.iter().take(MAX_SHOWN_POINTS).map(i64::to_string);
    let more = if points.len() > MAX_SHOWN_POINTS { " … (all in --format json)" } else { "" };
    format!("{}{more}", shown.collect::<Vec<_>>().join(" "))
}
