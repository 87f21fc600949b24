//! A control polygon with its limit, and the place where a level is farthest from it.

use super::curve::{FINER, Level, Window, levels};
use super::space::{Scene, Views};
use crate::exact::{Rational, format::short};
use crate::float::nearest;
use crate::limit::determined;
use crate::report::html::picture::plane::frame::{WIDTH, picture, points};
use crate::report::html::picture::plane::graph::{Graph, HEIGHT};
use crate::report::html::picture::plane::line::{Line, float, index};
use crate::report::html::picture::plane::scale::Scale;
use crate::report::html::typeset::typeset;
use crate::scheme::Mask;
use maud::{Markup, html};

/// How many points the limit has in a picture of the whole polygon, at most.
const DRAWN: f64 = 4_000.0;

/// How many times the limit of the whole polygon is finer than the control polygon.
const WHOLE_FINER: f64 = 64.0;

/// How far the picture of the place reaches, in points of the level.
const REACH: f64 = 1.0;

/// The most points of a polygon with a picture of the whole of it.
const MAX_POINTS: usize = 1_500;

/// A control polygon, and where one of its coordinates is far from its limit.
#[derive(Clone, Debug)]
pub struct FarPolygon<'p> {
    /// The mask.
    pub mask: &'p Mask,
    /// All x, then all y, and so on.
    pub coordinates: &'p [Vec<Rational>],
    /// Whether the last point is followed by the first.
    pub closed: bool,
    /// Point i of level k is at (i + s)/n^k with this s.
    pub shift: &'p Rational,
    /// k.
    pub level: u32,
    /// The coordinate, counted from 0.
    pub coordinate: usize,
    /// The parameter.
    pub parameter: &'p Rational,
    /// The distance there.
    pub distance: &'p Rational,
}

/// Pictures: of points of the plane or of space the whole polygon, and the graphs of one coordinate near the place.
pub(crate) fn control_polygon(polygon: &FarPolygon<'_>) -> Vec<Markup> {
    whole(polygon).into_iter().chain(near(polygon)).collect()
}

impl FarPolygon<'_> {
    fn count(&self) -> i64 {
        i64::try_from(self.coordinates.first().map_or(0, Vec::len)).unwrap_or(i64::MAX)
    }

    /// A coordinate, as far beyond the window as the limit depends on it.
    fn control(&self, coordinate: usize, window: Window) -> Option<Level> {
        let points: Vec<f64> = self.coordinates.get(coordinate)?.iter().map(nearest).collect();
        let count = self.count();
        let line = if self.closed {
            let rules = self.mask.rules();
            let around = 4 * (i64::try_from(rules.width()).ok()? + rules.offset().abs() + 4);
            let (from, to) = window.ends();
            let (from, to) = (index(from.floor()) - around, index(to.ceil()) + around);
            let at = |i: i64| usize::try_from(i.rem_euclid(count)).unwrap_or(0);
            Line { first: from, points: (from..=to).map(|i| points[at(i)]).collect() }
        } else {
            Line { first: 0, points }
        };
        Some(Level::control(line, nearest(self.shift)))
    }

    /// The parameters between which the limit is drawn, if the points determine any of it.
    fn range(&self) -> Option<(f64, f64)> {
        let count = self.coordinates.first().map_or(0, Vec::len);
        if self.closed {
            return Some((0.0, float(self.count())));
        }
        let [start, end] = determined(self.mask, self.shift, count).ok()?;
        Some((nearest(&start), nearest(&end)))
    }
}

/// The graphs of the coordinate near the place.
fn near(polygon: &FarPolygon<'_>) -> Option<Markup> {
    let k = polygon.level;
    let scale = nearest(&Rational::from(polygon.mask.arity()).pow(k.cast_signed()));
    let t = nearest(polygon.parameter);
    let window = Window { t, reach: REACH / scale };
    let control = polygon.control(polygon.coordinate, window)?;
    let found = levels(polygon.mask, control, (k, FINER), window)?;
    let (level, limit) = (found.get(usize::try_from(k).ok()?)?, found.last()?);
    let ends = [(t, level.at(t)), (t, limit.at(t))];
    let graph = Graph { control: &found[0], ends, level, other: limit, name: "limit".to_owned() };
    let of = match polygon.coordinates.len() {
        1 => String::new(),
        _ => format!(" Coordinate {} is drawn against the parameter.", polygon.coordinate + 1),
    };
    let says = format!(
        "The control polygon, level {k} and the limit near t = {}, where level {k} is {} from the limit.{of}",
        short(polygon.parameter, 6),
        short(polygon.distance, 6)
    );
    Some(html! {
        figure {
            (picture("The place of the greatest distance", &says, HEIGHT, &graph.drawn(window)))
            figcaption { (typeset(&says)) }
        }
    })
}

