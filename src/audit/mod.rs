//! From claims to verdicts.

mod claims;
mod compare;
mod coverage;
mod equation;
mod finding;
mod function;
mod judge;
mod library;
mod mend;
mod options;
mod parametric;
mod promise;
mod quantity;
mod range;
mod reading;
mod row;
mod series;
mod shape;
mod table;
mod theorem;

pub use claims::ClaimVerdict;
pub use coverage::{Coverage, CoverageState};
pub use equation::{EquationFinding, EquationVerdict, Failure};
pub use finding::{AsRead, Assumed, CellFinding, Direction, Missing, Slip, Sound, Verdict};
pub use function::{Example, FunctionFinding, FunctionVerdict};
pub use quantity::QUANTITIES;
pub use range::{EndFinding, EndRelation, RangeFinding, RangeVerdict};
pub use reading::{
    Choice, Difference, Effect, Explanation, FAMILY, MAX_DIFFERENCES, Search, Solved, Way,
};
pub use table::TableFinding;
pub use theorem::{FailingPremise, TheoremFinding, TheoremVerdict};

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
pub fn audit(paper: &Paper) -> Result<PaperAudit<'_>, Diagnostic> {
    let library = Library::new(paper);
    let tables = paper.tables.iter().map(|claim| table::judge(paper, claim, &library));
    let equations = paper.equations.iter().map(|claim| equation::judge(paper, claim, &library));
    let functions = paper.functions.iter().map(|claim| function::judge(paper, claim, &library));
    let ranges = paper.ranges.iter().map(|claim| range::judge(paper, claim, &library));
    let mut audit = PaperAudit {
        paper,
        tables: tables.collect::<Result<_, _>>()?,
        equations: equations.collect::<Result<_, _>>()?,
        functions: functions.collect::<Result<_, _>>()?,
        ranges: ranges.collect::<Result<_, _>>()?,
        theorems: Vec::new(),
    };
    audit.theorems = theorem::judge(&audit);
    Ok(audit)
}

impl PaperAudit<'_> {
    /// How many table cells have each verdict, in the order of [`Verdict::NAMES`].
    #[must_use]
    pub fn cell_counts(&self) -> BTreeMap<&'static str, usize> {
        let cells = self.tables.iter().flat_map(|table| table.cells.iter().flatten());
        count(cells.map(|cell| cell.verdict.name()))
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
