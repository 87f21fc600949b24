//! Data of a curve that exceed a bound: control polygon, level k, limit, and the place.

use super::super::curve::{Level, Window, levels};
use super::super::frame::{Frame, picture, points};
use super::super::line::{Line, float};
use super::super::scale::Scale;
use super::exceeding::{Exceeding, SEEN};
use crate::audit::Place;
use crate::claim::Quantity;
use crate::exact::Rational;
use crate::float::nearest;
use crate::limit::ExtremalPolygon;
use crate::scheme::Mask;
use maud::{Markup, html};

/// How far the picture reaches to both sides of the place, in control points.
const REACH: f64 = 4.0;

const HEIGHT: f64 = 300.0;
const FRAME: Frame = Frame { x: (56.0, 540.0), y: (264.0, 12.0) };

/// What is drawn at the place: the two values whose distance is bounded.
struct Shown<'l> {
    ends: [(f64, f64); 2],
    /// The polygon of level k, and what it is compared with.
    polygons: [(&'l Level, String); 2],
}

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
        Some((levels(mask, control.clone(), exceeding.level, window)?, window))
    })?;
    let shown = shown(&found, exceeding)?;
    let says = exceeding.says("polygon", &shown.polygons[1].1);
    let drawing = drawn(polygon, &found[0], &shown, window);
    Some(html! {
        figure {
            (picture("Control polygon, level and limit", &says, HEIGHT, &drawing))
            figcaption { (says) }
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
fn shown<'l>(found: &'l [Level], exceeding: &Exceeding<'_>) -> Option<Shown<'l>> {
    let k = usize::try_from(exceeding.level).ok()?;
    let (level, next, last) = (found.get(k)?, found.get(k + 1)?, found.last()?);
    let after = format!("level {}", next.k);
    Some(match (exceeding.quantity, &exceeding.attained.place) {
        (Quantity::Distance, Place::Parameter(t)) => {
            let t = nearest(t);
            let ends = [(t, level.at(t)), (t, last.at(t))];
            Shown { ends, polygons: [(level, String::new()), (last, "limit".to_owned())] }
        }
        (Quantity::Step, Place::Point(i)) => {
            let t = next.parameter(*i);
            let ends = [(t, level.at(t)), (t, next.point(*i))];
            Shown { ends, polygons: [(level, String::new()), (next, after)] }
        }
        (Quantity::Difference, Place::Difference(i)) => {
            let end = |i: i64| (level.parameter(i), level.point(i));
            let polygons = [(level, String::new()), (last, "limit".to_owned())];
            Shown { ends: [end(*i), end(*i + 1)], polygons }
        }
        _ => return None,
    })
}

fn drawn(polygon: &ExtremalPolygon, control: &Level, shown: &Shown<'_>, window: Window) -> Markup {
    let window = window.ends();
    let lines =
        [control, shown.polygons[0].0, shown.polygons[1].0].map(|level| level.between(window));
    let values = || lines.iter().flatten().map(|(_, value)| *value);
    let (low, high) = (values().fold(f64::MAX, f64::min), values().fold(f64::MIN, f64::max));
    let y = Scale::new((low, high), (FRAME.y.0 - 12.0, FRAME.y.1 + 12.0), false);
    let x = Scale::new(window, FRAME.x, false);
    let place = |(t, value): &(f64, f64)| (x.at(*t), y.at(*value));
    let path = |line: &[(f64, f64)]| points(&line.iter().map(place).collect::<Vec<_>>());
    let indices = (polygon.first - 8..).take(polygon.points.len() + 16);
    let vertices = indices.map(|i| (control.parameter(i), control.point(i)));
    let vertices: Vec<(f64, f64)> =
        vertices.filter(|(t, _)| *t >= window.0 && *t <= window.1).collect();
    let ticks: Vec<(f64, String)> =
        x.ticks().into_iter().map(|(value, label)| (x.at(value), label)).collect();
    let [first, second] = shown.ends.map(|end| place(&end));
    let same = shown.polygons[0].0.k == 0;
    html! {
        (FRAME.drawn(&ticks, &y))
        g.c6 {
            polyline.dash points=(path(&lines[0])) {}
            @for vertex in &vertices {
                @let (x, y) = place(vertex);
                circle.dot cx=(x) cy=(y) r="3" {}
            }
        }
        @if !same { g.c1 { polyline.line points=(path(&lines[1])) {} } }
        g.c2 { polyline.line points=(path(&lines[2])) {} }
        line.bad x1=(first.0) y1=(first.1) x2=(second.0) y2=(second.1) {}
        circle.bad cx=(first.0) cy=(first.1) r="3.5" {}
        circle.bad cx=(second.0) cy=(second.1) r="3.5" {}
        @let right = FRAME.x.1 + 8.0;
        text.name.c6 x=(right) y="28" { "– – control" }
        @if !same { text.name.c1 x=(right) y="46" { "— level " (shown.polygons[0].0.k) } }
        text.name.c2 x=(right) y="64" { "— " (shown.polygons[1].1) }
        text.name x=(right) y="82" style="fill:var(--wrong-s)" { "o–o the place" }
    }
}
