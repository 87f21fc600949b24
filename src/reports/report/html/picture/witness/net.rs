//! Data of a tensor product that exceed a bound: control net, level k and limit as graphs above the
//! parameters, and the place.

use super::super::curve::Window;
use super::super::grid::{Grid, levels};
use super::super::space::{Scene, Views};
use super::exceeding::{Exceeding, SEEN};
use crate::audit::Place;
use crate::claim::Quantity;
use crate::exact::Rational;
use crate::float::nearest;
use crate::limit::natural_shift;
use crate::report::html::picture::plane::frame::picture;
use crate::report::html::picture::plane::legend::legend;
use crate::report::html::typeset::typeset;
use crate::scheme::Mask;
use maud::{Markup, html};

/// How far the picture reaches to all sides of the place, in control points.
const REACH: f64 = 2.0;

/// Into how many parts each side is divided.
const PARTS: u32 = 14;

/// How high the graphs are, by the side of their window.
const HIGH: f64 = 0.6;

/// How much the drawn distance may differ from the exact one, relative to it; otherwise nothing is drawn.
const SAME: f64 = 0.03;

/// What is drawn at the place: two values whose distance is bounded, at their parameters.
struct Drawn<'l> {
    ends: [([f64; 2], f64); 2],
    level: &'l Grid,
    other: &'l Grid,
    name: String,
}

/// A control net, with its first point and its rows.
pub(super) fn drawing(
    masks: [&Mask; 2],
    (corner, rows): ([i64; 2], &[Vec<i64>]),
    exceeding: &Exceeding<'_>,
) -> Option<Markup> {
    let natural = masks.map(|mask| nearest(&natural_shift(mask).shift));
    let control = Grid::control(corner, rows, exceeding.shift);
    let (found, windows) = windows(masks, exceeding)?.into_iter().find_map(|windows| {
        let found = levels(masks, control.clone(), exceeding.level, windows, natural)?;
        Some((found, windows))
    })?;
    let shown = shown(&found, exceeding)?;
    let (apart, exact) =
        ((shown.ends[0].1 - shown.ends[1].1).abs(), nearest(&exceeding.attained.value));
    if (apart - exact).abs() > SAME * exact {
        return None;
    }
    let says = exceeding.says("net", &shown.name);
    let (scene, height) = scene(&found[0], &shown, windows).drawn(Views::Above);
    let (legend, height) = legend(&shown.names(), height);
    let drawing = html! { (scene) (legend) };
    Some(html! {
        figure {
            (picture("Control net, level and limit", &says, height, &drawing))
            figcaption { (typeset(&says)) " Heights are values above the parameters, seen from two sides." }
        }
    })
}

impl Drawn<'_> {
    /// What is drawn, with its class.
    fn names(&self) -> Vec<(&'static str, String)> {
        let other = ("c2", self.name.clone());
        match self.level.k {
            0 => vec![("c1", "control net".to_owned()), other],
            k => vec![("c6", "control net".to_owned()), ("c1", format!("level {k}")), other],
        }
    }
}

/// The parts of the parameters that may be drawn, the best first: some control points on all sides of the
/// place, unless the distance would not be seen there, and some points of level k.
fn windows(masks: [&Mask; 2], exceeding: &Exceeding<'_>) -> Option<Vec<[Window; 2]>> {
    let k = exceeding.level;
    let count =
        |axis: usize, level: u32| Rational::from(masks[axis].arity()).pow(level.cast_signed());
    let place = match &exceeding.attained.place {
        Place::Parameters(both) => both.each_ref().map(nearest),
        Place::Points([i, j]) => {
            [(0, i), (1, j)].map(|(axis, i)| nearest(&(Rational::from(*i) / count(axis, k + 1))))
        }
        Place::Along([i, j], _) => {
            [(0, i), (1, j)].map(|(axis, i)| nearest(&(Rational::from(*i) / count(axis, k))))
        }
        _ => return None,
    };
    let window = |reach: [f64; 2]| [0, 1].map(|axis| Window { t: place[axis], reach: reach[axis] });
    let near = window([0, 1].map(|axis| REACH / nearest(&count(axis, k))));
    let is_seen = nearest(&exceeding.attained.value) >= SEEN;
    Some(if is_seen { vec![window([REACH; 2]), near] } else { vec![near] })
}

