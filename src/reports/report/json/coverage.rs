//! The numbered items of papers, and the claims about them, as JSON.

use super::SCHEMA;
use crate::audit::{ClaimVerdict, Coverage, PaperAudit};
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
        let claim =
            |claim: ClaimVerdict<'a>| CoveringClaim { id: claim.id, verdicts: claim.verdicts };
        let item = |coverage: Coverage<'a>| NumberedItem {
            item: coverage.item.label.to_string(),
            state: coverage.state().name(),
            reason: coverage.item.reason.as_deref(),
            claims: coverage.claims.into_iter().map(claim).collect(),
        };
        let paper = |audit: &PaperAudit<'a>| CoveredPaper {
            key: &audit.paper.key,
            items: audit.coverage().into_iter().map(item).collect(),
        };
        CoverageReport { schema: SCHEMA, papers: audits.iter().map(paper).collect() }
    }
}
