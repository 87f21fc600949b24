//! From claims to verdicts.

mod attained;
mod claims;
mod compare;
mod consistency;
mod coverage;
mod equation;
mod errata;
mod evidence;
mod finding;
mod function;
mod hypotheses;
mod jobs;
mod judge;
mod kept;
mod library;
mod mend;
mod options;
mod parametric;
mod promise;
mod promised;
mod quantity;
mod range;
mod reading;
mod row;
mod series;
mod shape;
mod summary;
mod table;
mod theorem;

pub use attained::{AttainedConstant, Powers, SearchedConstant};
pub use claims::ClaimVerdict;
pub use consistency::{Contradiction, Side, TablePart};
pub use coverage::{Coverage, CoverageState};
pub use equation::{EquationFinding, EquationVerdict, Failure};
pub use errata::{CellErratum, Consequences, Errata, Erratum, Subject, Unchecked};
pub use evidence::{Evidence, SoundCell, evidence};
pub use finding::{AsRead, Assumed, CellFinding, Direction, Missing, Slip, Sound, Verdict};
pub use function::{Example, FunctionFinding, FunctionVerdict};
pub use kept::{Broken, ControlData, Kept};
pub use promise::PromiseCounts;
pub use promised::{Later, PromiseEvidence, promise_evidence};
pub use quantity::QUANTITIES;
pub use range::{EndFinding, EndRelation, RangeFinding, RangeVerdict};
pub use reading::{
    Choice, Difference, Effect, Explanation, FAMILY, Line, LineReading, MAX_DIFFERENCES, Need,
    Search, Solved, Way,
};
pub use summary::{CellGroup, CellOutcome, CellSummary, Standing};
pub use table::TableFinding;
pub use theorem::{
    Attained, CaseFinding, Control, Correction, FailingPremise, LevelEvidence, Levels, Outcome,
    Place, Refutation, Repair, Supremum, TheoremFinding, TheoremVerdict, Violation,
};

use crate::claim::Paper;
use crate::diagnostic::Diagnostic;
use claims::count;
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
    /// Its closed forms in a free parameter.
    pub functions: Vec<FunctionFinding<'a>>,
    /// Its ranges of a free parameter.
    pub ranges: Vec<RangeFinding<'a>>,
    /// Its theorems.
    pub theorems: Vec<TheoremFinding<'a>>,
    /// Where its tables need different readings or values of a parameter.
    pub contradictions: Vec<Contradiction>,
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
/// let khan = audit(&papers[2])?;
/// assert_eq!(khan.tables[0].cells[0][0].verdict, Verdict::Confirmed);
/// # Ok::<(), subcert::diagnostic::Diagnostic>(())
/// ```
///
/// # Panics
/// Never.
pub fn audit(paper: &Paper) -> Result<PaperAudit<'_>, Diagnostic> {
    let mut audits = audit_all(std::slice::from_ref(paper), &|| {})?;
    Ok(audits.pop().expect("an audit for the paper"))
}

/// Judges every claim of these papers, each by itself, on all cores; `after_table` is
/// called when a table is judged.
///
/// # Errors
/// As [`audit`]: the first error of the first paper that has one.
pub fn audit_all<'a>(
    papers: &'a [Paper],
    after_table: &(dyn Fn() + Sync),
) -> Result<Vec<PaperAudit<'a>>, Diagnostic> {
    jobs::judge(papers, after_table)
}

/// Every reading of a table that the search compares, with what it explains, the best
/// first; empty where nothing is printed.
///
/// # Errors
/// As [`audit`].
pub fn readings(paper: &Paper, finding: &TableFinding<'_>) -> Result<Vec<Explanation>, Diagnostic> {
    table::readings(paper, finding, &Library::new(paper))
}

impl PaperAudit<'_> {
    /// How many table cells have each verdict, in the order of [`Verdict::NAMES`].
    #[must_use]
    pub fn cell_counts(&self) -> BTreeMap<&'static str, usize> {
        let cells = self.tables.iter().flat_map(|table| table.cells.iter().flatten());
        count(cells.map(|cell| cell.verdict.name()))
    }

    /// How many printed bounds and depths keep their promise for every control polygon,
    /// do not, and are open.
    #[must_use]
    pub fn promise_counts(&self) -> PromiseCounts {
        self.tables.iter().fold(PromiseCounts::default(), |sum, table| sum + table.promise_counts())
    }

    /// How many equations have each verdict, those between functions of a free
    /// parameter among them.
    #[must_use]
    pub fn equation_counts(&self) -> BTreeMap<&'static str, usize> {
        let equations = self.equations.iter().map(|finding| finding.verdict.name());
        count(equations.chain(self.functions.iter().map(|finding| finding.verdict.name())))
    }

    /// How many ranges have each verdict.
    #[must_use]
    pub fn range_counts(&self) -> BTreeMap<&'static str, usize> {
        count(self.ranges.iter().map(|finding| finding.verdict.name()))
    }

    /// How many theorems have each verdict.
    #[must_use]
    pub fn theorem_counts(&self) -> BTreeMap<&'static str, usize> {
        count(self.theorems.iter().map(|finding| finding.verdict.name()))
    }
}
