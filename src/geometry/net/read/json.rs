//! Arrays of rows of points.

use super::super::grid::Closed;
use super::parts::Parts;
use crate::diagnostic::{Diagnostic, json_elements, json_fields, json_place};
use crate::exact::Rational;
use serde_json::value::RawValue;
use std::ops::Range;

pub(super) const HELP: &str = "write an array of rows, each an array of points: \
                    [[[0, 0, \"1/3\"], [1, 0, 0.25]], [[0, 1, 0], [1, 1, 0]]], or an object with this \
                    as `points`, and `closed`";

/// Reads the points; the result is what the file says of the seams.
pub(super) fn read(parts: &mut Parts<'_>) -> Result<Option<Closed>, Diagnostic> {
    let source = parts.source;
    let bom = if source.text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
    let whole = bom..source.text.len();
    let (mut points, mut closed) = (whole.clone(), None);
    if source.text[whole.clone()].trim_start().starts_with('{') {
        let mut found = None;
        let mut met = Vec::new();
        for (name, value) in json_fields(source, whole.clone(), HELP)? {
            let place = json_place(source, value);
            if met.contains(&name) {
                let message = format!("the field `{name}` stands twice");
                return Err(parts.wrong(place, message).with_help("remove one of them"));
            }
            met.push(name.clone());
            match name.as_str() {
                "points" => found = Some(place),
                "closed" => closed = Some(seams(parts, value, place)?),
                _ => {
                    let message = format!(
                        "there is no field `{name}` of nets; there are `points` and `closed`"
                    );
                    return Err(parts.wrong(place, message).with_help("remove it"));
                }
            }
        }
        let end = source.text.trim_end().len();
        let missing = || parts.wrong(end.saturating_sub(1)..end, "there is no field `points`");
        points = found.ok_or_else(|| missing().with_help(HELP))?;
    }
    for row in json_elements(source, points, HELP)? {
        let row = json_place(source, row);
        for point in json_elements(source, row.clone(), HELP)? {
            let place = json_place(source, point);
            let numbers = json_elements(source, place.clone(), HELP)?;
            let numbers: Vec<Rational> =
                numbers.into_iter().map(|raw| number(parts, raw)).collect::<Result<_, _>>()?;
            let point = <[Rational; 3]>::try_from(numbers).map_err(|numbers| {
                let message = format!("{} numbers here, and a point has three", numbers.len());
                parts.wrong(place.clone(), message).with_help(HELP)
            })?;
            parts.point(point, place)?;
        }
        parts.end_row(row)?;
    }
    Ok(closed)
}

fn seams(parts: &Parts<'_>, raw: &RawValue, place: Range<usize>) -> Result<Closed, Diagnostic> {
    let name: Option<String> = serde_json::from_str(raw.get()).ok();
    name.and_then(|name| Closed::parse(&name)).ok_or_else(|| {
        let message = "`closed` says in which directions the net is closed: \"none\", \"u\" (from row \
                       to row), \"v\" (along the rows) or \"uv\"";
        parts.wrong(place, message)
    })
}

fn number(parts: &Parts<'_>, raw: &RawValue) -> Result<Rational, Diagnostic> {
    let (text, place) = (raw.get(), json_place(parts.source, raw));
    match text.chars().next() {
        Some('"') => {
            let text: String = serde_json::from_str(text)
                .map_err(|error| parts.wrong(place.clone(), error.to_string()).with_help(HELP))?;
            parts.number(&text, place, HELP)
        }
        Some('-' | '0'..='9') => parts.number(text, place, HELP),
        _ => Err(parts
            .wrong(place, "this is neither a number nor a string that holds one")
            .with_help(HELP)),
    }
}
