//! Judging a theorem: so far, by what it rests on.

use super::PaperAudit;
use super::claims::ClaimVerdict;
use crate::claim::Theorem;
use std::collections::{BTreeMap, BTreeSet};

/// What the audit says of a theorem.
#[derive(Clone, Debug)]
pub struct TheoremFinding<'a> {
    /// `key:theorem`.
    pub id: String,
    /// The theorem.
    pub theorem: &'a Theorem,
    /// The verdict.
    pub verdict: TheoremVerdict,
    /// The claims that do not hold and that it rests on, at once or through other
    /// theorems. It may be true in spite of them; its proof does not show it.
    pub failing: Vec<FailingPremise<'a>>,
}

/// The verdict of a theorem.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TheoremVerdict {
    /// Neither proved nor refuted.
    Open,
}

impl TheoremVerdict {
    /// The verdict's name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            TheoremVerdict::Open => "open",
        }
    }
}

/// A claim that a theorem rests on, and that does not hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FailingPremise<'a> {
    /// Its id within the paper.
    pub id: &'a str,
    /// Where it stands.
    pub locus: &'a str,
}

/// Judges the theorems of a paper whose other claims are judged.
pub(super) fn judge<'a>(audit: &PaperAudit<'a>) -> Vec<TheoremFinding<'a>> {
    let theorems = &audit.paper.theorems;
    let by_id: BTreeMap<&str, &Theorem> = theorems.iter().map(|t| (t.id.as_str(), t)).collect();
    let judged = audit.claims();
    let finding = |theorem: &'a Theorem| {
        let rests = closure(theorem, &by_id);
        let fails = |claim: &&ClaimVerdict<'a>| rests.contains(claim.id) && claim.fails();
        let premise =
            |claim: &ClaimVerdict<'a>| FailingPremise { id: claim.id, locus: claim.locus };
        TheoremFinding {
            id: format!("{}:{}", audit.paper.key, theorem.id),
            theorem,
            verdict: TheoremVerdict::Open,
            failing: judged.iter().filter(fails).map(premise).collect(),
        }
    };
    theorems.iter().map(finding).collect()
}

/// The ids of what a theorem rests on, at once or through other theorems.
fn closure<'a>(theorem: &'a Theorem, by_id: &BTreeMap<&str, &'a Theorem>) -> BTreeSet<&'a str> {
    let mut closure = BTreeSet::new();
    let mut waiting = vec![theorem];
    while let Some(theorem) = waiting.pop() {
        for id in theorem.rests.iter().map(String::as_str) {
            if closure.insert(id) {
                waiting.extend(by_id.get(id));
            }
        }
    }
    closure
}
