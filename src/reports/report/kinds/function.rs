//! Closed forms in a free parameter in reports.

use super::equation::EQUATIONS;
use crate::audit::{FunctionFinding, FunctionVerdict, PaperAudit};
use crate::claim::{Domain, FunctionClaim};
use crate::diagnostic::Diagnostic;
use crate::report::formulas::function;
use crate::report::html::context::Context;
use crate::report::html::math::formula;
use crate::report::html::sheet::lines;
use crate::report::html::statement;
use crate::report::json::{Claim, Details, Failure, joined};
use crate::report::told::{Counted, Facts, Told};
use crate::report::words::parts::definitions;
use maud::{Markup, html};

/// For which values it is stated, if not for all.
fn stated(claim: &FunctionClaim) -> Option<(String, String)> {
    let Domain { from, to, .. } = &claim.domain;
    let ends = from.is_some() || to.is_some();
    ends.then(|| ("for".to_owned(), function::domain(&claim.variable, &claim.domain)))
}

impl<'a> Told<'a> for FunctionFinding<'a> {
    fn heading(&self) -> [&'static str; 2] {
        ["Functions of a parameter", "functions"]
    }

    fn counted(&self) -> Option<&'static Counted> {
        Some(&EQUATIONS)
    }

    fn outcome(&self) -> String {
        function::function_outcome(self).join("\n")
    }

    fn states(&self, audit: &PaperAudit<'_>) -> Facts {
        let claim = self.claim;
        let mut facts = function::head(&claim.variable, claim.scheme.as_ref());
        facts.push(("left".to_owned(), claim.left.text.clone()));
        facts.push(("right".to_owned(), claim.right.text.clone()));
        facts.extend(stated(claim));
        facts.extend(definitions(audit, &claim.left));
        facts
    }

    fn form<'s>(&'s self, audit: &'s PaperAudit<'_>) -> Vec<Claim<'s>> {
        let claim = self.claim;
        let left = &claim.left.text;
        // If the printed form is the name of a definition, the definition's formula is what is
        // printed.
        let definition = audit.paper.definitions.get(left);
        let printed = definition.map_or(left, |definition| &definition.text).as_str();
        let mut cap = None;
        let (failures, printed_larger, printed_smaller) = match &self.verdict {
            FunctionVerdict::Fails { larger, smaller, example } => {
                let failure = Failure {
                    at: format!("{} = {}", claim.variable, example.at).into(),
                    left: example.left.to_string(),
                    right: example.right.to_string(),
                    difference: (&example.left - &example.right).to_string(),
                    rounding: None,
                };
                (Some([failure]), Some(larger.to_string()), Some(smaller.to_string()))
            }
            FunctionVerdict::Holds => (None, None, None),
            FunctionVerdict::BeyondCap(beyond) => {
                cap = Some(beyond.to_string());
                (None, None, None)
            }
        };
        let variable = &claim.variable;
        let domain = stated(claim).map(|(_, values)| values);
        let details =
            Details::Function { variable, domain, failures, printed_larger, printed_smaller };
        let verdict = self.verdict.word().name();
        let plain = Claim::plain(&self.id, &claim.locus, "function", printed, verdict, details);
        vec![Claim { note: joined(cap, claim.note.as_deref()), ..plain }]
    }

    fn erratum(&self) -> (Facts, Vec<String>) {
        let claim = self.claim;
        let fact = |name: &str, text: String| (name.to_owned(), text);
        let sides = [("left", &claim.left), ("right", &claim.right)];
        let mut facts = Vec::from(sides.map(|(name, side)| fact(name, side.text.clone())));
        facts.extend(stated(claim));
        facts.push(fact("fails", self.outcome()));
        (facts, Vec::from_iter(claim.note.clone()))
    }

    fn difference(&self) -> [String; 2] {
        let outcome = function::function_outcome(self);
        [self.claim.left.text.clone(), outcome.last().cloned().unwrap_or_default()]
    }

    fn contents(&self, context: &Context<'_, '_>) -> Result<Markup, Diagnostic> {
        let own = self.claim;
        Ok(html! {
                dl.formulas {
                    div { dt { "printed" } dd { (formula(&own.left.expr)) " = " (formula(&own.right.expr)) } }
                    @if let Some((name, values)) = stated(own) { div { dt { (name) } dd { (values) } } }
                    (statement::definitions(context.audit, &own.left))
                }
                p.outcome { (lines(&self.outcome())) }
        })
    }
}
