//! The numbered items of papers, and the claims about them, as JSON.

use super::{SCHEMA, counts};
use crate::audit::{self, ClaimVerdict, Coverage, KernelCounts, PaperAudit};
use serde::Serialize;
use std::collections::BTreeMap;

/// What `subcert coverage` finds.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CoverageReport<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The papers.
    pub papers: Vec<CoveredPaper<'a>>,
}

/// The numbered items of a paper, and the claims about them.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CoveredPaper<'a> {
    /// The paper's key.
    pub key: &'a str,
    /// The numbered items; empty where the claim file does not list them.
    pub items: Vec<NumberedItem<'a>>,
    /// How many of its findings are theorems of Coq.
    pub checked_by_coq: CheckedByCoq,
}

/// How many findings of a paper Coq's kernel accepts, and how many there are, kind by kind.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CheckedByCoq {
    /// Values of cells.
    pub values: Share,
    /// Sound bounds and depths.
    pub sound: Share,
    /// Broken promises.
    pub broken: Share,
    /// Promises that are broken at natural parameters too.
    pub broken_naturally: Share,
    /// Refuted theorems.
    pub refuted: Share,
    /// Theorems that are refuted at natural parameters too.
    pub refuted_naturally: Share,
    /// All other findings.
    pub others: Share,
    /// All findings.
    pub total: Share,
}

/// How many findings Coq's kernel accepts, of how many.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Share {
    /// Those that it accepts.
    pub checked: usize,
    /// All.
    pub all: usize,
}

impl CheckedByCoq {
    fn of(counts: &KernelCounts) -> CheckedByCoq {
        let share = |share: audit::Share| Share { checked: share.proved, all: share.all };
        CheckedByCoq {
            values: share(counts.values),
            sound: share(counts.sound),
            broken: share(counts.broken),
            broken_naturally: share(counts.broken_naturally),
            refuted: share(counts.refuted),
            refuted_naturally: share(counts.refuted_naturally),
            others: share(counts.others),
            total: share(counts.total()),
        }
    }
}

/// An item that a paper numbers.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct NumberedItem<'a> {
    /// Its number.
    pub item: String,
    /// `claimed`, `unclaimed` for a reason, or `missing`.
    pub state: &'static str,
    /// The claims that cover it.
    pub claims: Vec<CoveringClaim<'a>>,
    /// Why no claim covers it.
    pub reason: Option<&'a str>,
}

/// A claim that covers an item.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CoveringClaim<'a> {
    /// Its id within the paper.
    pub id: &'a str,
    /// How often each verdict occurs: once, or once for each cell of a table.
    pub verdicts: BTreeMap<&'static str, usize>,
}

impl<'a> CoverageReport<'a> {
    /// The JSON form of these audits.
    #[must_use]
    pub fn of(audits: &[PaperAudit<'a>]) -> CoverageReport<'a> {
        let claim = |claim: ClaimVerdict<'a>| CoveringClaim {
            id: claim.id,
            verdicts: counts(&claim.verdicts),
        };
        let item = |coverage: Coverage<'a>| NumberedItem {
            item: coverage.item.label.to_string(),
            state: coverage.state().name(),
            reason: coverage.item.reason.as_deref(),
            claims: coverage.claims.into_iter().map(claim).collect(),
        };
        let paper = |audit: &PaperAudit<'a>| CoveredPaper {
            key: &audit.paper.key,
            items: audit.coverage().into_iter().map(item).collect(),
            checked_by_coq: CheckedByCoq::of(&audit.kernel_counts()),
        };
        CoverageReport { schema: SCHEMA, papers: audits.iter().map(paper).collect() }
    }
}
