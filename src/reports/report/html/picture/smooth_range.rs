//! The values of a parameter for which limits are smooth, above the range as printed.

use super::super::names::plain;
use super::range::{bound, drawn};
use crate::audit::{KnownLimits, SmoothnessFinding};
use crate::exact::IntervalSet;
use crate::float::nearest;
use crate::report::html::picture::plane::frame::{Frame, picture};
use crate::report::html::picture::plane::scale::Scale;
use crate::report::smooth::smoothness::printed;
use crate::report::words::set::{proved_text, set_text};
use maud::{Markup, html};

const HEIGHT: f64 = 150.0;
const FRAME: Frame = Frame { x: (84.0, 620.0), y: (114.0, 8.0) };

/// How far from the middle an unbounded end is drawn, in parts of what is between the ends.
const BEYOND: f64 = 0.15;

/// The sets inside and outside and the printed one on one axis; `None` where none of them has an end.
pub(crate) fn smooth_range(finding: &SmoothnessFinding<'_>) -> Option<Markup> {
    let said = finding.claim.range()?;
    let KnownLimits::Range(range) = &finding.known else { return None };
    let sets = range.sets.as_ref()?;
    let rows = [
        ("smooth", sets.inside(), "c3"),
        ("not", sets.outside(), "c1"),
        ("printed", &range.printed, "c2"),
    ];
    let ends: Vec<f64> =
        rows.iter().flat_map(|(_, set, _)| set.ends()).map(|(end, _)| nearest(end)).collect();
    let (low, high) = (
        ends.iter().copied().fold(f64::MAX, f64::min),
        ends.iter().copied().fold(f64::MIN, f64::max),
    );
    if ends.is_empty() || !low.is_finite() || !high.is_finite() {
        return None;
    }
    let margin = ((high - low) * BEYOND).max(high.abs().max(1e-3) * 1e-3);
    let x = Scale::new((low - margin, high + margin), FRAME.x, false);
    let title = format!("{}: the range as printed, and what is proved", finding.claim.locus);
    let set = |set: &IntervalSet| set_text(set, &said.variable);
    let says = format!(
        "Printed {}; C^{m} for {}; not C^{m} for {}.",
        printed(said),
        proved_text(sets.inside(), sets.outside(), &said.variable),
        set(sets.outside()),
        m = said.m
    );
    let drawing = html! {
        @for (value, label) in x.ticks() {
            line.axis x1=(x.at(value)) x2=(x.at(value)) y1=(FRAME.y.1) y2=(FRAME.y.0) {}
            text.soft x=(x.at(value)) y=(FRAME.y.0 + 16.0) text-anchor="middle" { (label) }
        }
        @for (place, (label, set, class)) in rows.iter().enumerate() {
            @let y = [30.0, 60.0, 90.0][place];
            text x="4" y=(y + 4.0) { (label) }
            g class=(class) {
                @for interval in set.intervals() {
                    (drawn(&x, y, bound(&interval.low), bound(&interval.high)))
                }
            }
        }
        text.soft x=(FRAME.x.1) y=(HEIGHT - 4.0) text-anchor="end" { (plain(&said.variable)) }
    };
    Some(html! {
        figure {
            (picture(&title, &says, HEIGHT, &drawing))
            figcaption { "A filled end belongs to the set, a ring does not." }
        }
    })
}
