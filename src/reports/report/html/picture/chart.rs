//! The numbers of a table as lines: printed against exact, and the sound ones where there are some.

use crate::audit::{CellFinding, Sound, TableFinding, Verdict};
use crate::claim::{Axis, Cell, Promise};
use crate::float::nearest;
use crate::report::html::picture::plane::frame::{Frame, WIDTH, picture, points};
use crate::report::html::picture::plane::scale::Scale;
use crate::report::html::typeset::typeset;
use crate::report::words::notation::unicode;
use maud::{Markup, html};

/// The most lines of a picture: as many can be told apart.
const MAX_LINES: usize = 8;

/// The most labels below a picture.
const MAX_LABELS: usize = 14;

/// From this quotient of the greatest and the least value on, the scale is logarithmic.
const LOG_FROM: f64 = 20.0;

const HEIGHT: f64 = 320.0;
const FRAME: Frame = Frame { x: (64.0, 540.0), y: (282.0, 12.0) };

/// A line of a table: its header, and its cells by their places along it.
struct Line<'f> {
    name: String,
    marks: Vec<Mark<'f>>,
}

/// A cell, with the values that it shows.
pub(super) struct Mark<'f> {
    pub(super) place: usize,
    anchor: String,
    cell: &'f CellFinding,
    pub(super) printed: Option<f64>,
    pub(super) exact: Option<f64>,
    pub(super) sound: Option<f64>,
}

impl Mark<'_> {
    fn values(&self) -> impl Iterator<Item = f64> {
        [self.printed, self.exact, self.sound].into_iter().flatten()
    }
}

/// A table as a diagram: a line for each row, or, where there are fewer of them, for each column. `None`
/// of a table with a single number in each line.
pub(crate) fn chart(finding: &TableFinding<'_>) -> Option<Markup> {
    let table = finding.table;
    let (rows, columns) = (finding.cells.len(), table.columns.entries.len());
    let by_rows = rows <= columns || table.rows.is_none();
    let along = if by_rows { Some(&table.columns) } else { table.rows.as_ref() }?;
    let across = if by_rows { table.rows.as_ref() } else { Some(&table.columns) };
    let count = if by_rows { rows } else { columns };
    let line = |line: usize| {
        let places = 0..along.entries.len();
        let at = |place: usize| if by_rows { (line, place) } else { (place, line) };
        let marks = places.filter_map(|place| mark(finding, at(place), place)).collect();
        let name = across.map(|axis| axis.entries[line].printed.clone());
        Line { name: name.unwrap_or_default(), marks }
    };
    let mut lines: Vec<Line<'_>> = (0..count).map(line).collect();
    lines.retain(|line| line.marks.len() > 1);
    lines.truncate(MAX_LINES);
    let shown = lines.len();
    if shown == 0 {
        return None;
    }
    let values = || lines.iter().flat_map(|line| &line.marks).flat_map(Mark::values);
    let (low, high) = (values().fold(f64::MAX, f64::min), values().fold(f64::MIN, f64::max));
    let is_depth = matches!(table.promise, Some(Promise::Depth { .. }));
    let log = !is_depth && low > 0.0 && high / low >= LOG_FROM;
    let y = Scale::new((low, high), (FRAME.y.0 - 10.0, FRAME.y.1 + 10.0), log);
    let last = f64::from(u32::try_from(along.entries.len() - 1).unwrap_or(u32::MAX));
    let x = Scale::new((0.0, last.max(1.0)), (FRAME.x.0 + 16.0, FRAME.x.1 - 16.0), false);
    let sound = lines.iter().flat_map(|line| &line.marks).any(|mark| mark.sound.is_some());
    let what = if sound { ", and sound where dashed" } else { "" };
    let scale = if log { ", logarithmic scale" } else { "" };
    let left =
        if shown < count { format!(" {shown} of {count} lines are shown.") } else { String::new() };
    let title = format!("{}: printed against exact", table.locus);
    let says = format!(
        "Rings are printed numbers, crosses those that are wrong; lines with dots are exact values of the \
         printed definition{what}, by {}{scale}.{left}",
        along.label
    );
    let drawing = html! {
        (FRAME.drawn(&labels(along, &x), &y))
        @for (place, line) in lines.iter().enumerate() { (drawn(place, line, &x, &y)) }
        (names(&lines, &y))
        text.soft x=(f64::midpoint(FRAME.x.0, FRAME.x.1)) y=(HEIGHT - 4.0) text-anchor="middle" { (unicode(&along.label)) }
    };
    Some(html! {
        figure {
            (picture(&title, &says, HEIGHT, &drawing))
            figcaption { (typeset(&says)) }
        }
    })
}

