//! Wrong equations, closed forms, ranges and theorems.

use crate::audit::{
    EquationFinding, EquationVerdict, FunctionFinding, RangeFinding, TheoremFinding,
};
use crate::claim::{EquationBody, Left};
use crate::report::theorem as theorems;
use crate::report::{explain, function};

/// How many cases of a failing equation are listed.
const MAX_CASES: usize = 6;

fn fact(name: &str, value: impl Into<String>) -> (String, String) {
    (name.to_owned(), value.into())
}

pub(super) fn equation(finding: &EquationFinding<'_>) -> Vec<(String, String)> {
    let mut facts = vec![fact("says", finding.equation.title.clone())];
    let EquationVerdict::Fails { cases, failures, mends } = &finding.verdict else {
        return facts;
    };
    let EquationBody::Identity(identity) = &finding.equation.body else { return facts };
    facts.extend(explain::sides(identity));
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
    let origin: Vec<String> = mends.chain(finding.equation.note.clone()).collect();
    let origin = if origin.is_empty() { "not explained".to_owned() } else { origin.join("\n") };
    facts.push(fact("how it came about", origin));
    facts
}

pub(super) fn function(finding: &FunctionFinding<'_>) -> Vec<(String, String)> {
    let claim = finding.claim;
    let mut facts = vec![
        fact("says", claim.title.clone()),
        fact("left", claim.left.text.clone()),
        fact("right", claim.right.text.clone()),
        fact("fails", function::function_outcome(finding).join("\n")),
    ];
    facts.push(fact("how it came about", note(claim.note.as_ref())));
    facts
}

pub(super) fn range(finding: &RangeFinding<'_>) -> Vec<(String, String)> {
    let claim = finding.claim;
    vec![
        fact("says", claim.title.clone()),
        fact("printed", function::printed(finding)),
        fact("correct", finding.exact.describe(&claim.variable)),
        fact("in detail", function::range_outcome(finding).join("\n")),
        fact("how it came about", note(claim.note.as_ref())),
    ]
}

pub(super) fn theorem(finding: &TheoremFinding<'_>) -> Vec<(String, String)> {
    vec![
        fact("says", finding.theorem.title.clone()),
        fact("states", theorems::statement(&finding.theorem.statement)),
        fact("verdict", theorems::outcome(finding)),
        fact("how it came about", note(finding.theorem.note.as_ref())),
    ]
}

fn note(note: Option<&String>) -> String {
    note.cloned().unwrap_or_else(|| "not explained".to_owned())
}
