//! The sound bound of a depth against the level, with the printed depth and the tolerance.

use super::frame::{Frame, picture, points};
use super::scale::Scale;
use crate::audit::DepthLevels;
use crate::exact::format::short;
use crate::float::nearest;
use maud::{Markup, html};

const HEIGHT: f64 = 300.0;
const FRAME: Frame = Frame { x: (64.0, 520.0), y: (262.0, 12.0) };

/// Levels, and constants of so many levels, on a logarithmic scale; `None` where a value is 0.
pub(in crate::report::html) fn levels(found: &DepthLevels, locus: &str) -> Option<Markup> {
    let DepthLevels { tolerance, printed, sound, .. } = found;
    let last = u32::try_from(found.bounds.len()).ok()? - 1;
    let place = |values: &[crate::exact::Rational]| -> Vec<(f64, f64)> {
        let places = (0..=last).map(f64::from);
        places.zip(values.iter().map(nearest)).collect()
    };
    let (bounds, constants) = (place(&found.bounds), place(&found.constants));
    let epsilon = nearest(tolerance);
    let values = || bounds.iter().chain(&constants).map(|(_, value)| *value).chain([epsilon]);
    let (low, high) = (values().fold(f64::MAX, f64::min), values().fold(f64::MIN, f64::max));
    if low <= 0.0 || !high.is_finite() {
        return None;
    }
    let y = Scale::new((low, high), (FRAME.y.0 - 8.0, FRAME.y.1 + 8.0), true);
    let x = Scale::new((0.0, f64::from(last)), (FRAME.x.0 + 12.0, FRAME.x.1 - 12.0), false);
    let path = |line: &[(f64, f64)]| {
        let places = line.iter().map(|(level, value)| (x.at(*level), y.at(*value)));
        points(&places.collect::<Vec<(f64, f64)>>())
    };
    let says = format!(
        "{locus}: the sound bound of the distance against the level, and the constants of c levels, on a \
         logarithmic scale. The bound meets ε = {} from level {sound} on; level {printed} is printed.",
        short(tolerance, 6)
    );
    let ticks = x.ticks().into_iter().filter(|(level, _)| level.fract() == 0.0);
    let ticks: Vec<(f64, String)> = ticks.map(|(level, label)| (x.at(level), label)).collect();
    let (printed, right) = (x.at(f64::from(*printed)), FRAME.x.1 + 8.0);
    let end = |line: &[(f64, f64)]| line.last().map(|(_, value)| y.at(*value) + 4.0);
    let drawing = html! {
        (FRAME.drawn(&ticks, &y))
        line.bad x1=(printed) x2=(printed) y1=(FRAME.y.0) y2=(FRAME.y.1) {}
        text x=(printed + 5.0) y=(FRAME.y.1 + 14.0) style="fill:var(--wrong-s)" { "printed " (found.printed) }
        line.frame x1=(FRAME.x.0) x2=(FRAME.x.1) y1=(y.at(epsilon)) y2=(y.at(epsilon)) {}
        text.soft x=(right) y=(y.at(epsilon) + 4.0) { "ε" }
        g.c2 {
            polyline.dash points=(path(&constants)) {}
            text.name x=(right) y=[end(&constants).map(|y| y - 14.0)] { "constants" }
        }
        g.c1 {
            polyline.line points=(path(&bounds)) {}
            @for (level, value) in &bounds { circle.dot cx=(x.at(*level)) cy=(y.at(*value)) r="2.5" {} }
            circle.ring cx=(x.at(f64::from(*sound))) cy=(y.at(bounds[usize::try_from(*sound).ok()?].1)) r="6" fill-opacity="0" {}
            text.name x=(right) y=[end(&bounds).map(|y| y + 12.0)] { "sound bound" }
        }
        text.soft x=(f64::midpoint(FRAME.x.0, FRAME.x.1)) y=(HEIGHT - 4.0) text-anchor="middle" { "level" }
    };
    Some(html! {
        figure {
            (picture("Sound bound against the level", &says, HEIGHT, &drawing))
            figcaption { (says) }
        }
    })
}
