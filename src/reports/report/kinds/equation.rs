//! Equations in reports.

use crate::audit::{EquationFinding, EquationVerdict, Failure, PaperAudit, RealCase, Word};
use crate::claim::{EquationBody, Left};
use crate::diagnostic::Diagnostic;
use crate::report::errata::differences::{LONGEST, cut};
use crate::report::formulas::equation;
use crate::report::html::context::Context;
use crate::report::html::sheet::lines;
use crate::report::html::statement::identity;
use crate::report::json::{self, Claim, Details, joined};
use crate::report::told::{Background, Counted, Facts, Told};
use crate::report::words::sheet::Sheet;
use maud::{Markup, html};

/// How many cases of a failing equation an erratum lists.
const MAX_CASES: usize = 6;

/// Equations, and closed forms in a parameter.
pub(super) static EQUATIONS: Counted = Counted {
    several: "equations",
    one: "equation",
    column: "equations\n✓ hold ✗ fail",
    wrong: Word::Fails,
    words: ["fails", "fail"],
    place: 2,
};

/// Relations between formulas, and properties of schemes.
static RELATIONS: Counted = Counted {
    several: "relations",
    one: "relation",
    column: "relations\n✓ hold ✗ fail",
    wrong: Word::Fails,
    words: ["fails", "fail"],
    place: 3,
};

impl<'a> Told<'a> for EquationFinding<'a> {
    fn heading(&self) -> [&'static str; 2] {
        if self.equation.is_relation {
            ["Relations", "relations"]
        } else {
            ["Equations", "equations"]
        }
    }

    fn counted(&self) -> Option<&'static Counted> {
        Some(if self.equation.is_relation { &RELATIONS } else { &EQUATIONS })
    }

    fn outcome(&self) -> String {
        equation::outcome(self)
    }

    fn states(&self, _: &PaperAudit<'_>) -> Facts {
        match &self.equation.body {
            EquationBody::Identity(identity) => equation::sides(identity),
            EquationBody::NotCheckable(_) => Facts::new(),
        }
    }

    fn form<'s>(&'s self, _: &'s PaperAudit<'_>) -> Vec<Claim<'s>> {
        let equation = self.equation;
        let holds_for = match &self.verdict {
            EquationVerdict::Reals(found) => {
                let set = |case: &RealCase| Some(case.truth.as_ref()?.describe(&found.name));
                found.cases.iter().map(set).collect()
            }
            _ => None,
        };
        let (failures, mends, absent) = match &self.verdict {
            EquationVerdict::Fails { failures, mends, .. } => {
                (Some(failures.iter().map(json::Failure::of).collect()), Some(&mends[..]), None)
            }
            EquationVerdict::Undecided { open, .. } => {
                (Some(open.iter().map(json::Failure::of).collect()), None, None)
            }
            EquationVerdict::NotCheckable => {
                (None, None, equation.absent().map(|absent| format!("missing: {absent}")))
            }
            EquationVerdict::BeyondCap(cap) => (None, None, Some(cap.to_string())),
            EquationVerdict::Holds { .. }
            | EquationVerdict::Proved
            | EquationVerdict::Reals(_)
            | EquationVerdict::Tried { .. } => (None, None, None),
        };
        let details = Details::Equation { failures, mends, holds_for };
        let (title, verdict) = (equation.title.as_str(), self.verdict.word().name());
        let claim =
            Claim::plain(&self.id, &equation.locus, equation.kind(), title, verdict, details);
        vec![Claim { note: joined(absent, equation.note.as_deref()), ..claim }]
    }

    fn in_full(&self, sheet: &mut Sheet, _: &PaperAudit<'_>, _: Background<'_>, _: bool) {
        if let EquationBody::Identity(identity) = &self.equation.body {
            sheet.facts(equation::sides(identity));
        }
        sheet.text(format!("{} {}", self.verdict.word().mark(), self.outcome()));
        if let EquationVerdict::Fails { failures, .. } = &self.verdict
            && !self.equation.is_relation
        {
            let fact = |failure: &Failure| {
                let sides = format!("left  = {}\nright = {}", failure.left, failure.right);
                (failure.at.clone(), sides)
            };
            sheet.facts(failures.iter().map(fact).collect());
        } else if let Some(note) = &self.equation.note {
            sheet.text(note.clone());
        }
    }

    fn remarks(&self) -> Vec<String> {
        vec![self.outcome()]
    }

    fn erratum(&self) -> (Facts, Vec<String>) {
        let origin = self.equation.note.iter().cloned();
        let (EquationVerdict::Fails { cases, failures, mends }, EquationBody::Identity(identity)) =
            (&self.verdict, &self.equation.body)
        else {
            return (Vec::new(), origin.collect());
        };
        let mut facts = equation::sides(identity);
        let numbers = matches!(identity.first().left, Left::Each(_));
        let mut lines = Vec::new();
        if !identity.is_for_all() {
            lines.push(format!("in {} of {cases} cases", failures.len()));
        }
        for failure in failures.iter().take(MAX_CASES) {
            let at =
                if failure.at.is_empty() { String::new() } else { format!("{}: ", failure.at) };
            lines.push(if numbers {
                format!("{at}printed {}, correct {}", failure.left, failure.right)
            } else {
                equation::difference(self, failure)
            });
        }
        let more = failures.len().saturating_sub(MAX_CASES);
        if more > 0 {
            lines.push(format!("and in {more} more"));
        }
        facts.push(("fails".to_owned(), lines.join("\n")));
        let mends =
            mends.iter().map(|mend| format!("one symbol: it holds with one side as {mend}"));
        let rounded = equation::rounded(&self.verdict).into_iter();
        (facts, rounded.chain(mends).chain(origin).collect())
    }

    fn difference(&self) -> [String; 2] {
        let EquationVerdict::Fails { failures, .. } = &self.verdict else {
            return Default::default();
        };
        let Some(first) = failures.first() else { return Default::default() };
        let at = if first.at.is_empty() { String::new() } else { format!(" at {}", first.at) };
        let more = match failures.len() {
            1 => String::new(),
            count => format!("; {count} cases fail"),
        };
        let [left, right] = [&first.left, &first.right].map(ToString::to_string);
        [format!("{}{at}{more}", cut(left, LONGEST)), right]
    }

    fn origin(&self) -> Option<String> {
        let EquationVerdict::Fails { mends, .. } = &self.verdict else { return None };
        let mend = mends.first().map(|mend| format!("it holds with one side as {mend}"));
        equation::rounded(&self.verdict).or(mend).or_else(|| self.equation.note.clone())
    }

    fn contents(&self, _: &Context<'_, '_>) -> Result<Markup, Diagnostic> {
        Ok(html! {
                @if let EquationBody::Identity(body) = &self.equation.body { (identity(body)) }
                p.outcome { (lines(&equation::outcome(self))) }
        })
    }
}
