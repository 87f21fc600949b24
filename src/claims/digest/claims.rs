//! The claims of a paper, whatever their kind, with their verdicts.

use crate::finding::{PaperAudit, PromiseCounts, RangeFinding};
use crate::verdict::{Standing, Tally, Word};

/// A claim and its verdict; for a table, the verdicts of its cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ClaimVerdict<'a> {
    /// Its id within the paper.
    pub id: &'a str,
    /// Where it stands.
    pub locus: &'a str,
    /// How often each verdict occurs: once, or for a table once for each cell with it.
    pub verdicts: Tally,
}

impl ClaimVerdict<'_> {
    /// Whether the claim is shown to hold: of a table, all of its cells.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.verdicts.iter().all(|(word, _)| word.standing() == Standing::Holds)
    }

    /// Whether the claim does not hold: of a table, at least one of its cells.
    #[must_use]
    pub fn fails(&self) -> bool {
        self.verdicts.iter().any(|(word, _)| word.standing() == Standing::Fails)
    }
}

impl<'a> PaperAudit<'a> {
    /// Every claim of the paper with its verdict.
    #[must_use]
    pub fn claims(&self) -> Vec<ClaimVerdict<'a>> {
        let tables = self.tables.iter().map(|finding| ClaimVerdict {
            id: &finding.table.id,
            locus: &finding.table.locus,
            verdicts: finding.cells.iter().flatten().map(|cell| cell.verdict.word()).collect(),
        });
        let one = |id: &'a str, locus: &'a str, verdict: Word| ClaimVerdict {
            id,
            locus,
            verdicts: Tally::from_iter([verdict]),
        };
        let equations = self.equations.iter().map(|finding| {
            one(&finding.equation.id, &finding.equation.locus, finding.verdict.word())
        });
        let functions = self
            .functions
            .iter()
            .map(|finding| one(&finding.claim.id, &finding.claim.locus, finding.verdict.word()));
        let ranges = self
            .ranges
            .iter()
            .map(|finding| one(&finding.claim.id, &finding.claim.locus, finding.verdict()));
        let theorems = self.theorems.iter().map(|finding| {
            one(&finding.theorem.id, &finding.theorem.locus, finding.verdict.word())
        });
        let smoothness = self
            .smoothness
            .iter()
            .map(|finding| one(&finding.claim.id, &finding.claim.locus, finding.verdict.word()));
        let claims = tables.chain(equations).chain(functions).chain(ranges);
        claims.chain(smoothness).chain(theorems).collect()
    }
}

impl PaperAudit<'_> {
    /// How many table cells have each verdict.
    #[must_use]
    pub fn cell_counts(&self) -> Tally {
        let cells = self.tables.iter().flat_map(|table| table.cells.iter().flatten());
        cells.map(|cell| cell.verdict.word()).collect()
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
    pub fn equation_counts(&self) -> Tally {
        let equations = self.equations.iter().map(|finding| finding.verdict.word());
        equations.chain(self.functions.iter().map(|finding| finding.verdict.word())).collect()
    }

    /// How many ranges have each verdict.
    #[must_use]
    pub fn range_counts(&self) -> Tally {
        self.ranges.iter().map(RangeFinding::verdict).collect()
    }

    /// How many claims about smoothness have each verdict.
    #[must_use]
    pub fn smoothness_counts(&self) -> Tally {
        self.smoothness.iter().map(|finding| finding.verdict.word()).collect()
    }

    /// How many theorems have each verdict.
    #[must_use]
    pub fn theorem_counts(&self) -> Tally {
        self.theorems.iter().map(|finding| finding.verdict.word()).collect()
    }
}
