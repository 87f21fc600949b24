//! A row of the net on each line.

use super::parts::Parts;
use crate::diagnostic::Diagnostic;
use crate::exact::Rational;
use std::ops::Range;

pub(super) const HELP: &str = "write one row of the net on a line: its points separated by commas, the \
                    coordinates of a point by blanks, such as `0 0 1/3, 1 0 0.25`, and `#` before what \
                    is no number";

pub(super) fn read(parts: &mut Parts<'_>) -> Result<(), Diagnostic> {
    let text = parts.source.text.clone();
    let mut start = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
    for line in text[start..].split_inclusive(['\n', '\r']) {
        let at = start;
        start += line.len();
        let line = line.split('#').next().unwrap_or_default();
        let row = within(&text, at..at + line.len());
        if row.is_empty() {
            continue;
        }
        let cells: Vec<&str> = text[row.clone()].split(',').collect();
        let mut from = row.start;
        for (number, cell) in cells.iter().enumerate() {
            let place = from..from + cell.len();
            from = place.end + 1;
            // A comma at the end of a line begins no point.
            let last = number > 0 && number + 1 == cells.len();
            if !(last && cell.trim().is_empty()) {
                read_cell(parts, &text, &place, cells.len())?;
            }
        }
        parts.end_row(row)?;
    }
    Ok(())
}

/// The place without blanks at its ends.
fn within(text: &str, place: Range<usize>) -> Range<usize> {
    let inside = text[place.clone()].trim_start();
    let start = place.end - inside.len();
    start..start + inside.trim_end().len()
}

fn read_cell(
    parts: &mut Parts<'_>,
    text: &str,
    cell: &Range<usize>,
    count: usize,
) -> Result<(), Diagnostic> {
    let mut place = within(text, cell.clone());
    // Tables put a cell with blanks between quotation marks.
    if let Some(inside) = text[place.clone()].strip_prefix('"').and_then(|x| x.strip_suffix('"')) {
        place = place.start + 1..place.start + 1 + inside.len();
    }
    let cell = &text[place.clone()];
    let mut point: Vec<Rational> = Vec::with_capacity(3);
    for word in cell.split_whitespace() {
        let at = place.start + (word.as_ptr().addr() - cell.as_ptr().addr());
        point.push(parts.number(word, at..at + word.len(), HELP)?);
    }
    let found = point.len();
    if let Ok(point) = <[Rational; 3]>::try_from(point) {
        return parts.point(point, place);
    }
    let numbers = if found == 1 { "number" } else { "numbers" };
    let message = match found {
        0 => "there is no point between these commas".to_owned(),
        _ => format!("{found} {numbers} here, and a point has three: x y z"),
    };
    let end = place.end.max(place.start + 1).min(text.len());
    let help = if found == 1 && count == 3 {
        "this may be one point on a line; a net has one row on a line: `0 0 1/3, 1 0 0.25`, \
         points separated by commas, coordinates by blanks"
    } else {
        HELP
    };
    Err(parts.wrong(place.start..end, message).with_help(help))
}
