//! Errata as JSON.

use super::SCHEMA;
use super::claim::Claim;
use super::consistency::Contradiction;
use super::summary::Summary;
use crate::audit::{self, Cause, CellErratum, Errata, PaperAudit, Subject, TableFinding};
use crate::report::errata::cells::{correct, origin};
use crate::report::json::tables::recovered::Recovered;
use crate::report::told::{Told as _, told};
use serde::Serialize;

/// What `subcert errata` finds.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ErrataReport<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The papers.
    pub papers: Vec<PaperErrata<'a>>,
}

/// What is wrong in a paper.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PaperErrata<'a> {
    /// The paper's key.
    pub key: &'a str,
    /// A note for the reader about the text from which the claims are taken.
    pub note: Option<&'a str>,
    /// What is wrong.
    pub errata: Vec<Erratum<'a>>,
    /// The claims about smoothness that are true, where more is true.
    pub not_sharp: Vec<Claim<'a>>,
    /// The parameters that the paper does not state and that its numbers determine, by tables.
    pub recovered: Vec<OfTable<'a>>,
    /// The cells that could not be checked.
    pub unchecked: Vec<Unchecked<'a>>,
    /// The other claims of which a value is beyond a cap.
    pub beyond_caps: Vec<BeyondCap<'a>>,
    /// Where its tables need different readings.
    pub contradictions: Vec<Contradiction<'a>>,
    /// Its theorems.
    pub theorems: Vec<Claim<'a>>,
    /// How many cells are in each standing.
    pub cells: Summary,
}

/// The parameters of a table that the paper does not state.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct OfTable<'a> {
    /// The id of the table.
    pub table: &'a str,
    /// Where in the paper it is.
    pub locus: &'a str,
    /// The parameters, with their values.
    pub parameters: Vec<Recovered<'a>>,
}

/// Something wrong.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Erratum<'a> {
    /// Its number, from 1.
    pub number: usize,
    /// The id of the claim or table.
    pub id: String,
    /// Where in the paper it is.
    pub locus: &'a str,
    /// The verdict.
    pub verdict: &'static str,
    /// What it may do to those who rely on it: `refuted`, `broken`, `unshown`, `formula`, `number` or `not-sharp`.
    pub harm: &'static str,
    /// The claim, or the cells of the table.
    pub detail: Detail<'a>,
    /// What follows from it.
    pub changes: Changes<'a>,
}

/// What is wrong.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum Detail<'a> {
    /// Cells of a table.
    Cells(WrongCells<'a>),
    /// Any other claim.
    Claim(Box<Claim<'a>>),
}

/// Cells of a table that are wrong for one reason.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct WrongCells<'a> {
    /// Their standing.
    pub standing: &'static str,
    /// Its cause.
    pub cause: Option<String>,
    /// Whether their digits are right, and only their promise is not kept, or not shown to be.
    pub as_defined: bool,
    /// How the cells came about.
    pub origin: String,
    /// The cells.
    pub cells: Vec<WrongCell<'a>>,
}

/// A wrong cell.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct WrongCell<'a> {
    /// Its id.
    pub id: &'a str,
    /// Where in the table it is.
    pub locus: &'a str,
    /// What is printed.
    pub printed: Option<&'a str>,
    /// The value of the printed definition, in the form of the printed number.
    pub by_definition: Option<String>,
}

/// What follows from an erratum.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Changes<'a> {
    /// Whether anything follows.
    pub any: bool,
    /// How many printed numbers are smaller than the definition's.
    pub smaller: usize,
    /// How many are larger.
    pub larger: usize,
    /// How many printed depths or bounds are less than the printed formula needs for their promise.
    pub broken_by_formula: usize,
    /// How many keep their promise for all control data.
    pub kept: usize,
    /// How many break their promise for some control data.
    pub broken: usize,
    /// Of how many it is not known whether they keep their promise.
    pub open: usize,
    /// The loci of the tables, ranges and theorems that use the claim's formula.
    pub used_by: Vec<&'a str>,
    /// The ids of the theorems that rest on the claim.
    pub theorems: Vec<&'a str>,
}

/// A claim of which a value is beyond a cap.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BeyondCap<'a> {
    /// Its id within the paper.
    pub id: &'a str,
    /// Where in the paper it is.
    pub locus: &'a str,
    /// The cap.
    pub cap: String,
}

impl<'a> BeyondCap<'a> {
    fn of(one: audit::BeyondCap<'a>) -> BeyondCap<'a> {
        BeyondCap { id: one.id, locus: one.locus, cap: one.cap }
    }
}

/// Cells of a table that could not be checked.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Unchecked<'a> {
    /// The id of the table.
    pub table: &'a str,
    /// Where in the paper it is.
    pub locus: &'a str,
    /// Why they could not be checked.
    pub cause: Option<String>,
    /// The ids of the cells.
    pub cells: Vec<&'a str>,
    /// Their outcomes, also at the values assumed for what the paper does not state.
    pub outcomes: Summary,
}