/// The place and what is compared there.
fn shown<'l>(found: &'l [Grid], exceeding: &Exceeding<'_>) -> Option<Drawn<'l>> {
    let k = usize::try_from(exceeding.level).ok()?;
    let (level, next, limit) = (found.get(k)?, found.get(k + 1)?, found.last()?);
    let at_limit = || "limit".to_owned();
    Some(match (exceeding.quantity, &exceeding.attained.place) {
        (Quantity::Distance, Place::Parameters(both)) => {
            let t = both.each_ref().map(nearest);
            let ends = [(t, level.at(t)), (t, limit.at(t))];
            Drawn { ends, level, other: limit, name: at_limit() }
        }
        (Quantity::Step, Place::Points(place)) => {
            let t = next.parameters(*place);
            let ends = [(t, level.at(t)), (t, next.point(*place))];
            Drawn { ends, level, other: next, name: format!("level {}", next.k) }
        }
        (Quantity::Difference, Place::Along([i, j], axis)) => {
            let end = |place: [i64; 2]| (level.parameters(place), level.point(place));
            let ends = [end([*i, *j]), end(if *axis == 0 { [i + 1, *j] } else { [*i, j + 1] })];
            Drawn { ends, level, other: limit, name: at_limit() }
        }
        _ => return None,
    })
}

/// The control net, the level and the limit above the windows.
fn scene(control: &Grid, shown: &Drawn<'_>, windows: [Window; 2]) -> Scene {
    let even = |axis: usize| {
        let (from, to) = windows[axis].ends();
        let at = |part: u32| from + (to - from) * f64::from(part) / f64::from(PARTS);
        (0..=PARTS).map(at).collect::<Vec<f64>>()
    };
    let even = [even(0), even(1)];
    let values = [control, shown.level, shown.other]
        .into_iter()
        .flat_map(|grid| even[0].iter().flat_map(|s| even[1].iter().map(|t| grid.at([*s, *t]))));
    let values = values.chain(shown.ends.iter().map(|(_, value)| *value));
    let (low, high) = values.fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)));
    // Both sides are as long, and the graphs are as high as is seen well.
    let side = |axis: usize, t: f64| {
        let (from, to) = windows[axis].ends();
        (t - from) / (to - from)
    };
    let height = HIGH / (high - low).max(f64::MIN_POSITIVE);
    let at = |t: [f64; 2], value: f64| [side(0, t[0]), side(1, t[1]), height * (value - low)];
    let mut scene = Scene::default();
    let mut graph = |grid: &Grid, lines: &[Vec<f64>; 2], class: &str| {
        for s in lines[0].windows(2) {
            for t in lines[1].windows(2) {
                let corners = [[s[0], t[0]], [s[1], t[0]], [s[1], t[1]], [s[0], t[1]]];
                scene.face(corners.map(|t| at(t, grid.at(t))).to_vec(), class);
            }
        }
    };
    if shown.level.k > 0 {
        graph(control, &lines(control, windows, &even), "net c6");
    }
    graph(shown.level, &lines(shown.level, windows, &even), "net c1");
    graph(shown.other, &even, "skin c2");
    scene.mark(shown.ends.map(|(t, value)| at(t, value)));
    scene
}

/// The parameters of the points of a level within the windows, and the ends of these; of too many points,
/// others as even as they are.
fn lines(grid: &Grid, windows: [Window; 2], even: &[Vec<f64>; 2]) -> [Vec<f64>; 2] {
    [0, 1].map(|axis| {
        let (from, to) = windows[axis].ends();
        let own = grid.parameters_between(axis, (from, to));
        if own.len() + 2 > even[axis].len() {
            return even[axis].clone();
        }
        std::iter::once(from).chain(own).chain([to]).collect()
    })
}
