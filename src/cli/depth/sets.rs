//! The depth of one control polygon by the distance of polygon and limit as sets of points.

use super::certified;
use super::distance::AsSets;
use super::numbers::{found, point as point_text};
use super::points::Points;
use crate::cli::console::answer::OrNone;
use crate::cli::console::output::Failure;
use crate::cli::console::quantity::{Float, Text};
use serde::Serialize;
use std::path::Path;
use subcert::bound::Budget;
use subcert::exact::Rational;
use subcert::limit::{Limit, LimitError};
use subcert::patch::{CurvePlace, CurveSets, SetKind};
use subcert::scheme::Mask;

/// The depth of a control polygon by the distance of polygon and limit.
pub(super) type Sets = AsSets<SetPlace>;

/// A point of one set that is far from the other.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct SetPlace {
    /// `polygon` or `limit`.
    from: &'static str,
    /// Its natural parameter.
    parameter: Text<Rational>,
    /// The point, to f64.
    point: Vec<Float>,
    /// The point is at least so far from the other set.
    distance: Float,
    #[serde(skip)]
    other: &'static str,
}

impl From<CurvePlace> for SetPlace {
    fn from(place: CurvePlace) -> SetPlace {
        let [from, other] = match place.from {
            SetKind::Mesh => ["polygon", "limit"],
            SetKind::Limit => ["limit", "polygon"],
        };
        let found = found(place.point.iter().chain([&place.distance]));
        let point = place.point.iter().copied().map(found).collect();
        let (parameter, distance) = (Text(place.parameter), Float(place.distance));
        SetPlace { from, parameter, point, distance, other }
    }
}

/// The depth of a polygon with this mask.
pub(super) fn of_sets(
    mask: &Mask,
    points: &Points,
    tolerance: &Rational,
    budget: Budget,
    certificate: Option<&Path>,
) -> Result<OrNone<Sets>, Failure> {
    let depth = || {
        let limit = Limit::new(mask)?;
        let sets = CurveSets::new(&limit, &points.numbers, points.closed)?;
        let mut sets = sets.with_budget(budget);
        let found = sets.depth(tolerance)?;
        Ok((sets, found))
    };
    match (depth(), certificate) {
        (Err(error @ LimitError::TooFew { .. }), _) => {
            Err(Failure::Input(format!("--polygon: {error}")))
        }
        (Err(error), Some(_)) => Err(certified::none(&format!("there is none here: {error}"))),
        (Err(error), None) => Ok(OrNone::None { none: error.to_string() }),
        (Ok((sets, found)), path) => {
            if let Some(path) = path {
                certified::of_polygon(path, mask, &sets, &found, &points.numbers, tolerance)?;
            }
            Ok(OrNone::Found(AsSets::of(found, SetPlace::from)))
        }
    }
}

/// The depth in words.
pub(super) fn sets_text(found: &Sets) -> String {
    found.words(", as sets of points")
}

pub(super) fn facts(found: &OrNone<Sets>, tolerance: &Rational) -> Vec<(String, String)> {
    let name = "depth of the polygon".to_owned();
    let found = match found {
        OrNone::Found(found) => found,
        OrNone::None { none } => return vec![(name, format!("none: {none}"))],
    };
    let far = found.beyond().map(|(level, place)| {
        let SetPlace { from, parameter, point, distance, other } = place;
        let (point, distance) = (point_text(point), distance.above(tolerance));
        let text = format!(
            "{point} of the {from}, at t = {parameter}, is at least {distance} from the {other}"
        );
        (format!("too far at level {level}"), text)
    });
    [(name, sets_text(found))].into_iter().chain(far).collect()
}
