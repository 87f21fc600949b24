//! Control polygons and grids in files: one reader for `depth` and `oracle`.

use crate::cli::console::output::Failure;
use serde_json::value::RawValue;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;
use subcert::diagnostic::{
    Diagnostic, SourceText, json_elements, json_place, read_bytes, text_or_latin1,
};
use subcert::exact::{Integer, Rational, parse_rational};

/// How much a file may hold.
pub(crate) struct Caps {
    /// The largest file that is read, in bytes.
    pub(crate) bytes: u64,
    /// The most points.
    pub(crate) points: usize,
    /// The most binary digits of a numerator, and of the common denominator of a coordinate.
    pub(crate) bits: u64,
}

/// The most coordinates of a point.
const MAX_COORDINATES: usize = 16;

/// A coordinate with its place in the file.
type Placed = (Rational, Range<usize>);

/// A control polygon in a file.
pub(crate) struct ControlPolygon {
    /// All x, then all y, and so on.
    pub(crate) coordinates: Vec<Vec<Rational>>,
    /// What is to be told of the file.
    pub(crate) notes: Vec<String>,
}

/// The control polygon in a file; whether it is `closed` is said elsewhere.
///
/// A file that begins with `[` is a JSON array of numbers or of arrays of them, each a
/// JSON number, which is read from its text, or a string such as "1/3". Any other has one
/// point on a line, its coordinates separated by commas, semicolons or white space; `#` begins a
/// comment.
pub(crate) fn read_polygon(
    path: &Path,
    caps: &Caps,
    closed: bool,
) -> Result<ControlPolygon, Failure> {
    let source = source(path, caps)?;
    let entries = entries(&source)?;
    let mut notes = Vec::new();
    if !is_json(&source) {
        notes.extend(empty_line(&source, ["points", "polygon"]));
    }
    let coordinates = coordinates(&source, entries, caps)?;
    if closed && coordinates.iter().all(|own| own.first() == own.last()) {
        notes.push(format!(
            "{}: the last point is the first; a closed polygon has an edge from its last point to its first, which here has the \
             length 0: leave out the last point",
            source.name
        ));
    }
    Ok(ControlPolygon { coordinates, notes })
}

/// A note on an empty line between two lines of numbers.
pub(crate) fn empty_line(source: &SourceText, [parts, whole]: [&str; 2]) -> Option<String> {
    let (mut met, mut empty) = (false, false);
    let next = source.text.lines().position(|line| {
        let numbers = !line.split('#').next().unwrap_or_default().trim().is_empty();
        empty |= met && line.trim().is_empty();
        met |= numbers;
        numbers && empty
    });
    next.map(|next| {
        format!(
            "{}: an empty line before line {}; the {parts} before and after it are one {whole}",
            source.name,
            next + 1
        )
    })
}

/// The control grid in a file: its rows, all of one length, and notes. Its form is that of a polygon, with a
/// row in place of a point.
pub(crate) fn read_grid(
    path: &Path,
    caps: &Caps,
) -> Result<(Vec<Vec<Rational>>, Vec<String>), Failure> {
    let source = source(path, caps)?;
    let rows = entries(&source)?;
    let columns = rows.first().map_or(0, Vec::len);
    if columns == 0 {
        let whole = 0..source.text.len();
        let error = Diagnostic::new(&source, whole, "there is no number in this file");
        return Err(error
            .with_help("write one row of the grid on a line, such as `1/3, 0.25`")
            .into());
    }
    if let Some(row) = rows.iter().find(|row| row.len() != columns) {
        let message = format!("{} numbers in this row, and {columns} in the first", row.len());
        return Err(Diagnostic::new(&source, extent(&source, row), message).into());
    }
    let told = empty_line(&source, ["rows", "grid"]).filter(|_| !is_json(&source));
    let rows = rows.into_iter().map(|row| row.into_iter().map(|(value, _)| value).collect());
    Ok((rows.collect(), told.into_iter().collect()))
}

fn source(path: &Path, caps: &Caps) -> Result<Arc<SourceText>, Failure> {
    let name = path.display().to_string();
    let text = read_bytes(path, caps.bytes).and_then(|bytes| {
        text_or_latin1(bytes).ok_or_else(|| "it is neither UTF-8 nor Latin-1 text".to_owned())
    });
    let text = text.map_err(|reason| Failure::Input(format!("cannot read `{name}`: {reason}")))?;
    Ok(SourceText::new(name, text))
}

/// The numbers of each point, or of each row of a grid.
fn entries(source: &Arc<SourceText>) -> Result<Vec<Vec<Placed>>, Diagnostic> {
    if is_json(source) { json_points(source) } else { lines(source) }
}

fn is_json(source: &SourceText) -> bool {
    source.text.trim_start().starts_with('[')
}

/// Where these numbers stand.
fn extent(source: &Arc<SourceText>, numbers: &[Placed]) -> Range<usize> {
    match (numbers.first(), numbers.last()) {
        (Some(first), Some(last)) => first.1.start..last.1.end,
        _ => 0..source.text.len(),
    }
}

