//! The numbered items of a paper, and the claims about each.

use crate::claim::Item;
use crate::digest::claims::ClaimVerdict;
use crate::finding::PaperAudit;

/// A numbered item of a paper with the claims that cover it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Coverage<'a> {
    /// The item.
    pub item: &'a Item,
    /// The claims whose locus names it.
    pub claims: Vec<ClaimVerdict<'a>>,
}

/// The state of a numbered item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CoverageState {
    /// A claim names it.
    Claimed,
    /// It asserts nothing that can be checked, and the claim file says why.
    Unclaimed,
    /// No claim names it, and the claim file gives no reason.
    Missing,
}

impl CoverageState {
    /// Every state.
    pub const ALL: [CoverageState; 3] =
        [CoverageState::Claimed, CoverageState::Unclaimed, CoverageState::Missing];

    /// The state's name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            CoverageState::Claimed => "claimed",
            CoverageState::Unclaimed => "unclaimed",
            CoverageState::Missing => "missing",
        }
    }
}

impl Coverage<'_> {
    /// The state of the item.
    #[must_use]
    pub fn state(&self) -> CoverageState {
        match (self.claims.is_empty(), &self.item.reason) {
            (false, _) => CoverageState::Claimed,
            (true, Some(_)) => CoverageState::Unclaimed,
            (true, None) => CoverageState::Missing,
        }
    }
}

impl<'a> PaperAudit<'a> {
    /// Every numbered item of the paper; none when the claim file does not list them.
    #[must_use]
    pub fn coverage(&self) -> Vec<Coverage<'a>> {
        let judged = self.claims();
        let covering = |item: &'a Item| {
            let named = |claim: &&ClaimVerdict<'a>| item.claims.iter().any(|id| id == claim.id);
            Coverage { item, claims: judged.iter().filter(named).cloned().collect() }
        };
        self.paper.contents.iter().map(covering).collect()
    }
}