/// The whole polygon and its limit.
fn whole(polygon: &FarPolygon<'_>) -> Option<Markup> {
    let dimension = polygon.coordinates.len();
    let count = polygon.count();
    if !(2..=3).contains(&dimension) || usize::try_from(count).ok()? > MAX_POINTS {
        return None;
    }
    let half = float(count) / 2.0;
    let window = Window { t: half, reach: half };
    let finer = (DRAWN / float(count)).clamp(2.0, WHOLE_FINER);
    let mut control = Vec::new();
    let mut limit = Vec::new();
    let mut level = 0;
    for coordinate in 0..dimension {
        let found = levels(polygon.mask, polygon.control(coordinate, window)?, (0, finer), window)?;
        let last = found.last()?;
        level = last.k;
        limit.push(last.between(polygon.range()?));
        let exact = polygon.coordinates[coordinate].iter().map(nearest);
        let first = polygon.closed.then(|| nearest(&polygon.coordinates[coordinate][0]));
        control.push(exact.chain(first).collect::<Vec<f64>>());
    }
    let place = |line: &[Vec<(f64, f64)>], i: usize| -> [f64; 3] {
        [0, 1, 2].map(|axis| line.get(axis).and_then(|line| line.get(i)).map_or(0.0, |(_, x)| *x))
    };
    let limit: Vec<[f64; 3]> = (0..limit[0].len()).map(|i| place(&limit, i)).collect();
    let corner = |i: usize| [0, 1, 2].map(|axis| control.get(axis).map_or(0.0, |line| line[i]));
    let control: Vec<[f64; 3]> = (0..control[0].len()).map(corner).collect();
    let far = far(polygon, window, level, finer)?;
    let says =
        "The control polygon, dashed, its limit, and on it the place of the greatest distance.";
    let (drawing, height) = if dimension == 2 {
        (flat(&control, &limit, far), 320.0)
    } else {
        let mut scene = Scene::default();
        control.windows(2).for_each(|pair| scene.line(pair.to_vec(), "dash c6"));
        limit.windows(2).for_each(|pair| scene.line(pair.to_vec(), "line c2"));
        scene.mark([far; 2]);
        scene.drawn(Views::Opposite)
    };
    Some(html! {
        figure {
            (picture("Control polygon and limit", says, height, &drawing))
            figcaption { (typeset(says)) }
        }
    })
}

/// The point of the limit at the parameter.
fn far(polygon: &FarPolygon<'_>, window: Window, level: u32, finer: f64) -> Option<[f64; 3]> {
    let t = nearest(polygon.parameter);
    // Of a closed polygon the parameter may be in another round.
    let t = if polygon.closed { t.rem_euclid(float(polygon.count())) } else { t };
    let mut place = [0.0; 3];
    for (coordinate, x) in place.iter_mut().enumerate().take(polygon.coordinates.len()) {
        let control = polygon.control(coordinate, window)?;
        let found = levels(polygon.mask, control, (0, finer), window)?;
        *x = found.get(usize::try_from(level).ok()?)?.at(t);
    }
    Some(place)
}

/// Points of the plane, with the same scale in both directions.
fn flat(control: &[[f64; 3]], limit: &[[f64; 3]], far: [f64; 3]) -> Markup {
    const ROOM: (f64, f64) = (WIDTH - 40.0, 280.0);
    let all = || control.iter().chain(limit);
    let ends = |axis: usize| {
        all().fold((f64::MAX, f64::MIN), |(low, high), place| {
            (low.min(place[axis]), high.max(place[axis]))
        })
    };
    let (x, y) = (ends(0), ends(1));
    let size = |(low, high): (f64, f64)| (high - low).max(f64::MIN_POSITIVE);
    let unit = (ROOM.0 / size(x)).min(ROOM.1 / size(y));
    let (across, up) = (unit * size(x), unit * size(y));
    let left = (WIDTH - across) / 2.0;
    let x = Scale::new(x, (left, left + across), false);
    let y = Scale::new(y, (20.0 + up, 20.0), false);
    let at = |place: &[f64; 3]| (x.at(place[0]), y.at(place[1]));
    let path = |line: &[[f64; 3]]| points(&line.iter().map(at).collect::<Vec<_>>());
    let mark = at(&far);
    html! {
        g.c6 {
            polyline.dash points=(path(control)) {}
            @for (x, y) in control.iter().map(at) { circle.dot cx=(x) cy=(y) r="2.5" {} }
        }
        g.c2 { polyline.line points=(path(limit)) {} }
        circle.bad cx=(mark.0) cy=(mark.1) r="6" {}
    }
}
