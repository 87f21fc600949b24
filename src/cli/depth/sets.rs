//! The depth of one control polygon by the distance of polygon and limit as sets of points.

use super::numbers::{digits, few_text, levels, point as point_text};
use super::polygon::Points;
use crate::cli::json::depth as form;
use crate::cli::output::Failure;
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
) -> Result<OfSets, Failure> {
    let depth = || {
        let limit = Limit::new(mask)?;
        let sets = CurveSets::new(&limit, &points.numbers, points.closed)?;
        sets.with_budget(budget).depth(tolerance)
    };
    match depth() {
        Err(error @ LimitError::TooFew { .. }) => {
            Err(Failure::Input(format!("--polygon: {error}")))
        }
        found => Ok(found.map_err(|error| error.to_string())),
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
pub(super) fn depth_text(found: &CurveDepth) -> String {
    format!("{}, as sets of points{}", levels(found.level), few_text(found))
}

pub(super) fn facts(found: &OfSets) -> Vec<(String, String)> {
    let name = "depth of the polygon".to_owned();
    let found = match found {
        Ok(found) => found,
        Err(why) => return vec![(name, format!("none: {why}"))],
    };
    let mut facts = vec![(name, depth_text(found))];
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
            too_few: found.too_few,
            too_far: found.beyond.as_ref().map(place),
        }),
    }
}
