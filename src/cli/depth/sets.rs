//! The depth of one control polygon by the distance of polygon and limit as sets of points.

use super::certified;
use super::numbers::{depth_text, digits, point as point_text};
use super::polygon::Points;
use crate::cli::console::output::Failure;
use crate::cli::json::depth as form;
use std::path::Path;
use subcert::bound::Budget;
use subcert::exact::Rational;
use subcert::float::shortest;
use subcert::limit::{Limit, LimitError};
use subcert::patch::{CurveDepth, CurvePlace, CurveSets, SetKind};
use subcert::scheme::Mask;

/// The answer; the error says why there is none.
pub(super) type OfSets = Result<CurveDepth, String>;

/// The depth of a polygon with this mask.
pub(super) fn of_sets(
    mask: &Mask,
    points: &Points,
    tolerance: &Rational,
    budget: Budget,
    certificate: Option<&Path>,
) -> Result<OfSets, Failure> {
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
        (Err(error), None) => Ok(Err(error.to_string())),
        (Ok((sets, found)), path) => {
            if let Some(path) = path {
                certified::of_polygon(path, mask, &sets, &found, &points.numbers, tolerance)?;
            }
            Ok(Ok(found))
        }
    }
}

/// The name of a set, and that of the other.
fn names(set: SetKind) -> [&'static str; 2] {
    match set {
        SetKind::Mesh => ["polygon", "limit"],
        SetKind::Limit => ["limit", "polygon"],
    }
}

/// The depth in words.
pub(super) fn sets_text(found: &CurveDepth) -> String {
    depth_text(found, ", as sets of points")
}

pub(super) fn facts(found: &OfSets) -> Vec<(String, String)> {
    let name = "depth of the polygon".to_owned();
    let found = match found {
        Ok(found) => found,
        Err(why) => return vec![(name, format!("none: {why}"))],
    };
    let mut facts = vec![(name, sets_text(found))];
    if let (Some(level), Some(place)) = (found.too_few, &found.beyond) {
        let CurvePlace { from, parameter, point, distance } = place;
        let [from, other] = names(*from);
        let text = format!(
            "{} of the {from}, at t = {parameter}, is at least {} from the {other}",
            point_text(point),
            digits(*distance)
        );
        facts.push((format!("too far at level {level}"), text));
    }
    facts
}

pub(super) fn sets_form(found: &OfSets) -> form::OrNone<form::Sets> {
    let place = |place: &CurvePlace| form::SetPlace {
        from: names(place.from)[0],
        parameter: place.parameter.to_string(),
        point: place.point.iter().map(|x| shortest(*x)).collect(),
        distance: shortest(place.distance),
    };
    match found {
        Err(why) => form::OrNone::None { none: why.clone() },
        Ok(found) => form::OrNone::Found(form::Sets {
            level: found.level,
            ended: found.ended.clone(),
            too_few: found.too_few,
            too_far: found.beyond.as_ref().map(place),
        }),
    }
}