/// The values of a cell; `None` where it has none.
pub(super) fn mark<'f>(
    finding: &'f TableFinding<'_>,
    (row, column): (usize, usize),
    place: usize,
) -> Option<Mark<'f>> {
    let cell = finding.cells.get(row)?.get(column)?;
    let table = finding.table;
    let printed = match table.cells.get(row)?.get(column)? {
        Cell::Printed(printed) => Some(nearest(&printed.decimal.value())),
        Cell::Lost | Cell::Blank => None,
    };
    let sound = match &cell.sound {
        Some(Sound::Depth { level, .. } | Sound::Least(level)) => Some(f64::from(*level)),
        Some(Sound::Bound(bound)) => Some(nearest(bound)),
        Some(Sound::None(_)) | None => None,
    };
    let finite = |value: &f64| value.is_finite();
    let mark = Mark {
        place,
        anchor: crate::report::html::cell::anchor(&table.id, row, column),
        cell,
        printed: printed.filter(finite),
        exact: cell.exact.as_ref().map(nearest).filter(finite),
        sound: sound.filter(finite),
    };
    let shows = mark.values().next().is_some();
    shows.then_some(mark)
}

/// The headers below the picture, not too many of them.
pub(super) fn labels(along: &Axis, x: &Scale) -> Vec<(f64, String)> {
    let step = along.entries.len().div_ceil(MAX_LABELS);
    let label = |place: usize| {
        let at = x.at(f64::from(u32::try_from(place).unwrap_or(u32::MAX)));
        (at, along.entries[place].printed.clone())
    };
    (0..along.entries.len()).step_by(step).map(label).collect()
}

fn drawn(place: usize, line: &Line<'_>, x: &Scale, y: &Scale) -> Markup {
    let across = |mark: &Mark<'_>| x.at(f64::from(u32::try_from(mark.place).unwrap_or(u32::MAX)));
    let path = |value: fn(&Mark<'_>) -> Option<f64>| {
        let places = line.marks.iter().filter_map(|mark| Some((across(mark), y.at(value(mark)?))));
        places.collect::<Vec<(f64, f64)>>()
    };
    let (exact, sound) = (path(|mark| mark.exact), path(|mark| mark.sound));
    html! {
        g class={ "c" (place % MAX_LINES + 1) } {
            polyline.line points=(points(&exact)) {}
            @if !sound.is_empty() { polyline.dash points=(points(&sound)) {} }
            @for (x, y) in &exact { circle.dot cx=(x) cy=(y) r="2.5" {} }
            @for mark in &line.marks {
                @if let Some(printed) = mark.printed {
                    (ring(mark, across(mark), y.at(printed)))
                }
            }
        }
    }
}

/// A printed number: a link to its cell.
fn ring(mark: &Mark<'_>, x: f64, y: f64) -> Markup {
    let wrong = matches!(mark.cell.verdict, Verdict::Refuted | Verdict::Misprint(_));
    let printed = mark.cell.printed.as_deref().unwrap_or_default();
    html! {
        a href={ "#" (mark.anchor) } tabindex="-1" {
            circle.ring cx=(x) cy=(y) r="4.5" fill-opacity="0" { title { (mark.cell.locus) ": " (printed) ", " (mark.cell.verdict.word().name()) } }
            @if wrong {
                path.bad d={ "M" (x - 5.0) " " (y - 5.0) "l10 10m0 -10l-10 10" } {}
            }
        }
    }
}

/// The names of the lines at their right ends, moved apart where they would overlap.
fn names(lines: &[Line<'_>], y: &Scale) -> Markup {
    const APART: f64 = 18.0;
    let end = |(place, line): (usize, &Line<'_>)| {
        let last = line.marks.iter().rev().find_map(|mark| mark.exact.or(mark.printed))?;
        Some((y.at(last), place))
    };
    let mut ends: Vec<(f64, usize)> = lines.iter().enumerate().filter_map(end).collect();
    ends.sort_by(|left, right| left.0.total_cmp(&right.0));
    let mut above = f64::MIN;
    for (place, _) in &mut ends {
        *place = place.max(above + APART);
        above = *place;
    }
    // What was moved out at the bottom moves up again.
    let mut below = FRAME.y.0 + APART;
    for (place, _) in ends.iter_mut().rev() {
        *place = place.min(below - APART);
        below = *place;
    }
    html! {
        @for (height, place) in &ends {
            text class={ "name c" (place % MAX_LINES + 1) } x=(FRAME.x.1 + 8.0) y=(height + 4.0) textLength=[too_long(&lines[*place].name)] lengthAdjust="spacingAndGlyphs" { (lines[*place].name) }
        }
    }
}

/// The width that a name must be pressed into.
fn too_long(name: &str) -> Option<f64> {
    (name.chars().count() > 13).then_some(WIDTH - FRAME.x.1 - 10.0)
}