impl<'a> ErrataReport<'a> {
    /// The JSON form of the errata of these papers.
    #[must_use]
    pub fn of(audits: &'a [PaperAudit<'_>]) -> ErrataReport<'a> {
        let paper = |audit: &'a PaperAudit<'_>| PaperErrata::of(audit.errata());
        ErrataReport { schema: SCHEMA, papers: audits.iter().map(paper).collect() }
    }
}

impl<'a> PaperErrata<'a> {
    fn of(errata: Errata<'a, 'a>) -> PaperErrata<'a> {
        let audit = errata.audit;
        let numbered = (1..).zip(errata.errata);
        let not_sharp = audit.not_sharp().into_iter();
        PaperErrata {
            key: &audit.paper.key,
            note: audit.paper.bibliography.note.as_deref(),
            errata: numbered.map(|(number, one)| Erratum::of(audit, number, one)).collect(),
            not_sharp: not_sharp.flat_map(|one| one.finding.form(audit)).collect(),
            recovered: errata.recovered.iter().map(|finding| OfTable::of(finding)).collect(),
            unchecked: errata.unchecked.iter().map(Unchecked::of).collect(),
            beyond_caps: audit.beyond_caps().into_iter().map(BeyondCap::of).collect(),
            contradictions: Contradiction::all(audit),
            theorems: audit.theorems.iter().flat_map(|theorem| theorem.form(audit)).collect(),
            cells: Summary::of(&audit.cell_summary()),
        }
    }
}

impl<'a> Erratum<'a> {
    fn of(
        audit: &'a PaperAudit<'a>,
        number: usize,
        erratum: audit::Erratum<'a, 'a>,
    ) -> Erratum<'a> {
        let harm = erratum.harm().name();
        let audit::Erratum { subject, consequences } = erratum;
        let changes = Changes {
            any: consequences.any(),
            smaller: consequences.smaller,
            larger: consequences.larger,
            broken_by_formula: consequences.broken_by_formula,
            kept: consequences.kept,
            broken: consequences.broken,
            open: consequences.open,
            theorems: consequences.theorems.iter().map(|theorem| theorem.id.as_str()).collect(),
            used_by: consequences.used_by,
        };
        Erratum {
            number,
            id: format!("{}:{}", audit.paper.key, subject.id()),
            locus: subject.locus(),
            verdict: subject.verdict().name(),
            harm,
            detail: Detail::of(audit, subject),
            changes,
        }
    }
}

impl<'a> Detail<'a> {
    fn of(audit: &'a PaperAudit<'a>, subject: Subject<'a, 'a>) -> Detail<'a> {
        match subject {
            Subject::Cells(cells) => Detail::Cells(WrongCells::of(&cells)),
            Subject::Claim(finding) => {
                let mut claims = told(finding).form(audit);
                Detail::Claim(Box::new(claims.pop().expect("one claim of a finding without cells")))
            }
        }
    }
}

impl<'a> WrongCells<'a> {
    fn of(cells: &CellErratum<'a, 'a>) -> WrongCells<'a> {
        let promised = cells.finding.table.promise.is_some();
        let cell = |&(row, column): &(usize, usize)| {
            let finding = &cells.finding.cells[row][column];
            let printed = cells.finding.table.cells[row][column].printed();
            WrongCell {
                id: &finding.id,
                locus: &finding.locus,
                printed: finding.printed.as_deref(),
                by_definition: printed
                    .map(|printed| correct(finding.exact.as_ref(), printed, promised)),
            }
        };
        WrongCells {
            standing: cells.outcome.standing.name(),
            cause: cells.outcome.cause.as_ref().map(Cause::to_string),
            as_defined: cells.as_defined,
            origin: origin(cells),
            cells: cells.cells.iter().map(cell).collect(),
        }
    }
}

impl<'a> OfTable<'a> {
    fn of(finding: &'a TableFinding<'_>) -> OfTable<'a> {
        OfTable {
            table: &finding.table.id,
            locus: &finding.table.locus,
            parameters: finding.recovered.iter().map(Recovered::of).collect(),
        }
    }
}

impl<'a> Unchecked<'a> {
    fn of(group: &audit::Unchecked<'a, 'a>) -> Unchecked<'a> {
        Unchecked {
            table: &group.finding.table.id,
            locus: &group.finding.table.locus,
            cells: group.findings().map(|cell| cell.id.as_str()).collect(),
            outcomes: Summary::of(&group.if_assumed()),
            cause: group.cause.as_ref().map(Cause::to_string),
        }
    }
}
