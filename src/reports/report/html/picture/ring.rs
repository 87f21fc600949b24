//! The characteristic ring with lines of constant parameters.

use crate::characteristic::{Refutation, RingPoint, Verdict, Vertex};
use crate::exact::Rational;
use crate::float::nearest;
use crate::report::html::picture::plane::frame::{WIDTH, points};
use crate::report::html::picture::plane::panel::Panel;
use maud::html;
use std::f64::consts::PI;

const HEIGHT: f64 = 560.0;
const MARGIN: f64 = 16.0;

/// A place in the plane of the map.
type Place = (f64, f64);

fn real(n: usize) -> f64 {
    nearest(&Rational::from(n))
}

/// The ring in all sectors; `None` where there is none in the plane.
pub(crate) fn ring(vertex: &Vertex) -> Option<Panel> {
    let second = vertex.second.as_ref().filter(|second| second.block > 0)?;
    let (n, k) = (vertex.spectrum.order, second.block);
    let angle = 2.0 * PI * real(k) / real(n);
    let plane = |[p, q]: &[Rational; 2]| -> Place {
        let (p, q) = (nearest(p), nearest(q));
        (p + q * angle.cos(), q * angle.sin())
    };
    let lines = vertex.lines();
    if lines.is_empty() {
        return None;
    }
    let sector: Vec<(bool, Vec<Place>)> =
        lines.iter().map(|line| (line.side, line.points.iter().map(plane).collect())).collect();
    let all = sector.iter().flat_map(|(_, line)| line);
    let far = all.map(|(x, y)| x.hypot(*y)).fold(0.0, f64::max);
    if far <= 0.0 {
        return None;
    }
    let scale = (HEIGHT / 2.0 - MARGIN) / far;
    let drawn = |(x, y): Place, turn: f64| -> Place {
        let (c, s) = (turn.cos(), turn.sin());
        let round = |z: f64| (z * 100.0).round() / 100.0;
        (
            round(WIDTH / 2.0 + scale * (c * x - s * y)),
            round(HEIGHT / 2.0 - scale * (s * x + c * y)),
        )
    };
    let marks: Vec<(&RingPoint, &str)> = match &vertex.verdict {
        Verdict::Proved { near, .. } => vec![(near, "least J")],
        Verdict::Refuted(Refutation::Folds { points: [one, other], .. }) => {
            vec![(one, "J > 0"), (other, "J < 0")]
        }
        _ => Vec::new(),
    };
    let marked = marks
        .iter()
        .filter_map(|(point, name)| Some((drawn(plane(&vertex.image(point)?), 0.0), name)));
    let marked: Vec<(Place, &&str)> = marked.collect();
    let title = format!("The characteristic ring at valence {n}");
    let at =
        marks.iter().map(|(point, name)| format!(" {name} at ({}, {}).", point.at[0], point.at[1]));
    let says = format!(
        "The characteristic ring of block {k} at valence {n}, between two levels, with lines of constant parameters; the sides of \
         its pieces are darker.{}",
        at.collect::<String>()
    );
    let drawing = html! {
        @for s in 0..n {
            @for (side, line) in &sector {
                @let line: Vec<Place> = line.iter().map(|place| drawn(*place, angle * real(s))).collect();
                polyline class=(if *side { "line c1" } else { "net c2" }) points=(points(&line)) {}
            }
        }
        circle.dot.c3 cx=(WIDTH / 2.0) cy=(HEIGHT / 2.0) r="3" {}
        @for ((x, y), name) in &marked {
            circle.ring.c4 cx=(x) cy=(y) r="5" {}
            text.name.over.c4 x=(x + 8.0) y=(y - 6.0) { (name) }
        }
    };
    Some(Panel { title, says, height: HEIGHT, drawing })
}
