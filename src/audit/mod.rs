//! From claims to verdicts.

mod compare;
mod equation;
mod finding;
mod library;
mod mend;
mod promise;
mod quantity;
mod table;

pub use equation::{EquationFinding, EquationVerdict, Failure};
pub use finding::{Assumed, CellFinding, Direction, Missing, Slip, Sound, Verdict};
pub use quantity::QUANTITIES;
pub use table::TableFinding;

use crate::claim::Paper;
use crate::diagnostic::Diagnostic;
use library::Library;
use std::collections::BTreeMap;

/// The verdicts of a paper's claims.
#[derive(Debug)]
pub struct PaperAudit<'a> {
    /// The paper.
    pub paper: &'a Paper,
    /// Its tables, cell by cell.
    pub tables: Vec<TableFinding<'a>>,
    /// Its equations.
    pub equations: Vec<EquationFinding<'a>>,
}

/// Judges every claim of a paper.
///
/// # Errors
/// When a formula of the claim file is wrong: an unknown name or function, or
/// one that is used as it cannot be. A wrong claim is a finding, not an error.
///
/// ```
/// use subcert::audit::{audit, Verdict};
/// use subcert::claim::embedded_papers;
///
/// let papers = embedded_papers()?;
/// let khan = audit(&papers[1])?;
/// assert_eq!(khan.tables[0].cells[0][0].verdict, Verdict::Confirmed);
/// # Ok::<(), subcert::diagnostic::Diagnostic>(())
/// ```
pub fn audit(paper: &Paper) -> Result<PaperAudit<'_>, Diagnostic> {
    let library = Library::new(paper);
    let tables = paper.tables.iter().map(|claim| table::judge(paper, claim, &library));
    let equations = paper.equations.iter().map(|claim| equation::judge(paper, claim, &library));
    Ok(PaperAudit {
        paper,
        tables: tables.collect::<Result<_, _>>()?,
        equations: equations.collect::<Result<_, _>>()?,
    })
}

impl PaperAudit<'_> {
    /// How many table cells have each verdict, in the order of [`Verdict::NAMES`].
    #[must_use]
    pub fn cell_counts(&self) -> BTreeMap<&'static str, usize> {
        let mut counts = BTreeMap::new();
        for cell in self.tables.iter().flat_map(|table| table.cells.iter().flatten()) {
            *counts.entry(cell.verdict.name()).or_insert(0) += 1;
        }
        counts
    }

    /// How many equations have each verdict.
    #[must_use]
    pub fn equation_counts(&self) -> BTreeMap<&'static str, usize> {
        let mut counts = BTreeMap::new();
        for equation in &self.equations {
            *counts.entry(equation.verdict.name()).or_insert(0) += 1;
        }
        counts
    }
}
