//! Ranges of a free parameter in reports.

use crate::audit::{PaperAudit, RangeFinding, Word};
use crate::diagnostic::Diagnostic;
use crate::report::formulas::function;
use crate::report::html::context::Context;
use crate::report::html::math::formula;
use crate::report::html::sheet::lines;
use crate::report::html::{picture, statement};
use crate::report::json::{Claim, Details, End, Sound, joined};
use crate::report::told::{Counted, Facts, Told};
use maud::{Markup, html};

static RANGES: Counted = Counted {
    several: "ranges",
    one: "range",
    column: "ranges\n✓ exact ≈ ✗",
    wrong: Word::Inexact,
    words: ["is wrong", "are wrong"],
    place: 3,
};

impl<'a> Told<'a> for RangeFinding<'a> {
    fn heading(&self) -> [&'static str; 2] {
        ["Parameter ranges", "ranges"]
    }

    fn counted(&self) -> Option<&'static Counted> {
        Some(&RANGES)
    }

    fn outcome(&self) -> String {
        function::range_outcome(self).join("\n")
    }

    fn states(&self, _: &PaperAudit<'_>) -> Facts {
        let claim = self.claim;
        let mut facts = function::head(&claim.variable, claim.scheme.as_ref());
        let limit = &claim.limit;
        let condition =
            format!("{} {} {}", claim.value.text, limit.relation(), limit.formula().text);
        facts.push(("condition".to_owned(), condition));
        facts
    }

    fn form<'s>(&'s self, _: &'s PaperAudit<'_>) -> Vec<Claim<'s>> {
        let claim = self.claim;
        let found = self.found.as_ref().ok();
        let ends = found.iter().flat_map(|found| &found.ends).map(End::of).collect();
        let details = Details::Range { variable: &claim.variable, ends };
        let (printed, verdict) = (function::printed(self), self.verdict().name());
        let cap = self.found.as_ref().err().map(ToString::to_string);
        vec![Claim {
            exact: found.map(|found| found.exact.to_string()),
            sound: found.map(|found| Sound::Range { kept: found.kept }),
            note: joined(cap, claim.note.as_deref()),
            ..Claim::plain(&self.id, &claim.locus, "range", printed, verdict, details)
        }]
    }

    fn erratum(&self) -> (Facts, Vec<String>) {
        let claim = self.claim;
        let exact = self.found.as_ref().map(|found| function::exactly(found, &claim.variable));
        let facts = [
            ("printed", function::printed(self)),
            ("correct", exact.unwrap_or_default()),
            ("in detail", self.outcome()),
        ];
        (
            facts.map(|(name, text)| (name.to_owned(), text)).to_vec(),
            Vec::from_iter(claim.note.clone()),
        )
    }

    fn difference(&self) -> [String; 2] {
        let exact = self.found.as_ref().map(|found| function::exactly(found, &self.claim.variable));
        [function::printed(self), exact.unwrap_or_default()]
    }

    fn contents(&self, context: &Context<'_, '_>) -> Result<Markup, Diagnostic> {
        let own = self.claim;
        let relation = match own.limit.relation() {
            "<" => "<",
            _ => "≤",
        };
        Ok(html! {
                dl.formulas {
                    div {
                        dt { "condition" }
                        dd { (formula(&own.value.expr)) " " (relation) " " (formula(&own.limit.formula().expr)) }
                    }
                    (statement::definitions(context.audit, &own.value))
                }
                @if let Some(picture) = picture::range(self) { (picture) }
                p.outcome { (lines(&self.outcome())) }
        })
    }
}
