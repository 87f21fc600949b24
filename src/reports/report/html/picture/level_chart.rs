//! Values against the level, on a logarithmic scale.

use crate::report::html::picture::plane::frame::{Frame, picture, points};
use crate::report::html::picture::plane::scale::Scale;
use crate::report::html::typeset::typeset;
use maud::{Markup, html};

const HEIGHT: f64 = 300.0;
const FRAME: Frame = Frame { x: (64.0, 520.0), y: (262.0, 12.0) };

/// How far the names of lines are apart, at least.
const APART: f64 = 18.0;

/// A line of a chart.
#[derive(Clone, Debug)]
pub(crate) struct Line {
    pub(crate) name: String,
    /// The class of its colour.
    pub(crate) class: &'static str,
    /// Of constants, which are not compared with the tolerance.
    pub(crate) is_dashed: bool,
    /// Levels with values; only positive ones are drawn.
    pub(crate) values: Vec<(u32, f64)>,
    /// The level that gets a ring.
    pub(crate) ring: Option<u32>,
}

/// Lines, the tolerance, and levels that papers or formulas promise.
#[derive(Clone, Debug)]
pub(crate) struct LevelChart {
    pub(crate) title: String,
    /// What it shows, in words.
    pub(crate) says: String,
    pub(crate) tolerance: f64,
    pub(crate) lines: Vec<Line>,
    /// Levels, with what is said of them.
    pub(crate) promised: Vec<(u32, String)>,
}

impl LevelChart {
    /// `None` where nothing is positive.
    pub(crate) fn drawn(&self) -> Option<Markup> {
        let LevelChart { title, says, tolerance, lines, promised } = self;
        let all =
            || lines.iter().flat_map(|line| &line.values).filter(|(_, value)| is_shown(*value));
        let last =
            all().map(|(level, _)| *level).chain(promised.iter().map(|(level, _)| *level)).max()?;
        all().next()?;
        let values =
            || all().map(|(_, value)| *value).chain([*tolerance]).filter(|value| is_shown(*value));
        let (low, high) = (values().fold(f64::MAX, f64::min), values().fold(f64::MIN, f64::max));
        let y = Scale::new((low, high), (FRAME.y.0 - 8.0, FRAME.y.1 + 8.0), true);
        let x = Scale::new((0.0, f64::from(last)), (FRAME.x.0 + 12.0, FRAME.x.1 - 12.0), false);
        let ticks = x.ticks().into_iter().filter(|(level, _)| level.fract() == 0.0);
        let ticks: Vec<(f64, String)> = ticks.map(|(level, label)| (x.at(level), label)).collect();
        let right = FRAME.x.1 + 8.0;
        let drawing = html! {
            (FRAME.drawn(&ticks, &y))
            @for (level, _) in promised {
                @let place = x.at(f64::from(*level));
                line.bad x1=(place) x2=(place) y1=(FRAME.y.0) y2=(FRAME.y.1) {}
            }
            @for ((level, what), row) in promised.iter().zip(1_u8..) {
                @let place = x.at(f64::from(*level));
                // Words stand on the side where there is room for them.
                @let is_left = place > f64::midpoint(FRAME.x.0, FRAME.x.1);
                text.over x=(if is_left { place - 5.0 } else { place + 5.0 }) y=(FRAME.y.1 + APART * f64::from(row)) text-anchor=(if is_left { "end" } else { "start" }) style="fill:var(--wrong-s)" { (what) }
            }
            @if is_shown(*tolerance) {
                line.frame x1=(FRAME.x.0) x2=(FRAME.x.1) y1=(y.at(*tolerance)) y2=(y.at(*tolerance)) {}
            }
            @for line in lines { (line.drawn(&x, &y)) }
            (names(lines, *tolerance, &y, right))
            text.soft x=(f64::midpoint(FRAME.x.0, FRAME.x.1)) y=(HEIGHT - 4.0) text-anchor="middle" { "level" }
        };
        Some(html! {
            figure {
                (picture(title, says, HEIGHT, &drawing))
                figcaption { (typeset(says)) }
            }
        })
    }
}

fn is_shown(value: f64) -> bool {
    value > 0.0 && value.is_finite()
}

impl Line {
    fn drawn(&self, x: &Scale, y: &Scale) -> Markup {
        let place = |(level, value): &(u32, f64)| (x.at(f64::from(*level)), y.at(*value));
        let shown = self.values.iter().filter(|(_, value)| is_shown(*value));
        let places: Vec<(f64, f64)> = shown.clone().map(place).collect();
        let ring = shown.clone().find(|(level, _)| Some(*level) == self.ring).map(place);
        html! {
            g class=(self.class) {
                polyline class=(if self.is_dashed { "dash" } else { "line" }) points=(points(&places)) {}
                @if !self.is_dashed { @for (x, y) in &places { circle.dot cx=(x) cy=(y) r="2.5" {} } }
                @if let Some((x, y)) = ring { circle.ring cx=(x) cy=(y) r="6" fill-opacity="0" {} }
            }
        }
    }
}

/// The names of the lines and of the tolerance at the right, moved apart where they would overlap.
fn names(lines: &[Line], tolerance: f64, y: &Scale, right: f64) -> Markup {
    let last = |line: &Line| {
        line.values.iter().rev().map(|(_, value)| *value).find(|value| is_shown(*value))
    };
    let name = |line| Some((y.at(last(line)?), line.class, line.name.as_str()));
    let mut names: Vec<(f64, &str, &str)> = lines.iter().filter_map(name).collect();
    if is_shown(tolerance) {
        names.push((y.at(tolerance), "c6", "ε"));
    }
    names.sort_by(|one, other| one.0.total_cmp(&other.0));
    // From below upwards, so that none leaves the picture at the bottom.
    let mut below = FRAME.y.0 + APART;
    for (place, ..) in names.iter_mut().rev() {
        *place = place.min(below - APART);
        below = *place;
    }
    html! {
        @for (place, class, name) in names {
            text class={ "name " (class) } x=(right) y=(place + 4.0) { (name) }
        }
    }
}
