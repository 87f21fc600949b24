//! Net files. Numbers are read from their text, exactly.

mod csv;
mod json;

use super::error::NetError;
use super::grid::{Closed, Net};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::Rational;
use crate::mesh::{Denominator, MAX_POINTS, Point, parse_coordinate};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

/// The forms of net files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NetFormat {
    /// A row of the net on each line.
    Csv,
    /// Arrays of rows of points.
    Json,
}

impl NetFormat {
    /// The form of a file by its extension; `None` where it is not that of a net.
    #[must_use]
    pub fn of(path: &Path) -> Option<NetFormat> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "csv" => Some(NetFormat::Csv),
            "json" => Some(NetFormat::Json),
            _ => None,
        }
    }

    /// The form of a text: JSON if it begins as an array or an object does.
    #[must_use]
    pub fn of_text(text: &str) -> NetFormat {
        let text = text.trim_start_matches('\u{feff}').trim_start();
        if text.starts_with(['[', '{']) { NetFormat::Json } else { NetFormat::Csv }
    }
}

/// Reads a net.
///
/// CSV has a row of the net on each line: its points separated by commas, the coordinates x y z of a
/// point by blanks; `#` begins a comment. JSON is an array of rows, each an array of points [x, y, z], or
/// an object with this as `points`, and `closed`: "none", "u", "v" or "uv". Numbers are decimals or
/// fractions, in JSON these as strings; all are read exactly. `closed` as given here goes before that of the
/// file; without both the net is open.
///
/// # Errors
/// When the text has another form, is cut off, has rows of different lengths, or its numbers are beyond
/// the caps; with the place, and mostly a remedy.
///
/// ```
/// use subcert::diagnostic::SourceText;
/// use subcert::net::{Closed, NetFormat, read_net};
///
/// let text = "0 0 0.1, 1 0 0\n0 1 0, 1 1 1/3\n";
/// let net = read_net(&SourceText::new("a.csv", text), NetFormat::Csv, None)?;
/// assert_eq!(net.points()[0][2].to_string(), "1/10");
/// let text = r#"{"closed": "v", "points": [[[0, 0, 1], [1, 0, "1/3"], [1, 1, 1]], [[0, 0, 0], [1, 0, 0], [1, 1, 0]]]}"#;
/// let net = read_net(&SourceText::new("a.json", text), NetFormat::Json, None)?;
/// assert_eq!((net.sizes(), net.closed()), ([2, 3], Closed { u: false, v: true }));
/// # Ok::<(), subcert::diagnostic::Diagnostic>(())
/// ```
pub fn read_net(
    source: &Arc<SourceText>,
    format: NetFormat,
    closed: Option<Closed>,
) -> Result<Net, Diagnostic> {
    let mut parts = Parts::new(source);
    let stated = match format {
        NetFormat::Csv => csv::read(&mut parts).map(|()| None),
        NetFormat::Json => json::read(&mut parts),
    }?;
    let help = match format {
        NetFormat::Csv => csv::HELP,
        NetFormat::Json => json::HELP,
    };
    parts.assemble(closed.or(stated).unwrap_or_default(), help)
}

/// What has been read of a file.
struct Parts<'a> {
    source: &'a Arc<SourceText>,
    points: Vec<Point<Rational>>,
    /// How many points the first row has, and its place.
    first: Option<(usize, Range<usize>)>,
    /// How many the current one has.
    row: usize,
    denominator: Denominator,
}

impl<'a> Parts<'a> {
    fn new(source: &'a Arc<SourceText>) -> Parts<'a> {
        Parts { source, points: Vec::new(), first: None, row: 0, denominator: Denominator::new() }
    }

    fn wrong(&self, place: Range<usize>, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(self.source, place, message)
    }

    /// A coordinate by its text.
    fn number(&self, text: &str, place: Range<usize>, help: &str) -> Result<Rational, Diagnostic> {
        parse_coordinate(text).map_err(|error| self.wrong(place, error.to_string()).with_help(help))
    }

    /// Adds a point to the current row.
    fn point(&mut self, point: Point<Rational>, place: Range<usize>) -> Result<(), Diagnostic> {
        if self.points.len() == MAX_POINTS {
            let message = format!("more than {MAX_POINTS} points; take a smaller net");
            return Err(self.wrong(place, message));
        }
        self.denominator.take(&point, self.source, &place)?;
        self.points.push(point);
        self.row += 1;
        Ok(())
    }

    /// Ends a row.
    fn end_row(&mut self, place: Range<usize>) -> Result<(), Diagnostic> {
        let found = std::mem::take(&mut self.row);
        match &self.first {
            None => self.first = Some((found, place)),
            Some((expected, first)) if *expected != found => {
                let message = format!(
                    "this row has {found} points, and the first row has {expected}: the rows of a \
                     net are of one length"
                );
                return Err(self
                    .wrong(place, message)
                    .with_place(first.clone(), "the first row")
                    .with_help("is a point missing, or is the file cut off?"));
            }
            Some(_) => {}
        }
        Ok(())
    }

    fn assemble(self, closed: Closed, help: &str) -> Result<Net, Diagnostic> {
        let columns = self.first.as_ref().map_or(0, |(columns, _)| *columns);
        let whole = self.source.text.len();
        Net::new(self.points, columns, closed).map_err(|error| {
            let (message, help) = match error {
                NetError::Ragged { points: 0, .. } => {
                    ("there is no point in this file".to_owned(), help)
                }
                error => (error.to_string(), "add points, or do not close the net there"),
            };
            Diagnostic::new(self.source, 0..whole.min(1), message).with_help(help)
        })
    }
}
