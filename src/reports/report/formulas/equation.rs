//! The report of equations and other relations.

use super::function::beyond;
use crate::audit::Failure;
use crate::audit::{EquationFinding, EquationVerdict, OnReals};
use crate::claim::{Comparison, EquationBody, Identity, Index, Sign};
use crate::exact::{Rational, Rounding, parse_decimal};

/// How many cases a failing equation shows.
const MAX_FAILURES: usize = 2;

/// The finding about an equation, in one line or several.
#[must_use]
pub(crate) fn outcome(finding: &EquationFinding<'_>) -> String {
    match &finding.verdict {
        EquationVerdict::Holds { cases } if *cases == 1 || compared(finding).is_empty() => {
            format!("holds{}", compared(finding))
        }
        EquationVerdict::Holds { cases } => {
            format!("holds in all {cases} cases{}", compared(finding))
        }
        EquationVerdict::Proved => format!("holds{}", compared(finding)),
        EquationVerdict::Tried { cases } => {
            format!("true in the {cases} cases that were tried; open{}", compared(finding))
        }
        EquationVerdict::Undecided { cases, open } => {
            let mut lines = vec![match cases {
                1 => "open: bounds of the values do not decide it".to_owned(),
                _ => format!(
                    "open in {} of {cases} cases: bounds of the values do not decide them",
                    open.len()
                ),
            }];
            lines.extend(open.iter().take(MAX_FAILURES).map(|case| difference(finding, case)));
            lines.join("\n")
        }
        EquationVerdict::Reals(found) => on_reals(finding, found),
        EquationVerdict::NotCheckable => {
            format!("not checkable without {}", finding.equation.absent().unwrap_or_default())
        }
        EquationVerdict::BeyondCap(cap) => beyond(cap),
        EquationVerdict::Fails { cases, failures, mends } => {
            let mut lines = vec![match cases {
                1 => "fails".to_owned(),
                _ if compared(finding).is_empty() => "fails".to_owned(),
                _ => format!("fails in {} of {cases} cases", failures.len()),
            }];
            let shown = failures.iter().take(MAX_FAILURES);
            lines.extend(shown.map(|failure| difference(finding, failure)));
            if compared(finding).is_empty() && failures.len() > MAX_FAILURES {
                lines.push(format!("and {} more", failures.len() - MAX_FAILURES));
            }
            lines.extend(rounded(&finding.verdict));
            lines.extend(mends.iter().map(|mend| format!("It holds with one side as {mend}")));
            lines.extend(finding.equation.note.clone());
            lines.join("\n")
        }
    }
}

/// Whether a relation is true for real values of an index, and where it is true if that is not as claimed.
fn on_reals(finding: &EquationFinding<'_>, found: &OnReals) -> String {
    let EquationBody::Identity(identity) = &finding.equation.body else { return String::new() };
    let name = &found.name;
    if found.holds() {
        let only = if identity.only { format!(", and for no other {name}") } else { String::new() };
        return format!("holds{}{only}", compared(finding));
    }
    let failing = found.cases.iter().filter_map(|case| Some((case, case.counterexample.as_ref()?)));
    let shown = failing.take(MAX_FAILURES).flat_map(|(case, number)| {
        let at = if case.at.is_empty() { String::new() } else { format!("{}: ", case.at) };
        let comparison = number.fails.and_then(|place| identity.comparisons.get(place));
        let what = match (comparison, identity.comparisons.len()) {
            (Some(comparison), 2..) => {
                let (left, right) = (&comparison.left.formula(0).text, &comparison.right().text);
                format!("{left} {} {right} is false", comparison.sign.mark())
            }
            (Some(_), _) => "it is false".to_owned(),
            (None, _) => "it is true".to_owned(),
        };
        let set = case.truth.as_ref().map(|truth| {
            let whole = if identity.only || truth.is_empty() { "" } else { "of these, " };
            format!("{at}{whole}it is true for {}", truth.describe(name))
        });
        [Some(format!("{at}{what} for {name} = {}", number.value)), set].into_iter().flatten()
    });
    let lines: Vec<String> = ["fails".to_owned()].into_iter().chain(shown).collect();
    lines.into_iter().chain(finding.equation.note.clone()).collect::<Vec<String>>().join("\n")
}

/// A case in which a claim is false: the difference of the sides of an equation, the values of those of another relation.
pub(crate) fn difference(finding: &EquationFinding<'_>, failure: &Failure) -> String {
    let at = if failure.at.is_empty() { String::new() } else { format!("{}: ", failure.at) };
    if finding.equation.is_relation {
        format!("{at}{}", values(finding, failure))
    } else {
        format!("{at}left − right = {}", failure.difference())
    }
}

/// `the value is 3`, or `left = 3/8, right = 1/4`.
pub(crate) fn values(finding: &EquationFinding<'_>, failure: &Failure) -> String {
    let EquationBody::Identity(identity) = &finding.equation.body else { return String::new() };
    // The right sides that the claim states by a number say themselves.
    let plain = |sign| matches!(sign, Sign::True | Sign::False | Sign::OneOf);
    let stated = |comparison: &Comparison| comparison.right().text == failure.right.to_string();
    match &identity.comparisons[..] {
        [comparison] if plain(comparison.sign) || stated(comparison) => {
            format!("the value is {}", failure.left)
        }
        [comparison] => {
            let right = comparison.right().text.trim();
            let printed = parse_decimal(right).is_ok();
            let right = if printed { right.to_owned() } else { failure.right.to_string() };
            format!("left = {}, right = {right}", failure.left)
        }
        _ => format!("left = {}, right = {}", failure.left, failure.right),
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
        Index::Together { names, rows } => {
            format!(", ({}) in {} rows", names.join(", "), rows.len())
        }
        Index::All { name, from } => format!(" for all {name} ≥ {from}"),
        Index::Real { text, .. } => format!(" for {text}"),
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
    if let Some(states) = &identity.states {
        facts.extend(states.iter().map(|text| ("states".to_owned(), text.clone())));
        return facts;
    }
    let equation = identity.first();
    let lefts: Vec<&str> = equation.left.formulas().iter().map(|left| left.text.as_str()).collect();
    facts.push(("left".to_owned(), lefts.join(", ")));
    facts.push(("right".to_owned(), equation.right().text.clone()));
    facts
}
