//! The errata of a paper, for a journal: what is wrong, what follows from it, and what could not be
//! checked.

mod consequence;
mod sharp;
pub use consequence::Consequences;
pub use sharp::{Beyond, NotSharp};

use crate::claim::{Printed, Promise};
use crate::digest::cause::Cause;
use crate::digest::summary::{CellOutcome, CellStanding, CellSummary};
use crate::exact::Rounding;
use crate::finding::{CellFinding, Finding, Harm, PaperAudit, TableFinding};
use crate::verdict::{Standing, Word};
use std::collections::BTreeMap;

/// The errata of a paper.
#[derive(Debug)]
pub struct Errata<'e, 'a> {
    /// The audit that they come from.
    pub audit: &'e PaperAudit<'a>,
    /// What is wrong, in the order of the claims: tables, equations, functions,
    /// ranges, smoothness, theorems.
    pub errata: Vec<Erratum<'e, 'a>>,
    /// The tables some of whose parameters the paper does not state and were recovered.
    pub recovered: Vec<&'e TableFinding<'a>>,
    /// Cells that could not be checked.
    pub unchecked: Vec<Unchecked<'e, 'a>>,
}

/// Something that is wrong.
#[derive(Debug)]
pub struct Erratum<'e, 'a> {
    /// What is wrong.
    pub subject: Subject<'e, 'a>,
    /// What follows from it.
    pub consequences: Consequences<'e, 'a>,
}

/// What is wrong.
#[derive(Debug)]
pub enum Subject<'e, 'a> {
    /// Cells of a table, by one cause.
    Cells(CellErratum<'e, 'a>),
    /// A claim of another kind.
    Claim(Finding<'e, 'a>),
}

/// Cells of a table that have one outcome.
#[derive(Debug)]
pub struct CellErratum<'e, 'a> {
    /// The table.
    pub finding: &'e TableFinding<'a>,
    /// Their outcome.
    pub outcome: CellOutcome,
    /// Whether their digits are those of the printed definition. Then the cells are errata only
    /// since they break their promise, or are not shown to keep it.
    pub as_defined: bool,
    /// Their places: row and column, counted from 0.
    pub cells: Vec<(usize, usize)>,
}

/// Cells of a table that could not be checked.
#[derive(Debug)]
pub struct Unchecked<'e, 'a> {
    /// The table.
    pub finding: &'e TableFinding<'a>,
    /// The cause: what is absent.
    pub cause: Option<Cause>,
    /// Their places: row and column, counted from 0.
    pub cells: Vec<(usize, usize)>,
}

impl<'e> CellErratum<'e, '_> {
    /// The findings of the cells.
    pub fn findings(&self) -> impl Iterator<Item = &'e CellFinding> + Clone {
        self.cells.iter().map(|&(row, column)| &self.finding.cells[row][column])
    }
}

impl<'a> PaperAudit<'a> {
    /// The errata of the paper.
    ///
    /// ```
    /// use subcert::audit::audit;
    /// use subcert::claim::embedded_papers;
    ///
    /// let papers = embedded_papers()?;
    /// let audit = audit(&papers[2])?;
    /// assert!(audit.errata().errata.iter().any(|erratum| erratum.id() == "table-1"));
    /// # Ok::<(), subcert::diagnostic::Diagnostic>(())
    /// ```
    #[must_use]
    pub fn errata<'e>(&'e self) -> Errata<'e, 'a> {
        let subjects = self.findings().flat_map(|finding| -> Vec<Subject<'e, 'a>> {
            if let Finding::Table(finding) = finding {
                return cell_errata(finding).into_iter().map(Subject::Cells).collect();
            }
            let fails = finding.word().is_some_and(|word| word.standing() == Standing::Fails);
            fails.then_some(Subject::Claim(finding)).into_iter().collect()
        });
        let errata = subjects.map(|subject| {
            let consequences = self.consequences(&subject);
            Erratum { subject, consequences }
        });
        let unchecked = self.tables.iter().flat_map(unchecked).collect();
        let recovered = self.tables.iter().filter(|finding| !finding.recovered.is_empty());
        let (errata, recovered) = (errata.collect(), recovered.collect());
        Errata { audit: self, errata, recovered, unchecked }
    }
}

impl<'e, 'a> Subject<'e, 'a> {
    /// The finding; for cells, that of their table.
    #[must_use]
    pub fn finding(&self) -> Finding<'e, 'a> {
        match self {
            Subject::Cells(cells) => Finding::Table(cells.finding),
            Subject::Claim(finding) => *finding,
        }
    }

