//! Data around a vertex or on a face that exceed a bound: control ring, level k and limit, and the place.
//!
//! Points of all levels stand above the same places, as they are compared by their names.

use super::super::ring_places::places;
use super::super::space::{Scene, Views};
use super::exceeding::Exceeding;
use crate::audit::Place;
use crate::claim::Quantity;
use crate::float::nearest;
use crate::report::html::picture::plane::frame::picture;
use crate::report::html::picture::plane::legend::legend;
use crate::report::html::picture::plane::line::float;
use crate::report::html::typeset::typeset;
use crate::scheme::LocalRules;
use maud::{Markup, html};

/// The most points of a ring that are drawn.
const MAX_POINTS: usize = 200;

/// The limit is a later level at which the points are so near to each other.
const NEAR: f64 = 1e-9;

/// The most levels until then.
const MAX_LEVELS: u32 = 2_000;

/// How high the values are, by the width of the ring.
const HIGH: f64 = 1.1;

/// How much the drawn distance may differ from the exact one: it does where another quantity is bounded, such
/// as the distance from an interpolant.
const SAME: f64 = 1e-6;

/// The values of two levels that are compared, and between which of their points.
struct Drawn {
    ends: [(usize, f64); 2],
    other: Vec<f64>,
    name: String,
}

/// A control ring, by the names and the values of its points.
pub(super) fn drawing(
    ring: &LocalRules,
    points: &[(String, i64)],
    exceeding: &Exceeding<'_>,
) -> Option<Markup> {
    if points.len() != ring.point_count() || points.len() > MAX_POINTS {
        return None;
    }
    let control: Vec<f64> = points.iter().map(|(_, height)| float(*height)).collect();
    let rules = ring.map(nearest);
    let refined = |points: &[f64]| rules.refine(points);
    let level = (0..exceeding.level).fold(control.clone(), |points, _| refined(&points));
    let next = refined(&level);
    let shown = shown(ring, &level, next, &refined, exceeding)?;
    let found = (shown.ends[0].1 - shown.ends[1].1).abs();
    if (found - nearest(&exceeding.attained.value)).abs() > SAME {
        return None;
    }
    let says = exceeding.says("ring", &shown.name);
    let (scene, height) =
        scene(ring, [&control, &level], &shown, exceeding.level).drawn(Views::Above);
    let mut names = vec![("c6", "control ring".to_owned()), ("c2", shown.name)];
    if exceeding.level > 0 {
        names.insert(1, ("c1", format!("level {}", exceeding.level)));
    }
    let (legend, height) = legend(&names, height);
    let drawing = html! { (scene) (legend) };
    Some(html! {
        figure {
            (picture("Control ring, level and limit", &says, height, &drawing))
            figcaption { (typeset(&says)) " Heights are values; points of one name stand above one place. Seen from two sides." }
        }
    })
}

/// What is compared at the place.
fn shown(
    ring: &LocalRules,
    level: &[f64],
    next: Vec<f64>,
    refined: &impl Fn(&[f64]) -> Vec<f64>,
    exceeding: &Exceeding<'_>,
) -> Option<Drawn> {
    let point = |name: &str| (0..ring.point_count()).find(|point| ring.name(*point) == name);
    match (exceeding.quantity, &exceeding.attained.place) {
        (Quantity::Distance, Place::Named(name)) => {
            let (a, limit) = (point(name)?, limit(next, refined)?);
            let ends = [(a, level[a]), (a, limit)];
            Some(Drawn { ends, other: vec![limit; level.len()], name: "limit".to_owned() })
        }
        (Quantity::Step, Place::Named(name)) => {
            let a = point(name)?;
            let name = format!("level {}", exceeding.level + 1);
            Some(Drawn { ends: [(a, level[a]), (a, next[a])], other: next, name })
        }
        (Quantity::Difference, Place::Edge([one, other])) => {
            let ends = [point(one)?, point(other)?].map(|a| (a, level[a]));
            let limit = limit(next, refined)?;
            Some(Drawn { ends, other: vec![limit; level.len()], name: "limit".to_owned() })
        }
        _ => None,
    }
}

/// The value to which all points tend.
fn limit(points: Vec<f64>, refined: &impl Fn(&[f64]) -> Vec<f64>) -> Option<f64> {
    let mut points = points;
    for _ in 0..MAX_LEVELS {
        let ends =
            points.iter().fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(*x), high.max(*x)));
        if ends.1 - ends.0 <= NEAR {
            return Some(f64::midpoint(ends.0, ends.1));
        }
        points = refined(&points);
    }
    None
}

fn scene(ring: &LocalRules, [control, level]: [&[f64]; 2], shown: &Drawn, k: u32) -> Scene {
    let places = places(ring);
    let values = control.iter().chain(level).chain(&shown.other);
    let (low, high) =
        values.fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(*x), high.max(*x)));
    let scale = HIGH / (high - low).max(f64::MIN_POSITIVE);
    let at = |a: usize, value: f64| [places[a][0], places[a][1], scale * (value - low)];
    let mut scene = Scene::default();
    let mut edges = |values: &[f64], class: &str| {
        for &(a, b) in ring.edges() {
            scene.line(vec![at(a, values[a]), at(b, values[b])], class);
        }
    };
    edges(control, "net c6");
    if k > 0 {
        edges(level, "line c1");
    }
    edges(&shown.other, "line c2");
    scene.mark(shown.ends.map(|(a, value)| at(a, value)));
    scene
}
