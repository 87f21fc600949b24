//! Claims about smoothness as JSON.

use super::smoothness::SmoothnessDetails;
use crate::audit::{KnownLimits, SmoothnessFinding};
use crate::report::json::claim::{Claim, Details};
use crate::report::smooth::smoothness::statement;
use std::borrow::Cow;

impl<'a> Claim<'a> {
    pub(crate) fn of_smoothness(finding: &'a SmoothnessFinding<'_>) -> Claim<'a> {
        let claim = finding.claim;
        let details = SmoothnessDetails::of(&finding.known);
        let why = match &finding.known {
            KnownLimits::Absent => claim.absent().map(|absent| format!("missing: {absent}")),
            KnownLimits::Capped(reason) => Some(reason.to_string()),
            KnownLimits::BeyondCap(cap) => Some(cap.to_string()),
            KnownLimits::Limits(_)
            | KnownLimits::Range(_)
            | KnownLimits::Vertices(_)
            | KnownLimits::VertexRanges(_) => None,
        };
        let exact = details.exact().cloned();
        let note = why.into_iter().chain(claim.note.clone()).collect::<Vec<String>>().join("; ");
        let cell = claim.cell.as_ref().map(|cell| cell.printed.as_str().into());
        let printed = cell.or_else(|| statement(claim).map(Cow::Owned));
        let (kind, verdict) = (claim.kind.name(), finding.verdict.word().name());
        let details = Details::Smoothness(Box::new(details));
        let plain = Claim::plain(&finding.id, &claim.locus, kind, "", verdict, details);
        Claim { printed, exact, note: (!note.is_empty()).then_some(note.into()), ..plain }
    }
}
