//! The claims of a paper, whatever their kind, with their verdicts.

use crate::finding::{PaperAudit, PromiseCounts, RangeFinding};
use std::collections::BTreeMap;

/// A claim and its verdict; for a table, the verdicts of its cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ClaimVerdict<'a> {
    /// Its id within the paper.
    pub id: &'a str,
    /// Where it stands.
    pub locus: &'a str,
    /// How often each verdict occurs: once, or for a table once for each cell with it.
    pub verdicts: BTreeMap<&'static str, usize>,
}

/// The verdicts that say that a claim does not hold as printed.
const FAILING: [&str; 3] = ["refuted", "fails", "inexact"];

/// The verdicts that say that a claim holds as printed.
const HOLDING: [&str; 4] = ["confirmed", "holds", "exact", "proved"];

impl ClaimVerdict<'_> {
    /// Whether the claim is shown to hold: of a table, all of its cells.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.verdicts.keys().all(|verdict| HOLDING.contains(verdict))
    }

    /// Whether the claim does not hold: of a table, at least one of its cells.
    #[must_use]
    pub fn fails(&self) -> bool {
        FAILING.iter().any(|verdict| self.verdicts.contains_key(verdict))
    }
}

impl<'a> PaperAudit<'a> {
    /// Every claim of the paper with its verdict.
    #[must_use]
    pub fn claims(&self) -> Vec<ClaimVerdict<'a>> {
        let tables = self.tables.iter().map(|finding| ClaimVerdict {
            id: &finding.table.id,
            locus: &finding.table.locus,
            verdicts: count(finding.cells.iter().flatten().map(|cell| cell.verdict.name())),
        });
        let one = |id: &'a str, locus: &'a str, verdict| {
            let verdicts = BTreeMap::from([(verdict, 1)]);
            ClaimVerdict { id, locus, verdicts }
        };
        let equations = self.equations.iter().map(|finding| {
            one(&finding.equation.id, &finding.equation.locus, finding.verdict.name())
        });
        let functions = self
            .functions
            .iter()
            .map(|finding| one(&finding.claim.id, &finding.claim.locus, finding.verdict.name()));
        let ranges = self
            .ranges
            .iter()
            .map(|finding| one(&finding.claim.id, &finding.claim.locus, finding.verdict()));
        let theorems = self.theorems.iter().map(|finding| {
            one(&finding.theorem.id, &finding.theorem.locus, finding.verdict.name())
        });
        let smoothness = self
            .smoothness
            .iter()
            .map(|finding| one(&finding.claim.id, &finding.claim.locus, finding.verdict.name()));
        let claims = tables.chain(equations).chain(functions).chain(ranges);
        claims.chain(smoothness).chain(theorems).collect()
    }
}

/// How many times each name occurs.
pub(crate) fn count(names: impl Iterator<Item = &'static str>) -> BTreeMap<&'static str, usize> {
    let mut counts = BTreeMap::new();
    for name in names {
        *counts.entry(name).or_insert(0) += 1;
    }
    counts
}

impl PaperAudit<'_> {
    /// How many table cells have each verdict, in the order of [`Verdict::NAMES`](crate::finding::Verdict::NAMES).
    #[must_use]
    pub fn cell_counts(&self) -> BTreeMap<&'static str, usize> {
        let cells = self.tables.iter().flat_map(|table| table.cells.iter().flatten());
        count(cells.map(|cell| cell.verdict.name()))
    }

    /// How many printed bounds and depths keep their promise for every control polygon, how many
    /// break it, and of how many this is open.
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
        count(self.ranges.iter().map(RangeFinding::verdict))
    }

    /// How many claims about smoothness have each verdict.
    #[must_use]
    pub fn smoothness_counts(&self) -> BTreeMap<&'static str, usize> {
        count(self.smoothness.iter().map(|finding| finding.verdict.name()))
    }

    /// How many theorems have each verdict.
    #[must_use]
    pub fn theorem_counts(&self) -> BTreeMap<&'static str, usize> {
        count(self.theorems.iter().map(|finding| finding.verdict.name()))
    }
}
