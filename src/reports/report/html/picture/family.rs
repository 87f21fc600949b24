//! Where in the parameters of a family the limits are smooth.

use super::range::{bound, drawn};
use crate::exact::{IntervalSet, Rational, format::short};
use crate::facts::{FamilyDrawing, ParameterFacts};
use crate::float::nearest;
use crate::report::html::picture::plane::frame::{Frame, WIDTH};
use crate::report::html::picture::plane::panel::Panel;
use crate::report::html::picture::plane::scale::Scale;
use crate::report::words::notation::unicode;
use crate::report::words::set::proved_text;
use crate::smoothness::{Certain, MapBox, Sides, SmoothMap};
use maud::{Markup, html};

/// How far from the middle an unbounded end is drawn, in parts of what is between the ends.
const BEYOND: f64 = 0.15;

/// The height of the rows of one order.
const ROW: f64 = 52.0;

/// The side of a map.
const SIDE: f64 = 240.0;

/// The colours of maps.
const CLASSES: [&str; 3] = ["c1", "c2", "c3"];

/// The sets of one parameter above each other, or maps of two; `None` where there are none with an end.
pub(crate) fn family(scheme: &str, found: &FamilyDrawing) -> Option<Panel> {
    match found {
        FamilyDrawing::One { parameter, ranges, end } => one(scheme, parameter, ranges, end),
        FamilyDrawing::Two { parameters, region, maps, end } => {
            Some(two(scheme, parameters, region, maps, end))
        }
    }
}

fn one(scheme: &str, parameter: &str, ranges: &[ParameterFacts], end: &str) -> Option<Panel> {
    let sets = || ranges.iter().flat_map(|range| [&range.inside, &range.outside]);
    let ends = || sets().flat_map(IntervalSet::ends).map(|(end, _)| nearest(end));
    let (low, high) = (ends().fold(f64::MAX, f64::min), ends().fold(f64::MIN, f64::max));
    ends().next()?;
    let margin = ((high - low) * BEYOND).max(high.abs().max(1e-3) * 1e-3);
    let rows = || (0_u8..).zip(ranges);
    let bottom = f64::from(u8::try_from(ranges.len()).unwrap_or(u8::MAX)) * ROW + 8.0;
    let frame = Frame { x: (84.0, 620.0), y: (bottom, 0.0) };
    let x = Scale::new((low - margin, high + margin), frame.x, false);
    let drawing = html! {
        @for (value, label) in x.ticks() {
            line.axis x1=(x.at(value)) x2=(x.at(value)) y1=(frame.y.1) y2=(frame.y.0) {}
            text.soft x=(x.at(value)) y=(bottom + 18.0) text-anchor="middle" { (label) }
        }
        @for (row, range) in rows() {
            @let top = f64::from(row) * ROW;
            @for (set, below, name, class) in [(&range.inside, 20.0, unicode(&format!("C^{}", range.m)), "c3"), (&range.outside, 40.0, "not".to_owned(), "c2")] {
                text x="12" y=(top + below + 4.0) { (name) }
                g class=(class) {
                    @for interval in set.intervals() {
                        (drawn(&x, top + below, bound(&interval.low), bound(&interval.high)))
                    }
                }
            }
        }
        text.soft x=(frame.x.1) y=(bottom + 36.0) text-anchor="end" { (parameter) }
    };
    let of = |range: &ParameterFacts| {
        format!("C^{} for {}; ", range.m, proved_text(&range.inside, &range.outside, parameter))
    };
    let says = format!(
        "{}what lies in neither set is open. A filled end belongs to the set, a ring does not. {end}.",
        ranges.iter().map(of).collect::<String>()
    );
    let title = format!("{scheme}: where in {parameter} the limits are smooth");
    Some(Panel { title, says, height: bottom + 40.0, drawing })
}

fn two(
    scheme: &str,
    [first, second]: &[String; 2],
    region: &Sides,
    maps: &[SmoothMap],
    end: &str,
) -> Panel {
    let across = |i: u8| if i.is_multiple_of(2) { 60.0 } else { WIDTH / 2.0 + 52.0 };
    let down = |i: u8| f64::from(i / 2) * (SIDE + 84.0) + 28.0;
    let side = |which: usize| (nearest(&region[which][0]), nearest(&region[which][1]));
    let drawing = html! {
        @for ((m, map), class) in (0_u8..).zip(maps).zip(CLASSES) {
            @let (left, top) = (across(m), down(m));
            @let x = Scale::new(side(0), (left, left + SIDE), false);
            @let y = Scale::new(side(1), (top + SIDE, top), false);
            @let ticks: Vec<(f64, String)> = x.ticks().into_iter().step_by(2).map(|(value, label)| (x.at(value), label)).collect();
            text x=(left) y=(top - 8.0) { (unicode(&format!("C^{m}"))) }
            (Frame { x: (left, left + SIDE), y: (top + SIDE, top) }.drawn(&ticks, &y))
            g class=(class) {
                @for found in &map.boxes { (one_box(found, &x, &y)) }
            }
            text.soft x=(left + SIDE) y=(top + SIDE + 36.0) text-anchor="end" { (first) " →, " (second) " ↑" }
        }
    };
    let percent = |share: &Rational| short(&(share * Rational::from(100)), 3);
    let of = |(m, map): (usize, &SmoothMap)| {
        let [inside, outside, open] = map.shares().map(|share| percent(&share));
        format!("C^{m}: {inside} % of the area proven, {outside} % refuted, {open} % open. ")
    };
    let but = if maps.iter().any(|map| map.but_exceptions) {
        " Parameters in grey may be exceptions where shifts of the basic limit function are linearly dependent."
    } else {
        ""
    };
    let says = format!(
        "{first} from {} to {}, {second} from {} to {}, in boxes. In a coloured box all limits are proven to be C^m for the whole \
         box, in a grey one for none of it; white is open. {}{end}.{but}",
        region[0][0],
        region[0][1],
        region[1][0],
        region[1][1],
        maps.iter().enumerate().map(of).collect::<String>(),
    );
    let title = format!("{scheme}: where in {first} and {second} the limits are smooth");
    let rows = u8::try_from(maps.len()).unwrap_or(u8::MAX).div_ceil(2);
    Panel { title, says, height: f64::from(rows) * (SIDE + 84.0), drawing }
}

fn one_box(found: &MapBox, x: &Scale, y: &Scale) -> Markup {
    let class = match found.certain {
        Certain::Inside => "skin",
        Certain::Outside(_) => "grey",
        Certain::Open => return html! {},
    };
    let [[left, right], [low, high]] =
        found.sides.each_ref().map(|side| side.each_ref().map(nearest));
    let (left, right, top, bottom) = (x.at(left), x.at(right), y.at(high), y.at(low));
    html! { rect class=(class) x=(left) y=(top) width=(right - left) height=(bottom - top) {} }
}
