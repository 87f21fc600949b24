//! The premises of theorems, and whether they hold.

use crate::claim::Theorem;
use crate::digest::claims::ClaimVerdict;
use crate::finding::{FailingPremise, Finding, PaperAudit, TheoremFinding, TheoremVerdict};
use std::collections::{BTreeMap, BTreeSet};

/// Finds the premises of theorems that do not hold, after all claims are judged.
pub(crate) fn premises(audit: &mut PaperAudit<'_>) {
    let mut findings = std::mem::take(&mut audit.theorems);
    find(audit, &mut findings);
    audit.theorems = findings;
}

/// Lists for each theorem the claims on which it rests and that do not hold. A proof by hand is
/// dropped if a claim that it uses is not shown to hold.
fn find<'a>(audit: &PaperAudit<'a>, findings: &mut [TheoremFinding<'a>]) {
    let theorems = &audit.paper.theorems;
    let by_id: BTreeMap<&str, &Theorem> = theorems.iter().map(|t| (t.id.as_str(), t)).collect();
    let mut judged = audit.claims();
    judged.extend(findings.iter().map(|finding| ClaimVerdict::of(Finding::Theorem(finding))));
    for finding in findings {
        // A proof by hand counts only if every claim that it uses is shown to hold.
        if let Some(hand) = &finding.theorem.by_hand
            && finding.refutation.is_none()
            && !hand.uses.iter().all(|id| judged.iter().any(|c| c.id == id && c.holds()))
        {
            (finding.verdict, finding.proof) = (TheoremVerdict::Open, None);
        }
        let rests = closure(finding.theorem, &by_id);
        let fails = |claim: &&ClaimVerdict<'a>| rests.contains(claim.id) && claim.fails();
        let premise =
            |claim: &ClaimVerdict<'a>| FailingPremise { id: claim.id, locus: claim.locus };
        finding.failing = judged.iter().filter(fails).map(premise).collect();
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
