//! The true depth of one control polygon.

use super::distance::{Distance, Interval, TwoSided};
use super::points::Points;
use super::sets::Sets;
use crate::cli::console::answer::OrNone;
use crate::cli::console::quantity::{Fraction, Text, above};
use serde::Serialize;
use subcert::exact::{Enclosure, Rational};
use subcert::limit::{Comparison, Distances, LimitError};
use subcert::report::html::FarPolygon;
use subcert::scheme::Mask;

/// A control polygon.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct Polygon {
    /// How many points the polygon has.
    pub(super) points: usize,
    /// How many coordinates a point has.
    pub(super) coordinates: usize,
    /// Whether the last point is followed by the first.
    pub(super) closed: bool,
    /// What is to be told of the file.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) notes: Vec<String>,
    /// Its depth by the distance of sets of points; null for points of one coordinate and with
    /// `--distance parametric`.
    pub(super) sets: Option<OrNone<Sets>>,
    /// Its depth with each point of level k at its natural parameter.
    pub(super) natural: OrNone<OfPolygon>,
    /// The depth with each point of level k at i/n^k.
    pub(super) indexed: OrNone<OfPolygon>,
}

impl Polygon {
    pub(super) fn words(&self) -> String {
        let ends = if self.closed { "closed" } else { "open" };
        let coordinates = match self.coordinates {
            1 => String::new(),
            several => format!(" of {several} coordinates"),
        };
        format!("{} points{coordinates}, {ends}", self.points)
    }
}

/// The depth of a control polygon.
#[derive(Clone, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct OfPolygon {
    /// The depth; its fields stand here.
    #[serde(flatten)]
    depth: TwoSided,
    /// Its distance at the upper side of the depth.
    distance: DistanceOfPolygon,
    /// A place at which it is too far from its limit at the level below the depth.
    too_far: Option<TooFar>,
    /// The caps of the search.
    #[serde(skip)]
    caps: String,
}

/// The distance of a control polygon: the greatest of its coordinates.
#[derive(Clone, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct DistanceOfPolygon {
    /// The distance; its fields stand here.
    #[serde(flatten)]
    distance: Distance,
    /// The coordinate with that distance, counted from 1.
    coordinate: usize,
}

/// A place at which a control polygon is too far from its limit.
#[derive(Clone, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct TooFar {
    /// The level.
    level: u32,
    /// The coordinate, counted from 1.
    coordinate: usize,
    /// The parameter.
    parameter: Text<Rational>,
    /// The distance there.
    distance: Fraction,
}

impl OfPolygon {
    pub(super) fn of(
        distances: &Distances,
        points: &Points,
        tolerance: &Rational,
        width: &Rational,
    ) -> Result<OfPolygon, LimitError> {
        let depth = distances.depth_of_points(&points.coordinates, tolerance)?;
        let distance = DistanceOfPolygon::of(distances, points, depth.upper, width)?;
        let mut too_far = None;
        if let Some(level) = depth.lower.checked_sub(1) {
            for (coordinate, polygon) in (1..).zip(&points.coordinates) {
                let compared = distances.compare_polygon(polygon, level, tolerance)?;
                if let Comparison::Exceeds((parameter, distance)) = compared {
                    let (parameter, distance) = (Text(parameter), Fraction(distance));
                    too_far = Some(TooFar { level, coordinate, parameter, distance });
                    break;
                }
            }
        }
        Ok(OfPolygon { depth: depth.into(), distance, too_far, caps: distances.caps() })
    }

    /// `name` stands before the depth; `coordinates` is how many there are.
    pub(super) fn facts(
        &self,
        coordinates: usize,
        name: &str,
        tolerance: &Rational,
    ) -> Vec<(String, String)> {
        let of = |coordinate: usize| match coordinates {
            1 => String::new(),
            _ => format!(" in coordinate {coordinate}"),
        };
        let DistanceOfPolygon { distance, coordinate } = &self.distance;
        let word = if distance.interval.0.width().is_zero() { "at" } else { "near" };
        let place = distance.parameter.as_ref();
        let place = place.map(|t| format!(", {word} t = {t}{}", of(*coordinate)));
        let text = format!("{}{}", distance.words(&self.caps), place.unwrap_or_default());
        let mut facts = vec![
            (name.to_owned(), self.depth_text()),
            (format!("its distance at level {}", distance.level), text),
        ];
        if let Some(TooFar { level, coordinate, parameter, distance }) = &self.too_far {
            let text = format!(
                "{} from its limit at t = {parameter}{}",
                above(&distance.0, tolerance),
                of(*coordinate)
            );
            facts.push((format!("too far at level {level}"), text));
        }
        facts
    }

    /// Where the polygon is far from its limit: too far at the level below the depth, or else as far as it is at the
    /// depth.
    pub(super) fn far<'f>(
        &'f self,
        mask: &'f Mask,
        points: &'f Points,
        shift: &'f Rational,
    ) -> Option<FarPolygon<'f>> {
        let (level, coordinate, parameter, distance) = if let Some(far) = &self.too_far {
            (far.level, far.coordinate, &far.parameter, &far.distance.0)
        } else {
            let DistanceOfPolygon { distance, coordinate } = &self.distance;
            let parameter = distance.parameter.as_ref()?;
            (distance.level, *coordinate, parameter, distance.interval.0.lower())
        };
        Some(FarPolygon {
            mask,
            coordinates: &points.numbers,
            closed: points.closed,
            shift,
            level,
            coordinate: coordinate - 1,
            parameter: &parameter.0,
            distance,
        })
    }

    /// The depth alone.
    pub(super) fn depth_text(&self) -> String {
        self.depth.words("this polygon", &self.caps)
    }
}

impl DistanceOfPolygon {
    /// The distance at a level: the greatest of all coordinates, and which that is.
    fn of(
        distances: &Distances,
        points: &Points,
        level: u32,
        width: &Rational,
    ) -> Result<DistanceOfPolygon, LimitError> {
        let interval = Interval(Enclosure::exact(Rational::zero()));
        let none = Distance { interval, level, within_width: true, parameter: None };
        let mut greatest = DistanceOfPolygon { distance: none, coordinate: 1 };
        for (coordinate, polygon) in (1..).zip(&points.coordinates) {
            let own = Distance::of(distances.of_polygon(polygon, level, width), level)?;
            let [one, other] = [&own, &greatest.distance].map(|distance| &distance.interval.0);
            let upper = one.upper().max(other.upper()).clone();
            let within_width = own.within_width && greatest.distance.within_width;
            if one.lower() > other.lower() {
                greatest = DistanceOfPolygon { distance: own, coordinate };
            }
            let lower = greatest.distance.interval.0.lower().clone();
            greatest.distance.interval = Interval(Enclosure::new(lower, upper));
            greatest.distance.within_width = within_width;
        }
        Ok(greatest)
    }
}
