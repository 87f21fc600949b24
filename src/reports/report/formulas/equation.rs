//! The report of equations.

use super::function::beyond;
use crate::audit::{EquationFinding, EquationVerdict};
use crate::claim::{EquationBody, Identity, Index, Left};
use crate::exact::{Rational, Rounding};

/// How many cases a failing equation shows.
const MAX_FAILURES: usize = 2;

/// The finding about an equation, in one line or several.
#[must_use]
pub(crate) fn outcome(finding: &EquationFinding<'_>) -> String {
    match &finding.verdict {
        EquationVerdict::Holds { cases: 1 } => format!("holds{}", compared(finding)),
        EquationVerdict::Holds { cases } => {
            format!("holds in all {cases} cases{}", compared(finding))
        }
        EquationVerdict::NotCheckable => {
            format!("not checkable without {}", finding.equation.absent().unwrap_or_default())
        }
        EquationVerdict::BeyondCap(cap) => beyond(cap),
        EquationVerdict::Fails { cases, failures, mends } => {
            let mut lines = vec![match cases {
                1 => "fails".to_owned(),
                _ => format!("fails in {} of {cases} cases", failures.len()),
            }];
            for failure in failures.iter().take(MAX_FAILURES) {
                let at =
                    if failure.at.is_empty() { String::new() } else { format!("{}: ", failure.at) };
                lines.push(format!("{at}left − right = {}", failure.difference()));
            }
            lines.extend(rounded(&finding.verdict));
            lines.extend(mends.iter().map(|mend| format!("It holds with one side as {mend}")));
            lines.extend(finding.equation.note.clone());
            lines.join("\n")
        }
    }
}

/// How the decimals of an equation came about that fails since they are rounded.
pub(crate) fn rounded(verdict: &EquationVerdict) -> Option<String> {
    let EquationVerdict::Fails { failures, .. } = verdict else { return None };
    let nearest = failures.iter().all(|failure| failure.rounding == Some(Rounding::Nearest));
    let how = if nearest { "to the nearest" } else { "or cut" };
    let words = if failures.len() == 1 {
        "The printed decimal is the exact value"
    } else {
        "The printed decimals are the exact values"
    };
    verdict.is_rounded().then(|| format!("{words}, rounded {how}"))
}

/// `, N = 3…10, i = 2…N-1`: the index values at which an equation was compared. Others were not
/// compared.
fn compared(finding: &EquationFinding<'_>) -> String {
    let EquationBody::Identity(identity) = &finding.equation.body else { return String::new() };
    let index = |index: &Index| match index {
        Index::Range { label, from, to, .. } => format!(", {label} = {}…{}", from.text, to.text),
        Index::Listed { label, values, .. } => format!(", {label} = {}", listed(values)),
    };
    identity.indices.iter().map(index).collect()
}

/// `3…10`, or `1, 3, 7`.
fn listed(values: &[(Rational, String)]) -> String {
    let one = Rational::one();
    let consecutive = values.windows(2).all(|pair| &pair[0].0 + &one == pair[1].0);
    match values {
        [(_, first), _, .., (_, last)] if consecutive => format!("{first}…{last}"),
        _ => values.iter().map(|(_, printed)| printed.as_str()).collect::<Vec<&str>>().join(", "),
    }
}

/// An identity as it stands in the claim file.
pub(crate) fn sides(identity: &Identity) -> Vec<(String, String)> {
    let mut facts = Vec::new();
    if let Some(scheme) = &identity.scheme {
        facts.push(("scheme".to_owned(), scheme.reference.to_string()));
    }
    if !identity.symbols.is_empty() {
        facts.push(("symbols".to_owned(), identity.symbols.join(", ")));
    }
    let left = match &identity.left {
        Left::One(formula) => formula.text.clone(),
        Left::Each(formulas) => {
            formulas.iter().map(|formula| formula.text.as_str()).collect::<Vec<&str>>().join(", ")
        }
    };
    facts.push(("left".to_owned(), left));
    facts.push(("right".to_owned(), identity.right.text.clone()));
    facts
}
