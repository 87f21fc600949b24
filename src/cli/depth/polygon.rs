//! The true depth of one control polygon.

use super::exact::{Known, depth_form, depth_text, distance_form};
use crate::cli::json::depth as form;
use subcert::exact::{Enclosure, Rational, format::short};
use subcert::limit::{Comparison, ControlPolygon, Distances, LimitError, TwoSidedDepth};
use subcert::patch::relative_tolerance;
use subcert::report::html::FarPolygon;
use subcert::report::json::Exact;
use subcert::scheme::Mask;

/// A control polygon of points.
pub(super) struct Points {
    /// One polygon of numbers for each coordinate.
    pub(super) coordinates: Vec<ControlPolygon>,
    /// Its points: all x, then all y, and so on.
    pub(super) numbers: Vec<Vec<Rational>>,
    /// How many points there are.
    pub(super) count: usize,
    pub(super) closed: bool,
}

impl Points {
    /// The polygon of these coordinates: all x, then all y, and so on.
    pub(super) fn new(coordinates: &[Vec<Rational>], closed: bool) -> Points {
        let polygon = |points: &Vec<Rational>| {
            if closed { ControlPolygon::closed(points) } else { ControlPolygon::open(points) }
        };
        let count = coordinates.first().map_or(0, Vec::len);
        let numbers = coordinates.to_vec();
        Points { coordinates: coordinates.iter().map(polygon).collect(), numbers, count, closed }
    }

    /// The largest difference of neighbouring points in any coordinate.
    pub(super) fn spread(&self) -> Rational {
        self.coordinates.iter().map(ControlPolygon::spread).max().unwrap_or_else(Rational::zero)
    }

    /// This part of the diagonal of the box around the points.
    pub(super) fn share_of_diagonal(&self, share: &Rational) -> Option<Rational> {
        let point = |i: usize| self.numbers.iter().map(|own| own[i].clone()).collect();
        let points: Vec<Vec<Rational>> = (0..self.count).map(point).collect();
        relative_tolerance(&points, share)
    }

    pub(super) fn text(&self) -> String {
        let ends = if self.closed { "closed" } else { "open" };
        let coordinates = match self.coordinates.len() {
            1 => String::new(),
            several => format!(" of {several} coordinates"),
        };
        format!("{} points{coordinates}, {ends}", self.count)
    }
}

/// How many levels the polygon needs.
pub(super) struct OfPolygon {
    depth: TwoSidedDepth,
    /// The distance at the upper side of the depth, the greatest of all coordinates.
    distance: Known,
    /// The coordinate of the parameter of that distance, counted from 0.
    coordinate: usize,
    too_far: Option<TooFar>,
    /// The caps of the search.
    caps: String,
}

/// A coordinate that is too far from its limit at the level below the depth.
struct TooFar {
    level: u32,
    coordinate: usize,
    parameter: Rational,
    distance: Rational,
}

impl OfPolygon {
    pub(super) fn of(
        distances: &Distances,
        points: &Points,
        tolerance: &Rational,
        width: &Rational,
    ) -> Result<OfPolygon, LimitError> {
        let depth = distances.depth_of_points(&points.coordinates, tolerance)?;
        let (distance, coordinate) = greatest(distances, points, depth.upper, width)?;
        let mut too_far = None;
        if let Some(level) = depth.lower.checked_sub(1) {
            for (coordinate, polygon) in points.coordinates.iter().enumerate() {
                let compared = distances.compare_polygon(polygon, level, tolerance)?;
                if let Comparison::Exceeds((parameter, distance)) = compared {
                    too_far = Some(TooFar { level, coordinate, parameter, distance });
                    break;
                }
            }
        }
        Ok(OfPolygon { depth, distance, coordinate, too_far, caps: distances.caps() })
    }

    /// `name` stands before the depth.
    pub(super) fn facts(&self, points: &Points, name: &str) -> Vec<(String, String)> {
        let of = |coordinate: usize| match points.coordinates.len() {
            1 => String::new(),
            _ => format!(" in coordinate {}", coordinate + 1),
        };
        let place = self.distance.parameter.as_ref();
        let word = if self.distance.enclosure.width().is_zero() { "at" } else { "near" };
        let place = place.map(|t| format!(", {word} t = {t}{}", of(self.coordinate)));
        let distance = format!("{}{}", self.distance.text(&self.caps), place.unwrap_or_default());
        let mut facts = vec![
            (name.to_owned(), depth_text(self.depth, "this polygon", &self.caps)),
            (format!("its distance at level {}", self.depth.upper), distance),
        ];
        if let Some(TooFar { level, coordinate, parameter, distance }) = &self.too_far {
            let text = format!(
                "{} from its limit at t = {parameter}{}",
                short(distance, 9),
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
            (far.level, far.coordinate, &far.parameter, &far.distance)
        } else {
            let parameter = self.distance.parameter.as_ref()?;
            (self.depth.upper, self.coordinate, parameter, self.distance.enclosure.lower())
        };
        let (coordinates, closed) = (&points.numbers[..], points.closed);
        Some(FarPolygon {
            mask,
            coordinates,
            closed,
            shift,
            level,
            coordinate,
            parameter,
            distance,
        })
    }

    /// The depth alone.
    pub(super) fn depth_text(&self) -> String {
        depth_text(self.depth, "this polygon", &self.caps)
    }

    pub(super) fn form(&self) -> form::OfPolygon {
        let too_far = |too_far: &TooFar| form::TooFar {
            level: too_far.level,
            coordinate: too_far.coordinate + 1,
            parameter: too_far.parameter.to_string(),
            distance: Exact::of(&too_far.distance),
        };
        form::OfPolygon {
            depth: depth_form(self.depth),
            distance: form::DistanceOfPolygon {
                distance: distance_form(&self.distance, self.depth.upper),
                coordinate: self.coordinate + 1,
            },
            too_far: self.too_far.as_ref().map(too_far),
        }
    }
}

/// The distance at a level: the greatest of all coordinates, and which that is.
fn greatest(
    distances: &Distances,
    points: &Points,
    level: u32,
    width: &Rational,
) -> Result<(Known, usize), LimitError> {
    let zero = Enclosure::exact(Rational::zero());
    let mut greatest = (Known { enclosure: zero, narrow: true, parameter: None }, 0);
    for (coordinate, polygon) in points.coordinates.iter().enumerate() {
        let own = Known::of(distances.of_polygon(polygon, level, width))?;
        let upper = own.enclosure.upper().max(greatest.0.enclosure.upper()).clone();
        let narrow = own.narrow && greatest.0.narrow;
        if own.enclosure.lower() > greatest.0.enclosure.lower() {
            greatest = (own, coordinate);
        }
        let lower = greatest.0.enclosure.lower().clone();
        greatest.0.enclosure = Enclosure::new(lower, upper);
        greatest.0.narrow = narrow;
    }
    Ok(greatest)
}
