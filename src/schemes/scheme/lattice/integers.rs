//! Lists of integer vectors, as they are typed: `[[1, 1], [1, -1]]`.

use super::dilation::{MAX_DIMENSION, Point};
use super::mask::MAX_PLACE;
use crate::diagnostic::{Diagnostic, SourceText};
use crate::scheme::spanned::Spanned;
use std::ops::Range;
use std::sync::Arc;

/// The most vectors of a list.
const MAX_VECTORS: usize = 64;

/// Vectors in a file. Whole numbers are read as texts.
pub(in crate::scheme) type VectorTable = Spanned<Vec<Spanned<Vec<Spanned<String>>>>>;

/// Vectors of integers, with their place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::scheme) struct Vectors {
    pub(in crate::scheme) rows: Vec<Vec<i64>>,
    source: Arc<SourceText>,
    pub(in crate::scheme) span: Range<usize>,
}

impl Vectors {
    /// The vectors in a file.
    ///
    /// # Errors
    /// When an entry is no integer, or one beyond the cap; when there are none, or too many.
    pub(in crate::scheme) fn of_table(
        source: &Arc<SourceText>,
        table: &VectorTable,
    ) -> Result<Vectors, Diagnostic> {
        let entry = |text: &Spanned<String>| integer(source, text.span(), text.get_ref());
        let row = |row: &Spanned<Vec<Spanned<String>>>| {
            row.get_ref().iter().map(entry).collect::<Result<Vec<i64>, Diagnostic>>()
        };
        let rows = table.get_ref().iter().map(row).collect::<Result<Vec<_>, Diagnostic>>()?;
        Vectors { rows, source: Arc::clone(source), span: table.span() }.checked()
    }

    /// The vectors of a text at this place: `[[1, 1], [1, -1]]`, or one of them, `[1, 1]`.
    ///
    /// # Errors
    /// As [`Vectors::of_table`], and where the text has another form.
    pub(in crate::scheme) fn of_text(
        source: &Arc<SourceText>,
        span: Range<usize>,
        text: &str,
    ) -> Result<Vectors, Diagnostic> {
        let form = || {
            Diagnostic::new(source, span.clone(), "this is no list of integer vectors")
                .with_help("write [[1, 1], [1, -1]]")
        };
        let bracket = |text: &str| -> Option<String> {
            Some(text.trim().strip_prefix('[')?.strip_suffix(']')?.trim().to_owned())
        };
        let inside = bracket(text).filter(|inside| !inside.is_empty()).ok_or_else(form)?;
        let numbers = |list: &str| {
            let number = |word: &str| integer(source, span.clone(), word);
            list.split(',').map(number).collect::<Result<Vec<i64>, Diagnostic>>()
        };
        if !inside.starts_with('[') {
            let rows = vec![numbers(&inside)?];
            return Vectors { rows, source: Arc::clone(source), span }.checked();
        }
        let mut rows = Vec::new();
        for (at, piece) in inside.split(']').enumerate() {
            // Between the vectors stand commas, and nothing behind the last.
            let piece = piece.trim();
            let piece = if at == 0 { Some(piece) } else { piece.strip_prefix(',') };
            match piece.map(str::trim) {
                None if at > 0 && rows.len() == at => {}
                Some(piece) => {
                    rows.push(numbers(piece.strip_prefix('[').ok_or_else(form)?)?);
                }
                None => return Err(form()),
            }
        }
        if inside.matches(']').count() != rows.len() || !inside.ends_with(']') {
            return Err(form());
        }
        Vectors { rows, source: Arc::clone(source), span }.checked()
    }

    /// An error at the place of the vectors.
    pub(in crate::scheme) fn error(&self, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(&self.source, self.span.clone(), message)
    }

    fn checked(self) -> Result<Vectors, Diagnostic> {
        let wrong = |message: String| self.error(message);
        if self.rows.is_empty() || self.rows.len() > MAX_VECTORS {
            let count = self.rows.len();
            return Err(wrong(format!("{count} vectors; there are from 1 to {MAX_VECTORS}")));
        }
        let length = self.rows[0].len();
        if length > MAX_DIMENSION || self.rows.iter().any(|row| row.len() != length) {
            return Err(wrong("these vectors have 2 coordinates each, or 3 each".to_owned()));
        }
        Ok(self)
    }

    /// The vectors as points of Z^d.
    ///
    /// # Errors
    /// When they have another number of coordinates, or one is 0.
    pub(in crate::scheme) fn points(&self, dimension: usize) -> Result<Vec<Point>, Diagnostic> {
        let wrong = |message: String| self.error(message);
        let point = |row: &Vec<i64>| {
            if row.len() != dimension {
                let message =
                    format!("a vector of {} coordinates in {dimension} dimensions", row.len());
                return Err(wrong(message));
            }
            if row.iter().all(|x| *x == 0) {
                return Err(wrong("a vector of zeros is no direction".to_owned()));
            }
            Ok(padded(row))
        };
        self.rows.iter().map(point).collect()
    }
}

/// The coordinates of a point, with zeros behind.
///
/// # Panics
/// For more than three.
pub(in crate::scheme) fn padded(row: &[i64]) -> Point {
    let mut point = [0; 3];
    point[..row.len()].copy_from_slice(row);
    point
}

fn integer(source: &Arc<SourceText>, span: Range<usize>, text: &str) -> Result<i64, Diagnostic> {
    let text = text.trim();
    let digits = text.strip_prefix('-').unwrap_or(text);
    let plain = !digits.is_empty() && digits.bytes().all(|c| c.is_ascii_digit());
    let number = text.parse::<i64>().ok().filter(|x| plain && x.unsigned_abs() <= MAX_PLACE);
    number.ok_or_else(|| {
        let message = format!("`{text}` is no integer from -{MAX_PLACE} to {MAX_PLACE}");
        Diagnostic::new(source, span, message)
    })
}
