//! The consequences of an erratum.

use crate::claim::Statement;
use crate::digest::errata::{CellErratum, Subject};
use crate::exact::RealCyclotomic;
use crate::finding::{CellFinding, Finding, PaperAudit, TheoremFinding};
use crate::formula::LocatedFormula;

/// The consequences of an erratum, computed.
#[derive(Debug, Default)]
pub struct Consequences<'e, 'a> {
    /// How many printed numbers are smaller than the definition's: levels or bounds
    /// that promise too much.
    pub smaller: usize,
    /// How many are larger.
    pub larger: usize,
    /// How many printed depths or bounds are less than the printed formula needs for their promise.
    pub broken_by_formula: usize,
    /// How many printed depths or bounds keep their promise for all control data.
    pub kept: usize,
    /// How many break their promise for some control data.
    pub broken: usize,
    /// Of how many it is not known whether they keep their promise.
    pub open: usize,
    /// Loci of the tables, ranges and theorems whose formula uses the definition.
    pub used_by: Vec<&'a str>,
    /// The theorems that rest on the claim, directly or through other theorems.
    pub theorems: Vec<&'e TheoremFinding<'a>>,
}

impl Consequences<'_, '_> {
    /// Whether anything follows for what the paper concludes.
    #[must_use]
    pub fn any(&self) -> bool {
        self.broken_by_formula + self.broken + self.open > 0
            || !self.used_by.is_empty()
            || !self.theorems.is_empty()
    }
}

impl<'a> PaperAudit<'a> {
    pub(crate) fn consequences<'e>(&'e self, subject: &Subject<'e, 'a>) -> Consequences<'e, 'a> {
        let id = subject.id();
        let rests = |finding: &&TheoremFinding<'a>| finding.failing.iter().any(|p| p.id == id);
        let mut consequences = Consequences {
            theorems: self.theorems.iter().filter(rests).collect(),
            ..Consequences::default()
        };
        match subject {
            Subject::Cells(cells) => {
                let count = |is: &dyn Fn(&CellFinding) -> bool| {
                    cells.findings().filter(|cell| is(cell)).count()
                };
                if !cells.as_defined {
                    let off = |sign: i8| {
                        cells
                            .cells
                            .iter()
                            .filter(|&&at| difference_sign(cells, at) == Some(sign))
                            .count()
                    };
                    (consequences.smaller, consequences.larger) = (off(-1), off(1));
                }
                consequences.broken_by_formula = count(&|cell| cell.kept_by_formula == Some(false));
                consequences.kept = count(&|cell| cell.keeps_promise() == Some(true));
                consequences.broken = count(&|cell| cell.keeps_promise() == Some(false));
                consequences.open = count(&CellFinding::may_break_promise);
            }
            Subject::Claim(Finding::Function(finding)) => {
                consequences.used_by = self.used_by(&finding.claim.left.text);
            }
            Subject::Claim(_) => {}
        }
        consequences
    }

    /// The loci of the tables, ranges and theorems whose formula uses a definition.
    fn used_by(&self, name: &str) -> Vec<&'a str> {
        if !self.paper.definitions.contains_key(name) {
            return Vec::new();
        }
        let uses = |formula: &LocatedFormula| self.paper.definitions_in(formula).contains_key(name);
        let (tables, ranges) = (&self.paper.tables, &self.paper.ranges);
        let tables = tables.iter().filter(|table| uses(&table.value)).map(|table| &table.locus);
        let ranges = ranges.iter().filter(|range| uses(&range.value)).map(|range| &range.locus);
        let theorems = self.paper.theorems.iter().filter(|theorem| {
            matches!(&theorem.statement, Statement::Bound { by, .. } | Statement::Depth(by) if uses(by))
        });
        let mut loci: Vec<&'a str> = Vec::new();
        let theorems = theorems.map(|theorem| &theorem.locus);
        for locus in tables.chain(ranges).chain(theorems) {
            if !loci.contains(&locus.as_str()) {
                loci.push(locus);
            }
        }
        loci
    }
}

/// The sign of the printed number less the exact value.
fn difference_sign(cells: &CellErratum<'_, '_>, at: (usize, usize)) -> Option<i8> {
    let printed = cells.finding.table.cells[at.0][at.1].printed()?.decimal.value();
    let exact = cells.finding.cells[at.0][at.1].exact.as_ref()?;
    Some((&RealCyclotomic::from(printed) - exact).sign())
}
