//! A figure of a paper that plots numbers of a table: as printed, beside what it should show.

use super::chart::{Mark, labels, mark};
use crate::audit::TableFinding;
use crate::claim::{Axis, Figure, Promise};
use crate::report::html::picture::plane::frame::{Frame, picture, points};
use crate::report::html::picture::plane::legend::legend;
use crate::report::html::picture::plane::scale::Scale;
use crate::report::html::typeset::typeset;
use maud::{Markup, html};

/// The most lines, as many as the legend has room for.
const MAX_LINES: usize = 4;

/// From this quotient of the greatest and the least value on, the scale is logarithmic.
const LOG_FROM: f64 = 20.0;

const HEIGHT: f64 = 270.0;
const FRAMES: [Frame; 2] =
    [Frame { x: (48.0, 312.0), y: (216.0, 24.0) }, Frame { x: (364.0, 628.0), y: (216.0, 24.0) }];

/// The classes of lines.
const CLASSES: [&str; MAX_LINES] = ["c1", "c2", "c3", "c4"];

/// A line of a figure.
struct Line<'f> {
    name: String,
    marks: Vec<Mark<'f>>,
}

/// Both panels on the same scale; `None` where a line has no numbers.
pub(crate) fn figure(finding: &TableFinding<'_>, figure: &Figure) -> Option<Markup> {
    let table = finding.table;
    let (along, lines) = lines(finding, figure)?;
    let values = |of: fn(&Mark<'_>) -> Option<f64>| {
        lines.iter().flat_map(|line| &line.marks).filter_map(of).collect::<Vec<f64>>()
    };
    let all = [values(|mark| mark.printed), values(due)].concat();
    let ends = all.iter().fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(*x), high.max(*x)));
    if all.is_empty() {
        return None;
    }
    let is_depth = matches!(table.promise, Some(Promise::Depth { .. }));
    let log = !is_depth && ends.0 > 0.0 && ends.1 / ends.0 >= LOG_FROM;
    let due_is = match table.promise {
        Some(Promise::Depth { .. }) => "depths that keep the tolerance",
        Some(Promise::Bound { .. }) => "sound bounds",
        None => "exact values of the printed definition",
    };
    let title = format!("{}: as printed, and as it should be", figure.locus);
    let says = format!(
        "{} plots numbers of {} by {}. On the left they are as printed, on the right the {due_is}{}.",
        figure.locus,
        table.locus,
        along.label,
        if log { ", on a logarithmic scale" } else { "" }
    );
    let panel = |frame: Frame, what: &str, of: fn(&Mark<'_>) -> Option<f64>| {
        let y = Scale::new(ends, (frame.y.0 - 10.0, frame.y.1 + 10.0), log);
        let last = f64::from(u32::try_from(along.entries.len() - 1).unwrap_or(u32::MAX));
        let x = Scale::new((0.0, last.max(1.0)), (frame.x.0 + 12.0, frame.x.1 - 12.0), false);
        let place = |mark: &Mark<'_>| {
            let across = x.at(f64::from(u32::try_from(mark.place).unwrap_or(u32::MAX)));
            Some((across, y.at(of(mark)?)))
        };
        html! {
            (frame.drawn(&every_other(labels(along, &x)), &y))
            text x=(frame.x.0) y="16" { (what) }
            @for (line, class) in lines.iter().zip(CLASSES) {
                @let places: Vec<(f64, f64)> = line.marks.iter().filter_map(place).collect();
                g class=(class) {
                    polyline.line points=(points(&places)) {}
                    @for (x, y) in &places { circle.dot cx=(x) cy=(y) r="2.5" {} }
                }
            }
        }
    };
    let names: Vec<(&str, String)> =
        CLASSES.into_iter().zip(&lines).map(|(class, line)| (class, line.name.clone())).collect();
    let (legend, height) = legend(&names, HEIGHT - 24.0);
    let drawing = html! {
        (panel(FRAMES[0], "as printed", |mark| mark.printed))
        (panel(FRAMES[1], if table.promise.is_some() { "sound" } else { "exact" }, due))
        (legend)
    };
    Some(html! {
        figure {
            (picture(&title, &says, height, &drawing))
            figcaption { (typeset(&says)) }
        }
    })
}

/// What a number should be: that which keeps its promise, or else the exact one.
fn due(mark: &Mark<'_>) -> Option<f64> {
    mark.sound.or(mark.exact)
}

/// Labels of narrow panels.
fn every_other(labels: Vec<(f64, String)>) -> Vec<(f64, String)> {
    let step = if labels.len() > 4 { labels.len().div_ceil(3) } else { 1 };
    labels.into_iter().step_by(step).collect()
}

/// The lines that a figure plots, and the axis along them.
fn lines<'f>(finding: &'f TableFinding<'_>, figure: &Figure) -> Option<(&'f Axis, Vec<Line<'f>>)> {
    let table = finding.table;
    let is_among = |axis: &Axis| {
        let has = |line: &String| axis.entries.iter().any(|entry| entry.printed == *line);
        figure.lines.iter().all(has)
    };
    let by_rows = table.rows.as_ref().is_none_or(is_among);
    let (along, across) = match &table.rows {
        Some(rows) if !by_rows => (rows, Some(&table.columns)),
        rows => (&table.columns, rows.as_ref()),
    };
    let count = across.map_or(1, |axis| axis.entries.len());
    let line = |line: usize| {
        let printed = across.map(|axis| axis.entries[line].printed.clone()).unwrap_or_default();
        if !figure.lines.is_empty() && !figure.lines.contains(&printed) {
            return None;
        }
        let at = |place: usize| if by_rows { (line, place) } else { (place, line) };
        let marks = (0..along.entries.len()).filter_map(|place| mark(finding, at(place), place));
        let name = across.map(|axis| format!("{} = {printed}", axis.label)).unwrap_or_default();
        Some(Line { name, marks: marks.collect() })
    };
    let lines: Vec<Line<'_>> = (0..count).filter_map(line).take(MAX_LINES).collect();
    (!lines.is_empty()).then_some((along, lines))
}
