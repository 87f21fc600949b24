//! Polygons of several levels as graphs over a part of their parameters, and two values that are compared.

use super::frame::{Frame, WIDTH, points};
use super::scale::Scale;
use crate::report::html::picture::curve::{Level, Window};
use maud::{Markup, html};

/// The height of the picture.
pub(crate) const HEIGHT: f64 = 300.0;
const FRAME: Frame = Frame { x: (56.0, 540.0), y: (264.0, 12.0) };

/// The most dots of control points.
const MAX_DOTS: usize = 200;

/// What is drawn: a level and what it is compared with, and the two values.
pub(crate) struct Graph<'l> {
    pub(crate) control: &'l Level,
    /// Places and values.
    pub(crate) ends: [(f64, f64); 2],
    pub(crate) level: &'l Level,
    pub(crate) other: &'l Level,
    /// What the other is.
    pub(crate) name: String,
}

impl Graph<'_> {
    pub(crate) fn drawn(&self, window: Window) -> Markup {
        let ends = window.ends();
        let lines = [self.control, self.level, self.other].map(|level| level.between(ends));
        let values = || lines.iter().flatten().map(|(_, value)| *value);
        let (low, high) = (values().fold(f64::MAX, f64::min), values().fold(f64::MIN, f64::max));
        let y = Scale::new((low, high), (FRAME.y.0 - 12.0, FRAME.y.1 + 12.0), false);
        let x = Scale::new(ends, FRAME.x, false);
        let place = |(t, value): &(f64, f64)| (x.at(*t), y.at(*value));
        let path = |line: &[(f64, f64)]| points(&line.iter().map(place).collect::<Vec<_>>());
        let vertices: Vec<(f64, f64)> = self.control.vertices(ends).take(MAX_DOTS).collect();
        let ticks: Vec<(f64, String)> =
            x.ticks().into_iter().map(|(value, label)| (x.at(value), label)).collect();
        let [first, second] = self.ends.map(|end| place(&end));
        let same = self.level.k == 0;
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
            // They end at the side of the picture, since letters are larger on a narrow page.
            @let right = WIDTH - 2.0;
            text.name.over.c6 x=(right) y="28" text-anchor="end" { "– – control" }
            @if !same { text.name.over.c1 x=(right) y="46" text-anchor="end" { "— level " (self.level.k) } }
            text.name.over.c2 x=(right) y="64" text-anchor="end" { "— " (self.name) }
            text.name.over x=(right) y="82" text-anchor="end" style="fill:var(--wrong-s)" { "o–o the place" }
        }
    }
}
