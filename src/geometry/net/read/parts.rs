//! From points with their places to a net.

use super::super::error::NetError;
use super::super::grid::{Closed, Net};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::{Rational, parse_rational};
use crate::mesh::{Denominator, MAX_POINTS, Point};
use std::ops::Range;
use std::sync::Arc;

/// What has been read of a file.
pub(super) struct Parts<'a> {
    pub(super) source: &'a Arc<SourceText>,
    points: Vec<Point<Rational>>,
    /// How many points the first row has, and its place.
    first: Option<(usize, Range<usize>)>,
    /// How many the current one has.
    row: usize,
    denominator: Denominator,
}

impl<'a> Parts<'a> {
    pub(super) fn new(source: &'a Arc<SourceText>) -> Parts<'a> {
        Parts { source, points: Vec::new(), first: None, row: 0, denominator: Denominator::new() }
    }

    pub(super) fn wrong(&self, place: Range<usize>, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(self.source, place, message)
    }

    /// A coordinate by its text.
    pub(super) fn number(
        &self,
        text: &str,
        place: Range<usize>,
        help: &str,
    ) -> Result<Rational, Diagnostic> {
        parse_rational(text).map_err(|error| self.wrong(place, error.to_string()).with_help(help))
    }

    /// Adds a point to the current row.
    pub(super) fn point(
        &mut self,
        point: Point<Rational>,
        place: Range<usize>,
    ) -> Result<(), Diagnostic> {
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
    pub(super) fn end_row(&mut self, place: Range<usize>) -> Result<(), Diagnostic> {
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

    pub(super) fn assemble(self, closed: Closed, help: &str) -> Result<Net, Diagnostic> {
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
