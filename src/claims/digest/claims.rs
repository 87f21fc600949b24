//! The claims of a paper, whatever their kind, with their verdicts.

use crate::finding::{Finding, PaperAudit, PromiseCounts};
use crate::verdict::{Standing, Tally};

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

impl<'a> ClaimVerdict<'a> {
    pub(crate) fn of(finding: Finding<'_, 'a>) -> ClaimVerdict<'a> {
        let claim = finding.claim();
        ClaimVerdict { id: claim.id(), locus: claim.locus(), verdicts: finding.verdicts() }
    }

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
        self.findings().map(ClaimVerdict::of).collect()
    }
}

impl PaperAudit<'_> {
    /// How many printed bounds and depths keep their promise for every control polygon, how many
    /// break it, and of how many this is open.
    #[must_use]
    pub fn promise_counts(&self) -> PromiseCounts {
        self.tables.iter().fold(PromiseCounts::default(), |sum, table| sum + table.promise_counts())
    }
}