fn lines(source: &Arc<SourceText>) -> Result<Vec<Vec<Placed>>, Diagnostic> {
    let mut points = Vec::new();
    let mut start = 0;
    // Old Macintosh files end their lines with \r alone.
    for line in source.text.split_inclusive(['\n', '\r']) {
        let numbers = line.split('#').next().unwrap_or_default();
        let mut point = Vec::new();
        let mut at = start;
        if let (Some(_), Some(comma)) = (numbers.find(';'), numbers.find(',')) {
            let comma = start + comma..start + comma + 1;
            let message = "this comma beside semicolons may be a decimal comma or a separator";
            return Err(Diagnostic::new(source, comma, message).with_help(
                "write decimals with a point, such as 0.25; or separate by commas alone",
            ));
        }
        for (count, cell) in numbers.split([',', ';']).enumerate() {
            let place = at..at + cell.len();
            at = place.end + 1;
            let before = point.len();
            for word in cell.split_whitespace() {
                let start = place.start + (word.as_ptr().addr() - cell.as_ptr().addr());
                point.push(number(source, word, start..start + word.len())?);
            }
            // A separator at the end of a line begins no cell.
            let last = place.end == start + numbers.len();
            if point.len() == before && !(last && (count == 0 || before > 0)) {
                let place = place.start..place.end.max(place.start + 1);
                let message = "there is no number in this cell";
                return Err(Diagnostic::new(source, place, message)
                    .with_help("write 0 where a coordinate is 0, and each separator once"));
            }
        }
        if !point.is_empty() {
            points.push(point);
        }
        start += line.len();
    }
    Ok(points)
}

fn number(source: &Arc<SourceText>, text: &str, span: Range<usize>) -> Result<Placed, Diagnostic> {
    match parse_rational(text) {
        Ok(value) => Ok((value, span)),
        Err(error) => Err(Diagnostic::new(source, span, error.to_string()).with_help(
            "write one point on a line, such as `1/3, 0.25`, and `#` before what is not a number",
        )),
    }
}

fn json_points(source: &Arc<SourceText>) -> Result<Vec<Vec<Placed>>, Diagnostic> {
    let whole = 0..source.text.len();
    let point = |raw: &RawValue| {
        let span = json_place(source, raw);
        if raw.get().starts_with('[') {
            let numbers = json_elements(source, span, JSON_HELP)?;
            numbers.into_iter().map(|raw| json_number(source, raw)).collect()
        } else {
            Ok(vec![json_number(source, raw)?])
        }
    };
    json_elements(source, whole, JSON_HELP)?.into_iter().map(point).collect()
}

const JSON_HELP: &str = "write an array of numbers, or of points: [[0, \"1/3\"], [0.25, 1]]";

fn json_number(source: &Arc<SourceText>, raw: &RawValue) -> Result<Placed, Diagnostic> {
    let (text, span) = (raw.get(), json_place(source, raw));
    let wrong =
        |message: String| Diagnostic::new(source, span.clone(), message).with_help(JSON_HELP);
    let parsed = match text.chars().next() {
        Some('"') => {
            let text: String = serde_json::from_str(text).map_err(|e| wrong(e.to_string()))?;
            parse_rational(&text)
        }
        Some('-' | '0'..='9') => parse_rational(text),
        _ => return Err(wrong("this is neither a number nor a string that holds one".to_owned())),
    };
    let value = parsed.map_err(|error| wrong(error.to_string()))?;
    Ok((value, span))
}

/// The points, turned into one sequence for each coordinate.
fn coordinates(
    source: &Arc<SourceText>,
    points: Vec<Vec<Placed>>,
    caps: &Caps,
) -> Result<Vec<Vec<Rational>>, Diagnostic> {
    let whole = 0..source.text.len();
    let count = points.first().map_or(0, Vec::len);
    if points.len() < 2 || points.len() > caps.points {
        let (found, most) = (points.len(), caps.points);
        let message = format!("a polygon has from 2 to {most} points; there are {found}");
        return Err(Diagnostic::new(source, whole, message)
            .with_help("write one point on a line, or a JSON array of them"));
    }
    let mut coordinates = vec![Vec::with_capacity(points.len()); count];
    let mut common = vec![Integer::one(); count];
    for point in points {
        if point.len() != count || !(1..=MAX_COORDINATES).contains(&count) {
            let message = format!(
                "{} coordinates here, and {count} of the first point; all have the same number of \
                 them, from 1 to {MAX_COORDINATES}",
                point.len()
            );
            return Err(Diagnostic::new(source, extent(source, &point), message));
        }
        for (j, (value, span)) in point.into_iter().enumerate() {
            common[j] = common[j].lcm(&value.denominator());
            if common[j].bits().max(value.numerator().bits()) > caps.bits {
                let message = format!(
                    "with this number a numerator or the common denominator has more than \
                     {} binary digits",
                    caps.bits
                );
                return Err(Diagnostic::new(source, span, message).with_help("round the numbers"));
            }
            coordinates[j].push(value);
        }
    }
    Ok(coordinates)
}
