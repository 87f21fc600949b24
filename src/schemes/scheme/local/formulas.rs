//! The formulas of a ring, and their places in the file.

use super::rules::{LocalError, Orbit};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::formula::LocatedFormula;
use crate::scheme::error::SchemeError;
use std::ops::Range;
use std::sync::Arc;

/// The index of a new point within its orbit, and the index of an edge within its family.
pub(in crate::scheme) const NEW_INDEX: &str = "i";

/// The index of an old point within its orbit.
pub(in crate::scheme) const OLD_INDEX: &str = "j";

/// The formulas of a ring.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::scheme) struct LocalFormulas {
    /// The orbits, with their numbers of points.
    pub(in crate::scheme) orbits: Vec<(String, LocatedFormula)>,
    /// For each orbit of new points and each orbit of old points, the formula of the
    /// weight in i and j. `None` stands for the weight 0.
    pub(in crate::scheme) weights: Vec<Vec<Option<LocatedFormula>>>,
    /// The families of edges.
    pub(in crate::scheme) edges: Vec<EdgeFormulas>,
}

/// A family of edges, one for each i.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::scheme) struct EdgeFormulas {
    pub(in crate::scheme) ends: [End; 2],
    pub(in crate::scheme) source: Arc<SourceText>,
    pub(in crate::scheme) span: Range<usize>,
}

/// An end of an edge: `vertex`, `edge[i + 1]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::scheme) struct End {
    pub(in crate::scheme) orbit: usize,
    /// The formula between the brackets. Its value is taken mod the number of points of
    /// the orbit.
    pub(in crate::scheme) index: Option<LocatedFormula>,
}

impl EdgeFormulas {
    /// An error if an end has no index though its orbit has more than one point.
    pub(in crate::scheme) fn check_brackets(&self, orbits: &[Orbit]) -> Result<(), SchemeError> {
        let bare = |end: &&End| end.index.is_none() && orbits[end.orbit].count > 1;
        let Some(end) = self.ends.iter().find(bare) else { return Ok(()) };
        let Orbit { name, count } = &orbits[end.orbit];
        let message = format!("`{name}` has {count} points, and this does not say which");
        Err(self.refusal(&message, Some(format!("write {name}[i], for i = 0, …, {}", count - 1))))
    }

    pub(in crate::scheme) fn refusal(&self, message: &str, help: Option<String>) -> SchemeError {
        let diagnostic = Diagnostic::new(&self.source, self.span.clone(), message);
        SchemeError::File(Box::new(Diagnostic { help, ..diagnostic }))
    }
}

impl LocalFormulas {
    /// The place that spans all weights.
    pub(in crate::scheme) fn whole(&self) -> (&Arc<SourceText>, Range<usize>) {
        extent(self.weights.iter().flatten().flatten())
    }

    /// The error that these formulas do not give a ring, at its place in the file. `at` may add
    /// labels.
    pub(in crate::scheme) fn refusal(
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
        SchemeError::File(Box::new(at(
            Diagnostic::new(source, span, error.to_string()).with_cap(error.cap())
        )))
    }
}

/// The place from the first to the last of these formulas. There is at least one, as the
/// reader refuses orbits without weights.
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