    /// The id of the claim within the paper; for cells, the id of their table.
    #[must_use]
    pub fn id(&self) -> &'a str {
        self.finding().claim().id()
    }

    /// Where it stands.
    #[must_use]
    pub fn locus(&self) -> &'a str {
        self.finding().claim().locus()
    }

    /// The word for its verdict; for cells, of the first cell's verdict.
    #[must_use]
    pub fn verdict(&self) -> Word {
        let word = match self {
            Subject::Cells(cells) => cells.findings().next().map(|cell| cell.verdict.word()),
            Subject::Claim(finding) => finding.word(),
        };
        word.unwrap_or(Word::Refuted)
    }
}
impl<'a> Erratum<'_, 'a> {
    /// The id of the claim within the paper; for cells, the id of their table.
    #[must_use]
    pub fn id(&self) -> &'a str {
        self.subject.id()
    }

    /// The harm that it does.
    #[must_use]
    pub fn harm(&self) -> Harm {
        match &self.subject {
            Subject::Cells(_) if self.consequences.broken > 0 => Harm::Broken,
            Subject::Cells(_) if self.consequences.open > 0 => Harm::Unshown,
            subject => subject.finding().harm(),
        }
    }
}

/// The places of a table's cells, grouped by a key; cells without a key are left out.
fn grouped<'e, K: Ord>(
    finding: &'e TableFinding<'_>,
    key: impl Fn(&'e CellFinding, Option<&'e Printed>) -> Option<K>,
) -> BTreeMap<K, Vec<(usize, usize)>> {
    let mut groups: BTreeMap<K, Vec<(usize, usize)>> = BTreeMap::new();
    for (row, cells) in finding.cells.iter().enumerate() {
        for (column, cell) in cells.iter().enumerate() {
            if let Some(key) = key(cell, finding.table.cells[row][column].printed()) {
                groups.entry(key).or_default().push((row, column));
            }
        }
    }
    groups
}

fn cell_errata<'e, 'a>(finding: &'e TableFinding<'a>) -> Vec<CellErratum<'e, 'a>> {
    let groups = grouped(finding, |cell, printed| {
        let CellOutcome { standing, cause } = cell.outcome();
        let as_defined = match standing {
            CellStanding::NotCheckable => return None,
            CellStanding::Confirmed => true,
            CellStanding::Reproduced => has_digits(cell, printed),
            CellStanding::Explained | CellStanding::Misprinted | CellStanding::Refuted => false,
        };
        let fails = cell.keeps_promise() == Some(false) || cell.may_break_promise();
        // Cells with the right digits need no reading as a cause.
        let values = Cause::recovered(&cell.assumed, None);
        let cause = if as_defined { cause.map(|_| values) } else { cause };
        (fails || !as_defined).then_some((CellOutcome { standing, cause }, as_defined))
    });
    let erratum =
        |((outcome, as_defined), cells)| CellErratum { finding, outcome, as_defined, cells };
    groups.into_iter().map(erratum).collect()
}

/// Whether the printed digits are those of the printed definition.
fn has_digits(cell: &CellFinding, printed: Option<&Printed>) -> bool {
    let (Some(printed), Some(exact)) = (printed, &cell.exact) else { return false };
    matches!(printed.decimal.rounding_of(exact), Rounding::Exact | Rounding::Nearest)
}

fn unchecked<'e, 'a>(finding: &'e TableFinding<'a>) -> Vec<Unchecked<'e, 'a>> {
    let groups = grouped(finding, |cell, _| {
        let outcome = cell.outcome();
        if cell.is_blank() {
            return None;
        }
        (outcome.standing == CellStanding::NotCheckable).then_some(outcome.cause)
    });
    groups.into_iter().map(|(cause, cells)| Unchecked { finding, cause, cells }).collect()
}

impl<'e> Unchecked<'e, '_> {
    /// The findings of the cells.
    pub fn findings(&self) -> impl Iterator<Item = &'e CellFinding> + Clone {
        self.cells.iter().map(|&(row, column)| &self.finding.cells[row][column])
    }

    /// The outcomes of these cells if the values put in were stated.
    #[must_use]
    pub fn if_assumed(&self) -> CellSummary {
        CellSummary::of(self.findings())
    }

    /// Whether the cells are depths.
    #[must_use]
    pub fn depths(&self) -> bool {
        matches!(self.finding.table.promise, Some(Promise::Depth { .. }))
    }
}
