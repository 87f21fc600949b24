//! The formulas of a ring, and their places in the file.

use super::error::SchemeError;
use super::local_rules::{LocalError, Orbit};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::formula::LocatedFormula;
use std::ops::Range;
use std::sync::Arc;

/// The index of a new point within its orbit, and of the place along an edge.
pub(super) const NEW_INDEX: &str = "i";

/// The index of an old point within its orbit.
pub(super) const OLD_INDEX: &str = "j";

/// The formulas of a ring.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct LocalFormulas {
    /// The orbits, and how many points each has.
    pub(super) orbits: Vec<(String, LocatedFormula)>,
    /// For each orbit of new points, for each of old ones, the weight in i and j; 0 where
    /// there is none.
    pub(super) weights: Vec<Vec<Option<LocatedFormula>>>,
    /// The families of edges.
    pub(super) edges: Vec<EdgeFormulas>,
}

/// A family of edges, in i.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct EdgeFormulas {
    pub(super) ends: [End; 2],
    pub(super) source: Arc<SourceText>,
    pub(super) span: Range<usize>,
}

/// An end of an edge: `vertex`, `edge[i + 1]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct End {
    pub(super) orbit: usize,
    /// What stands between the brackets, counted mod the number of points of the orbit.
    pub(super) index: Option<LocatedFormula>,
}

impl EdgeFormulas {
    /// Makes sure that `edge` of N > 1 points has an index.
    pub(super) fn check_brackets(&self, orbits: &[Orbit]) -> Result<(), SchemeError> {
        let bare = |end: &&End| end.index.is_none() && orbits[end.orbit].count > 1;
        let Some(end) = self.ends.iter().find(bare) else { return Ok(()) };
        let Orbit { name, count } = &orbits[end.orbit];
        let message = format!("`{name}` has {count} points, and this does not say which");
        Err(self.refusal(&message, Some(format!("write {name}[i], for i = 0, …, {}", count - 1))))
    }

    pub(super) fn refusal(&self, message: &str, help: Option<String>) -> SchemeError {
        let diagnostic = Diagnostic::new(&self.source, self.span.clone(), message);
        SchemeError::File(Box::new(Diagnostic { help, ..diagnostic }))
    }
}

impl LocalFormulas {
    /// The place of all the weights.
    pub(super) fn whole(&self) -> (&Arc<SourceText>, Range<usize>) {
        extent(self.weights.iter().flatten().flatten())
    }

    /// Why these formulas do not give a ring, at their place in the file; `at` adds what else is
    /// known.
    pub(super) fn refusal(
        &self,
        error: &LocalError,
        at: impl FnOnce(Diagnostic) -> Diagnostic,
    ) -> SchemeError {
        let (source, span) = match error {
            LocalError::NotAffine { point, .. } => {
                let orbit = point.split('[').next().unwrap_or_default();
                let rows = self.orbits.iter().zip(&self.weights);
                let rows = rows.filter(|((name, _), _)| name == orbit).map(|(_, row)| row);
                extent(rows.flatten().flatten())
            }
            LocalError::Disconnected { .. } => {
                let (first, last) = (&self.edges[0], &self.edges[self.edges.len() - 1]);
                (&first.source, first.span.start..last.span.end)
            }
            _ => self.whole(),
        };
        SchemeError::File(Box::new(at(Diagnostic::new(source, span, error.to_string()))))
    }
}

/// From the first to the last of these formulas. The reader has made sure that each
/// orbit of new points has one.
fn extent<'a>(
    formulas: impl Iterator<Item = &'a LocatedFormula> + Clone,
) -> (&'a Arc<SourceText>, Range<usize>) {
    let spans = formulas.clone().map(|formula| &formula.span);
    let start = spans.clone().map(|span| span.start).min();
    let end = spans.map(|span| span.end).max();
    let mut formulas = formulas;
    let first = formulas.next().expect("the reader refuses orbits without weights");
    (&first.source, start.unwrap_or(0)..end.unwrap_or(0))
}
