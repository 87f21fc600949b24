//! Wrong equations, closed forms, ranges and theorems.

use crate::audit::{
    EquationFinding, EquationVerdict, FoundRange, FunctionFinding, RangeFinding, SmoothnessFinding,
    TheoremFinding,
};
use crate::claim::{EquationBody, Left};
use crate::report::formulas::equation;
use crate::report::formulas::function;
use crate::report::smooth::smoothness;
use crate::report::theorems::theorem as theorems;
use crate::report::theorems::witness::compared;

/// How many cases of a failing equation are listed.
const MAX_CASES: usize = 6;

/// The statement of a claim, the facts about what is wrong, and how it came about.
type Described = (Option<String>, Vec<(String, String)>, String);

fn fact(name: &str, value: impl Into<String>) -> (String, String) {
    (name.to_owned(), value.into())
}

pub(super) fn equation(finding: &EquationFinding<'_>) -> Described {
    let title = Some(finding.equation.title.clone());
    let origin = finding.equation.note.iter().cloned();
    let (EquationVerdict::Fails { cases, failures, mends }, EquationBody::Identity(identity)) =
        (&finding.verdict, &finding.equation.body)
    else {
        return (title, Vec::new(), stated(&origin.collect::<Vec<String>>()));
    };
    let mut facts = equation::sides(identity);
    let numbers = matches!(identity.left, Left::Each(_));
    let mut lines = vec![format!("in {} of {cases} cases", failures.len())];
    for failure in failures.iter().take(MAX_CASES) {
        let at = if failure.at.is_empty() { String::new() } else { format!("{}: ", failure.at) };
        lines.push(if numbers {
            format!("{at}printed {}, correct {}", failure.left, failure.right)
        } else {
            format!("{at}left − right = {}", failure.difference())
        });
    }
    let more = failures.len().saturating_sub(MAX_CASES);
    if more > 0 {
        lines.push(format!("and in {more} more"));
    }
    facts.push(fact("fails", lines.join("\n")));
    let mends = mends.iter().map(|mend| format!("one symbol: it holds with one side as {mend}"));
    (title, facts, stated(&mends.chain(origin).collect::<Vec<String>>()))
}

pub(super) fn function(finding: &FunctionFinding<'_>) -> Described {
    let claim = finding.claim;
    let facts = vec![
        fact("left", claim.left.text.clone()),
        fact("right", claim.right.text.clone()),
        fact("fails", function::function_outcome(finding).join("\n")),
    ];
    (Some(claim.title.clone()), facts, stated(claim.note.as_slice()))
}

pub(super) fn range(finding: &RangeFinding<'_>, found: &FoundRange) -> Described {
    let claim = finding.claim;
    let facts = vec![
        fact("printed", function::printed(finding)),
        fact("correct", found.exact.describe(&claim.variable)),
        fact("in detail", function::range_outcome(finding).join("\n")),
    ];
    (Some(claim.title.clone()), facts, stated(claim.note.as_slice()))
}

pub(super) fn smoothness(finding: &SmoothnessFinding<'_>) -> Described {
    let claim = finding.claim;
    let mut facts = Vec::new();
    facts.extend(smoothness::scheme(claim).map(|scheme| fact("scheme", scheme)));
    facts.extend(smoothness::statement(claim).map(|states| fact("states", states)));
    facts.push(fact("correct", smoothness::outcome(finding).join("\n")));
    (Some(claim.title.clone()), facts, stated(claim.note.as_slice()))
}

pub(super) fn theorem(finding: &TheoremFinding<'_>) -> Described {
    let theorem = finding.theorem;
    let mut facts = vec![
        fact("states", theorems::statement(&theorem.statement)),
        fact("verdict", theorems::outcome(finding)),
    ];
    facts.extend(compared(finding).map(|text| fact("compared", text)));
    (Some(theorem.title.clone()), facts, stated(theorem.note.as_slice()))
}

/// The reasons, line by line.
fn stated(reasons: &[String]) -> String {
    if reasons.is_empty() { "not explained".to_owned() } else { reasons.join("\n") }
}
