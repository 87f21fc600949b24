//! Findings about a free parameter.

use crate::audit::{
    EndFinding, EndRelation, FoundRange, FunctionFinding, FunctionVerdict, PaperAudit,
    RangeFinding, RangeVerdict, Word,
};
use crate::claim::LocatedReference;
use crate::exact::format::short;
use crate::report::words::parts::{definitions, titled};
use crate::report::words::sheet::Sheet;

/// The sections on closed forms and on ranges; without `all`, on those where
/// something is wrong.
pub(crate) fn sections(sheet: &mut Sheet, audit: &PaperAudit<'_>, all: bool) {
    let wrong = |finding: &&FunctionFinding<'_>| all || finding.verdict != FunctionVerdict::Holds;
    let facts = audit.functions.iter().filter(wrong).map(|finding| {
        let claim = finding.claim;
        let title = titled(&[&claim.title, &claim.id]);
        let lines = lines(title, function_outcome(finding), claim.note.as_deref());
        (format!("{} {}", finding.verdict.word().mark(), claim.locus), lines)
    });
    section(sheet, "Functions of a parameter", facts.collect());
    let wrong = |finding: &&RangeFinding<'_>| all || finding.verdict() != Word::Exact;
    let facts = audit.ranges.iter().filter(wrong).map(|finding| {
        let claim = finding.claim;
        let title = titled(&[&claim.title, &claim.id]);
        let lines = lines(title, range_outcome(finding), claim.note.as_deref());
        (format!("{} {}", finding.verdict().mark(), claim.locus), lines)
    });
    section(sheet, "Parameter ranges", facts.collect());
}

fn section(sheet: &mut Sheet, heading: &str, facts: Vec<(String, String)>) {
    if !facts.is_empty() {
        sheet.heading(2, heading);
        sheet.facts(facts);
    }
}

fn lines(title: String, outcome: Vec<String>, note: Option<&str>) -> String {
    std::iter::once(title)
        .chain(outcome)
        .chain(note.map(str::to_owned))
        .collect::<Vec<String>>()
        .join("\n")
}

/// What there is to say of a closed form in full.
pub(crate) fn function_facts(
    audit: &PaperAudit<'_>,
    finding: &FunctionFinding<'_>,
) -> Vec<(String, String)> {
    let claim = finding.claim;
    let mut facts = head(&claim.variable, claim.scheme.as_ref());
    facts.push(("left".to_owned(), claim.left.text.clone()));
    facts.push(("right".to_owned(), claim.right.text.clone()));
    facts.extend(definitions(audit, &claim.left));
    facts.push((
        verdict(finding.verdict.word()),
        function_outcome(finding).join(
            "
",
        ),
    ));
    facts.extend(claim.note.clone().map(|note| ("note".to_owned(), note)));
    facts
}

/// What there is to say of a range in full.
pub(crate) fn range_facts(finding: &RangeFinding<'_>) -> Vec<(String, String)> {
    let claim = finding.claim;
    let mut facts = head(&claim.variable, claim.scheme.as_ref());
    let condition =
        format!("{} {} {}", claim.value.text, claim.limit.relation(), claim.limit.formula().text);
    facts.push(("condition".to_owned(), condition));
    facts.push((
        verdict(finding.verdict()),
        range_outcome(finding).join(
            "
",
        ),
    ));
    facts.extend(claim.note.clone().map(|note| ("note".to_owned(), note)));
    facts
}

fn head(variable: &str, scheme: Option<&LocatedReference>) -> Vec<(String, String)> {
    let scheme = scheme.map(|scheme| ("scheme".to_owned(), scheme.reference.to_string()));
    [("variable".to_owned(), variable.to_owned())].into_iter().chain(scheme).collect()
}

fn verdict(word: Word) -> String {
    format!("{} {word}", word.mark())
}

pub(crate) fn function_outcome(finding: &FunctionFinding<'_>) -> Vec<String> {
    let variable = &finding.claim.variable;
    let (larger, smaller, example) = match &finding.verdict {
        FunctionVerdict::Fails { larger, smaller, example } => (larger, smaller, example),
        FunctionVerdict::Holds => return vec![format!("holds for every {variable}")],
        FunctionVerdict::BeyondCap(cap) => return vec![beyond(cap)],
    };
    let mut lines = Vec::new();
    for (what, set) in [("larger", larger), ("smaller", smaller)] {
        if !set.is_empty() {
            lines.push(format!("The printed form is {what} for {}.", set.describe(variable)));
        }
    }
    let (at, left, right) = (&example.at, &example.left, &example.right);
    lines.push(format!("At {variable} = {at} it is {left}, and should be {right}."));
    lines
}

pub(crate) fn range_outcome(finding: &RangeFinding<'_>) -> Vec<String> {
    let found = match &finding.found {
        Ok(found) => found,
        Err(cap) => return vec![beyond(cap)],
    };
    let exact = found.exact.describe(&finding.claim.variable);
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
        (Some(exact), EndRelation::Equal) => format!("exactly {exact}"),
        (Some(exact), relation) if exact.to_string() == short(exact, 6) => {
            format!("{relation}, {exact}")
        }
        (Some(exact), relation) => format!("{relation}, {exact} = {}", short(exact, 6)),
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
