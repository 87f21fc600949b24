//! Data of a curve that exceed a bound: control polygon, level k, limit, and the place.

use super::super::curve::{FINER, Level, Window, levels};
use super::exceeding::{Exceeding, SEEN};
use crate::audit::Place;
use crate::claim::Quantity;
use crate::exact::Rational;
use crate::float::nearest;
use crate::limit::ExtremalPolygon;
use crate::report::html::picture::plane::frame::picture;
use crate::report::html::picture::plane::graph::{Graph, HEIGHT};
use crate::report::html::picture::plane::line::{Line, float};
use crate::report::html::typeset::typeset;
use crate::scheme::Mask;
use maud::{Markup, html};

/// How far the picture reaches to both sides of the place, in control points.
const REACH: f64 = 4.0;

/// A piece of a control polygon, with its points at i + s.
pub(super) fn drawing(
    mask: &Mask,
    polygon: &ExtremalPolygon,
    exceeding: &Exceeding<'_>,
) -> Option<Markup> {
    let windows = windows(mask, exceeding)?;
    let points = polygon.points.iter().map(|point| float(*point)).collect();
    let [shift, _] = exceeding.shift;
    let control = Level::control(Line { first: polygon.first, points }, shift);
    let (found, window) = windows.into_iter().find_map(|window| {
        Some((levels(mask, control.clone(), (exceeding.level, FINER), window)?, window))
    })?;
    let graph = graph(&found, exceeding)?;
    let says = exceeding.says("polygon", &graph.name);
    let drawing = graph.drawn(window);
    Some(html! {
        figure {
            (picture("Control polygon, level and limit", &says, HEIGHT, &drawing))
            figcaption { (typeset(&says)) }
        }
    })
}

/// The parts of the parameters that may be drawn, the best first: some control points on both sides of the
/// place, unless the distance would not be seen there, and some points of level k.
fn windows(mask: &Mask, exceeding: &Exceeding<'_>) -> Option<Vec<Window>> {
    let arity = Rational::from(mask.arity());
    let points = |level: u32| arity.pow(level.cast_signed());
    let k = exceeding.level;
    let t = match &exceeding.attained.place {
        Place::Parameter(t) => t.clone(),
        Place::Point(i) => Rational::from(*i) / points(k + 1),
        Place::Difference(i) => Rational::from(*i) / points(k),
        _ => return None,
    };
    let t = nearest(&t);
    let near = Window { t, reach: REACH / nearest(&points(k)) };
    let far = Window { t, reach: REACH };
    let is_seen = nearest(&exceeding.attained.value) >= SEEN;
    Some(if is_seen { vec![far, near] } else { vec![near] })
}

/// The place and what is compared there.
fn graph<'l>(found: &'l [Level], exceeding: &Exceeding<'_>) -> Option<Graph<'l>> {
    let k = usize::try_from(exceeding.level).ok()?;
    let (control, level, next, last) =
        (found.first()?, found.get(k)?, found.get(k + 1)?, found.last()?);
    let limit = "limit".to_owned();
    let (ends, other, name) = match (exceeding.quantity, &exceeding.attained.place) {
        (Quantity::Distance, Place::Parameter(t)) => {
            let t = nearest(t);
            ([(t, level.at(t)), (t, last.at(t))], last, limit)
        }
        (Quantity::Step, Place::Point(i)) => {
            let t = next.parameter(*i);
            ([(t, level.at(t)), (t, next.point(*i))], next, format!("level {}", next.k))
        }
        (Quantity::Difference, Place::Difference(i)) => {
            let end = |i: i64| (level.parameter(i), level.point(i));
            ([end(*i), end(*i + 1)], last, limit)
        }
        _ => return None,
    };
    Some(Graph { control, ends, level, other, name })
}
