//! The premises of theorems, and whether they hold.

use crate::claim::Theorem;
use crate::digest::claims::ClaimVerdict;
use crate::finding::{FailingPremise, PaperAudit, TheoremVerdict};
use std::collections::{BTreeMap, BTreeSet};

/// Lists for each theorem the claims on which it rests and that do not hold, after all claims are judged. A proof by
/// hand is dropped if a claim that it uses is not shown to hold.
pub(crate) fn premises<'a>(audit: &mut PaperAudit<'a>) {
    let theorems = &audit.paper.theorems;
    let by_id: BTreeMap<&str, &Theorem> = theorems.iter().map(|t| (t.id.as_str(), t)).collect();
    let judged = audit.claims();
    for finding in &mut audit.theorems {
        if let Some(hand) = &finding.theorem.by_hand
            && finding.refutation.is_none()
            && !hand.uses.iter().all(|id| judged.iter().any(|c| c.id == id && c.holds()))
        {
            (finding.verdict, finding.proof) = (TheoremVerdict::Open, None);
        }
        let rests = closure(finding.theorem, &by_id);
        let fails = judged.iter().filter(|claim| rests.contains(claim.id) && claim.fails());
        let premise =
            |claim: &ClaimVerdict<'a>| FailingPremise { id: claim.id, locus: claim.locus };
        finding.failing = fails.map(premise).collect();
    }
}

/// The ids of the claims on which a theorem rests, directly or through other theorems.
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
