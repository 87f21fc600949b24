//! Claims about the smoothness of limits in reports.

use crate::audit::{KnownLimits, PaperAudit, SmoothnessFinding, Word};
use crate::claim::SmoothnessClaim;
use crate::diagnostic::Diagnostic;
use crate::report::html::context::Context;
use crate::report::html::picture;
use crate::report::html::sheet::{facts, lines};
use crate::report::json::smooth::smoothness::SmoothnessDetails;
use crate::report::json::{Claim, Details};
use crate::report::smooth::smoothness;
use crate::report::told::{Counted, Facts, Told};
use maud::{Markup, html};
use std::borrow::Cow;

static STATEMENTS: Counted = Counted {
    several: "statements about smoothness",
    one: "statement",
    column: "smoothness\n✓ confirmed ≈ ✗ ?",
    wrong: Word::Refuted,
    words: ["is refuted", "are refuted"],
    place: 1,
};

impl<'a> Told<'a> for SmoothnessFinding<'a> {
    fn heading(&self) -> [&'static str; 2] {
        ["Smoothness", "smoothness"]
    }

    fn counted(&self) -> Option<&'static Counted> {
        Some(&STATEMENTS)
    }

    fn outcome(&self) -> String {
        smoothness::outcome(self).join("\n")
    }

    fn states(&self, _: &PaperAudit<'_>) -> Facts {
        stated(self.claim)
    }

    fn form<'s>(&'s self, _: &'s PaperAudit<'_>) -> Vec<Claim<'s>> {
        let claim = self.claim;
        let details = SmoothnessDetails::of(&self.known);
        let why = match &self.known {
            KnownLimits::Absent => claim.absent().map(|absent| format!("missing: {absent}")),
            KnownLimits::Capped(reason) => Some(reason.to_string()),
            KnownLimits::BeyondCap(cap) => Some(cap.to_string()),
            KnownLimits::Limits(_)
            | KnownLimits::Lattice(_)
            | KnownLimits::Range(_)
            | KnownLimits::Region(_)
            | KnownLimits::Vertices(_)
            | KnownLimits::VertexRanges(_) => None,
        };
        let exact = details.exact().cloned();
        let note = why.into_iter().chain(claim.note.clone()).collect::<Vec<String>>().join("; ");
        let cell = claim.cell.as_ref().map(|cell| cell.printed.as_str().into());
        let printed = cell.or_else(|| smoothness::statement(claim).map(Cow::Owned));
        let (kind, verdict) = (claim.kind.name(), self.verdict.word().name());
        let details = Details::Smoothness(Box::new(details));
        let plain = Claim::plain(&self.id, &claim.locus, kind, "", verdict, details);
        vec![Claim { printed, exact, note: (!note.is_empty()).then_some(note.into()), ..plain }]
    }

    fn details(&self) -> Facts {
        smoothness::details(self)
    }

    fn remarks(&self) -> Vec<String> {
        let states = smoothness::statement(self.claim).map(|states| format!("states: {states}"));
        states.into_iter().chain([self.outcome()]).chain(self.claim.note.clone()).collect()
    }

    fn erratum(&self) -> (Facts, Vec<String>) {
        let claim = self.claim;
        let mut facts = stated(claim);
        facts.push(("correct".to_owned(), self.outcome()));
        (facts, Vec::from_iter(claim.note.clone()))
    }

    fn difference(&self) -> [String; 2] {
        let printed = smoothness::statement(self.claim).unwrap_or_default();
        [printed, smoothness::outcome(self).join("; ")]
    }

    fn contents(&self, _: &Context<'_, '_>) -> Result<Markup, Diagnostic> {
        let own = self.claim;
        let details = self.details();
        Ok(html! {
                dl.formulas {
                    @if let Some(scheme) = smoothness::scheme(own) {
                        div { dt { "scheme" } dd { (scheme) } }
                    }
                    @if let Some(states) = smoothness::statement(own) {
                        div { dt { "states" } dd { (lines(&states)) } }
                    }
                }
                @if let Some(picture) = picture::smooth_range(self) { (picture) }
                p.outcome { (lines(&self.outcome())) }
                @if !details.is_empty() {
                    details { summary { "Spectral radius" } (facts(&details)) }
                }
        })
    }
}

/// The scheme, and what is said of it.
fn stated(claim: &SmoothnessClaim) -> Facts {
    let scheme = smoothness::scheme(claim).map(|scheme| ("scheme".to_owned(), scheme));
    let states = smoothness::statement(claim).map(|states| ("states".to_owned(), states));
    scheme.into_iter().chain(states).collect()
}
