//! Findings about a free parameter.

use crate::audit::{
    EndFinding, EndRelation, FoundRange, FunctionFinding, FunctionVerdict, RangeFinding,
    RangeVerdict,
};
use crate::claim::{Domain, Ends, LocatedReference};
use crate::exact::format::short;
use crate::report::words::set::{interval_texts, number};

pub(crate) fn head(variable: &str, scheme: Option<&LocatedReference>) -> Vec<(String, String)> {
    let scheme = scheme.map(|scheme| ("scheme".to_owned(), scheme.reference.to_string()));
    [("variable".to_owned(), variable.to_owned())].into_iter().chain(scheme).collect()
}

pub(crate) fn function_outcome(finding: &FunctionFinding<'_>) -> Vec<String> {
    let variable = &finding.claim.variable;
    let (larger, smaller, example) = match &finding.verdict {
        FunctionVerdict::Fails { larger, smaller, example } => (larger, smaller, example),
        FunctionVerdict::Holds => return vec![holds(finding)],
        FunctionVerdict::BeyondCap(cap) => return vec![beyond(cap)],
    };
    let mut lines = Vec::new();
    for (what, set) in [("larger", larger), ("smaller", smaller)] {
        if !set.is_empty() {
            lines.push(format!(
                "The printed form is {what} for {}.",
                interval_texts(set, variable).join(" or ")
            ));
        }
    }
    let (at, left, right) = (&example.at, &example.left, &example.right);
    lines.push(format!("At {variable} = {at} it is {left}, and should be {right}."));
    lines
}

/// The exact set in words.
pub(crate) fn exactly(found: &FoundRange, variable: &str) -> String {
    match &interval_texts(&found.exact, variable)[..] {
        [] => format!("no {variable}"),
        texts => texts.join(" or "),
    }
}

/// For which values it holds.
fn holds(finding: &FunctionFinding<'_>) -> String {
    let claim = finding.claim;
    match finding.compared() {
        Ends::Least => format!(
            "holds for {}, and beyond these not; the ends may be rounded",
            interval_texts(&claim.domain.interval(Ends::Least), &claim.variable).join(" or ")
        ),
        _ => format!("holds for {}", domain(&claim.variable, &claim.domain)),
    }
}

/// An interval as printed: `0 < w < 1/2`, or `every w`.
pub(crate) fn domain(variable: &str, domain: &Domain) -> String {
    let Domain { from, to, closed } = domain;
    let equal = if *closed { "=" } else { "" };
    match (from, to) {
        (None, None) => format!("every {variable}"),
        (Some(from), None) => format!("{} <{equal} {variable}", from.text),
        (None, Some(to)) => format!("{variable} <{equal} {}", to.text),
        (Some(from), Some(to)) => format!("{} <{equal} {variable} <{equal} {}", from.text, to.text),
    }
}

pub(crate) fn range_outcome(finding: &RangeFinding<'_>) -> Vec<String> {
    let found = match &finding.found {
        Ok(found) => found,
        Err(cap) => return vec![beyond(cap)],
    };
    let exact = exactly(found, &finding.claim.variable);
    if found.verdict == RangeVerdict::Exact {
        return vec![format!("exactly {exact}")];
    }
    let mut lines = vec![format!("printed {}; exactly {exact}", printed(finding))];
    lines.extend(found.ends.iter().map(|end| end_text(found, end)));
    lines.push(
        if found.kept {
            "The condition holds in the whole printed range."
        } else {
            "The condition fails in a part of the printed range."
        }
        .to_owned(),
    );
    lines
}

/// That a value is beyond a cap, so that nothing is said of the claim.
pub(crate) fn beyond(cap: &dyn std::fmt::Display) -> String {
    format!("not checkable: {cap}")
}

fn end_text(found: &FoundRange, end: &EndFinding) -> String {
    let against = match (&end.exact, end.relation) {
        (None, _) => "the exact set has no such end".to_owned(),
        (Some(exact), EndRelation::Equal) => format!("exactly {}", number(exact)),
        (Some(exact), relation) => match (number(exact), short(exact, 6)) {
            (exact, decimal) if exact == decimal || exact.ends_with('…') => {
                format!("{relation}, {exact}")
            }
            (exact, decimal) => format!("{relation}, {exact} = {decimal}"),
        },
    };
    let place = if end.inside { "inside the exact set" } else { "outside the exact set" };
    let (value, limit) = (short(&end.value, 6), &found.limit);
    format!("{}: {against}; {place}, with {value} against {limit}", end.printed)
}

/// The range as printed: `0 <= w <= 1/2`, or `w from 0 to 1/2` where the paper does not say whether its ends belong to it.
pub(crate) fn printed(finding: &RangeFinding<'_>) -> String {
    let claim = finding.claim;
    let Some(closed) = claim.closed else {
        let from = claim.from.as_ref().map(|from| format!(" from {}", from.text));
        let to = match (&from, &claim.to) {
            (_, None) => " on".to_owned(),
            (Some(_), Some(to)) => format!(" to {}", to.text),
            (None, Some(to)) => format!(" up to {}", to.text),
        };
        return format!("{}{}{to}", claim.variable, from.unwrap_or_default());
    };
    let relation = if closed { "<=" } else { "<" };
    let from = claim.from.as_ref().map(|from| format!("{} {relation} ", from.text));
    let to = claim.to.as_ref().map(|to| format!(" {relation} {}", to.text));
    format!("{}{}{}", from.unwrap_or_default(), claim.variable, to.unwrap_or_default())
}
