//! A summary of the cells of a paper's tables.

use crate::digest::cause::Cause;
use crate::finding::{CellFinding, Missing, PaperAudit, TableFinding, Verdict};
use crate::verdict::Word;
use std::cmp::Reverse;
use std::collections::BTreeMap;

/// The standing of a cell: its verdict, where another rounding and another reading count as one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum CellStanding {
    /// As printed.
    Confirmed,
    /// As printed, or by another reading, at values that were recovered.
    Reproduced,
    /// Rounded otherwise, or by another reading.
    Explained,
    /// One slip away from the value as printed, or under a reading.
    Misprinted,
    /// None of these.
    Refuted,
    /// Something that it needs is absent.
    NotCheckable,
}

impl CellStanding {
    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            CellStanding::Confirmed => Word::Confirmed.name(),
            CellStanding::Reproduced => Word::Reproduced.name(),
            CellStanding::Explained => "explained",
            CellStanding::Misprinted => "misprinted",
            CellStanding::Refuted => Word::Refuted.name(),
            CellStanding::NotCheckable => "not checkable",
        }
    }
}

/// The standing of a cell, and its cause: the reading that explains it, or what is absent.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct CellOutcome {
    /// The standing.
    pub standing: CellStanding,
    /// The cause; `None` where there is nothing to say.
    pub cause: Option<Cause>,
}

/// Cells that have one outcome.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CellGroup {
    /// The outcome.
    pub outcome: CellOutcome,
    /// The outcome if the values put in for unstated parameters were stated.
    pub if_assumed: Option<CellOutcome>,
    /// How many cells.
    pub count: usize,
}

/// The cells of a paper's tables by outcome.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CellSummary {
    /// The groups, by standing, the largest of each first; each cell is in one.
    pub groups: Vec<CellGroup>,
}

impl CellSummary {
    /// Sorts cells into groups.
    #[must_use]
    pub fn of<'c>(cells: impl IntoIterator<Item = &'c CellFinding>) -> CellSummary {
        let mut counts: BTreeMap<(CellOutcome, Option<CellOutcome>), usize> = BTreeMap::new();
        for cell in cells {
            *counts.entry((cell.outcome(), cell.outcome_if_assumed())).or_insert(0) += 1;
        }
        let group = |((outcome, if_assumed), count)| CellGroup { outcome, if_assumed, count };
        let mut groups: Vec<CellGroup> = counts.into_iter().map(group).collect();
        groups.sort_by_key(|group| (group.outcome.standing, Reverse(group.count)));
        CellSummary { groups }
    }

    /// How many cells there are.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.groups.iter().map(|group| group.count).sum()
    }

    /// How many of them have this standing.
    #[must_use]
    pub fn count(&self, standing: CellStanding) -> usize {
        let groups = self.groups.iter().filter(|group| group.outcome.standing == standing);
        groups.map(|group| group.count).sum()
    }
}

impl CellFinding {
    /// The standing of the cell, and its cause.
    #[must_use]
    pub fn outcome(&self) -> CellOutcome {
        self.as_outcome(&self.verdict)
    }

    /// The outcome if the values put in for unstated parameters were stated; `None` where none were
    /// put in.
    #[must_use]
    pub fn outcome_if_assumed(&self) -> Option<CellOutcome> {
        self.verdict_if_assumed.as_ref().map(|verdict| self.as_outcome(verdict))
    }

    fn as_outcome(&self, verdict: &Verdict) -> CellOutcome {
        let read = || self.as_read.as_ref();
        let (standing, cause) = match verdict {
            Verdict::Confirmed => (CellStanding::Confirmed, None),
            Verdict::Reproduced => {
                (CellStanding::Reproduced, Some(Cause::recovered(&self.assumed, read())))
            }
            Verdict::Rounding(direction) => {
                (CellStanding::Explained, Some(Cause::Rounded(*direction)))
            }
            Verdict::OtherReading => (CellStanding::Explained, read().map(Cause::read)),
            Verdict::Misprint(_) => (CellStanding::Misprinted, Some(Cause::slip(read()))),
            Verdict::Refuted => {
                (CellStanding::Refuted, self.undefined.clone().map(Cause::Undefined))
            }
            Verdict::NotCheckable(missing) => {
                // A lost cell has no other cause.
                let is_lost = self.printed.is_none() && *missing != Missing::Number;
                let missing = if is_lost { &Missing::Cell } else { missing };
                (CellStanding::NotCheckable, Some(Cause::Missing(missing.clone())))
            }
        };
        CellOutcome { standing, cause }
    }
}

impl PaperAudit<'_> {
    /// The cells of all tables by outcome, but for those in which nothing is printed.
    ///
    /// ```
    /// use subcert::audit::{CellStanding, audit};
    /// use subcert::claim::embedded_papers;
    ///
    /// let papers = embedded_papers()?;
    /// let khan = audit(&papers[2])?.cell_summary();
    /// assert_eq!((khan.cells(), khan.count(CellStanding::Confirmed)), (54, 6));
    /// # Ok::<(), subcert::diagnostic::Diagnostic>(())
    /// ```
    #[must_use]
    pub fn cell_summary(&self) -> CellSummary {
        CellSummary::of(self.tables.iter().flat_map(TableFinding::claiming))
    }
}
