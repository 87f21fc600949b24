//! The set of a parameter range, with its ends, above the range as printed.

use super::super::names::plain;
use crate::audit::RangeFinding;
use crate::claim::Printed;
use crate::exact::RealAlgebraic;
use crate::float::nearest;
use crate::report::formulas::function::{exactly, printed as printed_range};
use crate::report::html::picture::plane::frame::{Frame, picture};
use crate::report::html::picture::plane::scale::Scale;
use maud::{Markup, html};
use std::ops::Bound;

const HEIGHT: f64 = 120.0;
const FRAME: Frame = Frame { x: (84.0, 620.0), y: (84.0, 8.0) };

/// How far from the middle an unbounded end is drawn, in parts of what is between the ends.
const BEYOND: f64 = 0.15;

/// Both sets on one axis; `None` where neither has an end.
pub(crate) fn range(finding: &RangeFinding<'_>) -> Option<Markup> {
    let (claim, found) = (finding.claim, finding.found.as_ref().ok()?);
    let exact = &found.exact;
    let printed = |end: &Option<Printed>| end.as_ref().map(|end| nearest(&end.decimal.value()));
    let (from, to) = (printed(&claim.from), printed(&claim.to));
    let ends: Vec<f64> = exact.ends().map(|(end, _)| place(end)).chain(from).chain(to).collect();
    let (low, high) = (
        ends.iter().copied().fold(f64::MAX, f64::min),
        ends.iter().copied().fold(f64::MIN, f64::max),
    );
    if ends.is_empty() || !low.is_finite() || !high.is_finite() {
        return None;
    }
    let margin = ((high - low) * BEYOND).max(high.abs().max(1e-3) * 1e-3);
    let window = (low - margin, high + margin);
    let x = Scale::new(window, FRAME.x, false);
    let closed = claim.closed != Some(false);
    let end = |end: Option<f64>| end.map(|value| (value, closed));
    let title = format!("{}: the range as printed and the exact set", claim.locus);
    let says =
        format!("Printed {}; exactly {}.", printed_range(finding), exactly(found, &claim.variable));
    let drawing = html! {
        @for (value, label) in x.ticks() {
            line.axis x1=(x.at(value)) x2=(x.at(value)) y1=(FRAME.y.1) y2=(FRAME.y.0) {}
            text.soft x=(x.at(value)) y=(FRAME.y.0 + 16.0) text-anchor="middle" { (label) }
        }
        text x="4" y="34" { "exact" }
        g.c3 {
            @for interval in exact.intervals() {
                (drawn(&x, 30.0, bound(&interval.low), bound(&interval.high)))
            }
        }
        text x="4" y="64" { "printed" }
        g.c2 { (drawn(&x, 60.0, end(from), end(to))) }
        text.soft x=(FRAME.x.1) y=(HEIGHT - 4.0) text-anchor="end" { (plain(&claim.variable)) }
    };
    Some(html! {
        figure {
            (picture(&title, &says, HEIGHT, &drawing))
            figcaption { "A filled end belongs to the set, a ring does not." }
        }
    })
}

/// An end, and whether it belongs to the set.
pub(super) fn bound(end: &Bound<RealAlgebraic>) -> Option<(f64, bool)> {
    match end {
        Bound::Unbounded => None,
        Bound::Included(end) => Some((place(end), true)),
        Bound::Excluded(end) => Some((place(end), false)),
    }
}

fn place(end: &RealAlgebraic) -> f64 {
    nearest(end)
}

pub(super) fn drawn(
    x: &Scale,
    y: f64,
    low: Option<(f64, bool)>,
    high: Option<(f64, bool)>,
) -> Markup {
    let from = low.map_or(FRAME.x.0, |(value, _)| x.at(value));
    let to = high.map_or(FRAME.x.1, |(value, _)| x.at(value));
    html! {
        line.line x1=(from) x2=(to) y1=(y) y2=(y) {}
        @for (value, belongs) in low.into_iter().chain(high) {
            circle class=(if belongs { "dot" } else { "ring" }) cx=(x.at(value)) cy=(y) r="5" {}
        }
    }
}
