//! Theorems in reports.

use crate::audit::{Naturally, PaperAudit, TheoremFinding, Word, by_hand};
use crate::claim::{Quantity, Statement};
use crate::diagnostic::Diagnostic;
use crate::formula::LocatedFormula;
use crate::report::html::context::Context;
use crate::report::html::math::formula;
use crate::report::html::picture::{self, Exceeding};
use crate::report::html::sheet::{facts, lines};
use crate::report::html::statement;
use crate::report::json::{Claim, Details, Trial, names};
use crate::report::theorems::theorem;
use crate::report::theorems::witness::compared;
use crate::report::told::{Background, Counted, Facts, Told};
use crate::report::words::parts;
use crate::report::words::sheet::Sheet;
use maud::{Markup, html};
use std::borrow::Cow;

static THEOREMS: Counted = Counted {
    several: "theorems",
    one: "theorem",
    column: "theorems\n✓ proved ✗ refuted ? open",
    wrong: Word::Refuted,
    words: ["is refuted", "are refuted"],
    place: 0,
};

impl<'a> Told<'a> for TheoremFinding<'a> {
    fn heading(&self) -> [&'static str; 2] {
        ["Theorems", "theorems"]
    }

    fn counted(&self) -> Option<&'static Counted> {
        Some(&THEOREMS)
    }

    fn outcome(&self) -> String {
        theorem::outcome(self)
    }

    fn is_right_naturally(&self) -> bool {
        let natural = self.refutation.as_ref().and_then(|refutation| refutation.natural.as_ref());
        matches!(natural, Some(Naturally::Holds))
    }

    fn states(&self, audit: &PaperAudit<'_>) -> Facts {
        let own = self.theorem;
        let mut facts = Facts::new();
        facts.extend(own.scheme.as_ref().map(|s| ("scheme".to_owned(), s.reference.to_string())));
        facts.push(("states".to_owned(), theorem::statement(own)));
        if let Statement::Bound { by, .. } | Statement::Depth(by) = &own.statement {
            facts.extend(parts::definitions(audit, by));
        }
        if !own.rests.is_empty() {
            facts.push(("rests on".to_owned(), own.rests.join(", ")));
        }
        facts
    }

    fn form<'s>(&'s self, _: &'s PaperAudit<'_>) -> Vec<Claim<'s>> {
        let theorem = self.theorem;
        let (bounds, from) = match &theorem.statement {
            Statement::Bound { quantity, from, .. } => (Some(quantity.name()), Some(*from)),
            Statement::Depth(_) => (Some("depth"), None),
            Statement::Other(_) => (None, None),
        };
        let printed = match &theorem.statement {
            Statement::Bound { by, .. } | Statement::Depth(by) => &by.text,
            Statement::Other(says) => says,
        };
        let failing = self.failing.iter().map(|premise| premise.id).collect();
        let details = Details::Theorem { bounds, from, rests: &theorem.rests, failing };
        let (printed, verdict) = (printed.as_str(), self.verdict.word().name());
        vec![Claim {
            trial: Some(Trial::of(self)),
            checked_by_coq: names(&self.by_kernel),
            note: theorem.note.as_deref().map(Cow::Borrowed),
            ..Claim::plain(&self.id, &theorem.locus, "theorem", printed, verdict, details)
        }]
    }

    fn in_full(
        &self,
        sheet: &mut Sheet,
        audit: &PaperAudit<'_>,
        background: Background<'_>,
        _: bool,
    ) {
        let mut facts = self.states(audit);
        let verdict = format!("{} {}", self.word().mark(), self.outcome());
        facts.push(("verdict".to_owned(), verdict));
        facts.extend(theorem::details(self, background.by_hand));
        facts.extend(self.theorem.note.clone().map(|note| ("note".to_owned(), note)));
        sheet.facts(facts);
    }

    fn remarks(&self) -> Vec<String> {
        vec![self.outcome()]
    }

    fn is_shown(&self) -> bool {
        true
    }

    fn erratum(&self) -> (Facts, Vec<String>) {
        let own = self.theorem;
        let mut facts = vec![
            ("states".to_owned(), theorem::statement(own)),
            ("verdict".to_owned(), self.outcome()),
        ];
        facts.extend(compared(self).map(|text| ("compared".to_owned(), text.to_owned())));
        (facts, Vec::from_iter(own.note.clone()))
    }

    fn difference(&self) -> [String; 2] {
        let outcome = self.outcome();
        let first = outcome.lines().next().unwrap_or_default();
        [theorem::statement(self.theorem), first.to_owned()]
    }

    fn contents(&self, context: &Context<'_, '_>) -> Result<Markup, Diagnostic> {
        let own = self.theorem;
        let hand = by_hand(context.audit, self)?;
        let violation = self.refutation.as_ref().map(|refutation| &refutation.violation);
        let drawing = violation.zip(hand.as_ref()).and_then(|(violation, hand)| {
            picture::witness(&hand.refiner, &Exceeding::of_theorem(violation))
        });
        let by = match &own.statement {
            Statement::Bound { by, .. } | Statement::Depth(by) => Some(by),
            Statement::Other(_) => None,
        };
        Ok(html! {
                dl.formulas {
                    div.wide[by.is_some_and(statement::is_long)] { dt { "states" } dd { (stated(&own.statement)) } }
                    @if let Some(by) = by { (statement::definitions(context.audit, by)) }
                }
                p.outcome { (lines(&self.outcome())) }
                @if let Some(drawing) = &drawing { (drawing) }
                @let details = theorem::details(self, hand.as_ref());
                @if !details.is_empty() && !context.is_whole {
                    details { summary { "Data and cases" } (facts(&details)) }
                }
        })
    }
}

/// What is stated.
fn stated(said: &Statement) -> Markup {
    let shown = |by: &LocatedFormula| formula(&by.expr);
    match said {
        Statement::Bound { quantity: bounded, by, from } => html! {
            (statement::quantity(*bounded)) " ≤ " (shown(by)) " for k ≥ " (from)
        },
        Statement::Depth(by) => {
            html! { (statement::quantity(Quantity::Distance)) " ≤ ε for k ≥ " (shown(by)) }
        }
        Statement::Other(says) => html! { (lines(says)) },
    }
}
