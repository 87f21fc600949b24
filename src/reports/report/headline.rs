//! The findings of an audit, in a few sentences for each paper.

use crate::audit::{CellFinding, PaperAudit, Verdict};
use std::collections::BTreeMap;

/// Up to three sentences: about the cells of a paper, about their promises, and about the other
/// claims.
pub(super) fn headline(audit: &PaperAudit<'_>) -> String {
    let sentences = [cells(audit), promises(audit), claims(audit)];
    let sentences: Vec<String> = sentences.into_iter().flatten().collect();
    let said =
        if sentences.is_empty() { "nothing to check.".to_owned() } else { sentences.join(" ") };
    format!("{}: {said}", audit.paper.key)
}

/// `229 of 240 cells are reproduced with w = 39/2000, which the paper does not state; 5 are
/// confirmed. 12 are lost.`
fn cells(audit: &PaperAudit<'_>) -> Option<String> {
    let all = || audit.tables.iter().flat_map(|table| table.cells.iter().flatten());
    let printed: Vec<&CellFinding> = all().filter(|cell| cell.printed.is_some()).collect();
    let lost = all().count() - printed.len();
    let lost = (lost > 0).then(|| format!("{} lost.", are(lost)));
    if printed.is_empty() {
        return lost.map(|lost| format!("of the cells, {lost}"));
    }
    let count = |name: &str| printed.iter().filter(|cell| cell.verdict.name() == name).count();
    let read =
        printed.iter().filter(|cell| cell.verdict == Verdict::Reproduced && cell.as_read.is_some());
    let with = match read.count() {
        0 => recovered(audit),
        count => format!("{}, {count} of them by another reading", recovered(audit)),
    };
    let left = if_assumed(&printed);
    let mut parts = Vec::new();
    for (name, said) in [
        ("confirmed", "confirmed"),
        ("reproduced", "reproduced"),
        ("rounding", "rounded otherwise"),
        ("other-reading", "given by another reading"),
        ("misprint", "a slip away"),
        ("refuted", "refuted"),
        ("not-checkable", "not checkable"),
    ] {
        let with = match name {
            "reproduced" => with.as_str(),
            "not-checkable" => left.as_str(),
            _ => "",
        };
        parts.extend(Some(count(name)).filter(|count| *count > 0).map(|count| (count, said, with)));
    }
    // The largest part comes first.
    parts.sort_by_key(|(count, ..)| std::cmp::Reverse(*count));
    let mut words = parts.into_iter().map(|(count, said, with)| (count, format!("{said}{with}")));
    let (first, said) = words.next()?;
    let is = if printed.len() == 1 { "cell is" } else { "cells are" };
    let first = format!("{first} of {} {is} {said}", printed.len());
    let rest = words.map(|(count, said)| format!("{} {said}", are(count)));
    let sentence = std::iter::once(first).chain(rest).collect::<Vec<String>>().join("; ");
    Some([Some(format!("{sentence}.")), lost].into_iter().flatten().collect::<Vec<_>>().join(" "))
}

/// ` (at the values shown, 7 differ and 1 is a slip away)`: the verdicts that cells which are not
/// checkable have at the values that were put in.
fn if_assumed(printed: &[&CellFinding]) -> String {
    let judged = || printed.iter().filter_map(|cell| cell.verdict_if_assumed.as_ref());
    let differ = judged().filter(|verdict| **verdict == Verdict::Refuted).count();
    let slips = judged().filter(|verdict| matches!(verdict, Verdict::Misprint(_))).count();
    let differ = (differ > 0)
        .then(|| format!("{differ} {}", if differ == 1 { "differs" } else { "differ" }));
    let slips = (slips > 0).then(|| format!("{} a slip away", are(slips)));
    let parts: Vec<String> = differ.into_iter().chain(slips).collect();
    if parts.is_empty() {
        return String::new();
    }
    format!(" (at the values shown, {})", parts.join(" and "))
}

/// `5 are`, or `1 is`.
fn are(count: usize) -> String {
    format!("{count} {}", if count == 1 { "is" } else { "are" })
}

/// ` with w = 39/2000 or 3/400, which the paper does not state`: the values at which cells are
/// reproduced, those of most cells first.
fn recovered(audit: &PaperAudit<'_>) -> String {
    let mut values: BTreeMap<&str, BTreeMap<String, usize>> = BTreeMap::new();
    for table in &audit.tables {
        let cells = table.cells.iter().flatten();
        let count = cells.filter(|cell| cell.verdict == Verdict::Reproduced).count();
        for (name, recovered) in table.recovered.iter().filter(|_| count > 0) {
            let value = recovered.value.to_string();
            *values.entry(name).or_default().entry(value).or_default() += count;
        }
    }
    if values.is_empty() {
        return String::new();
    }
    let named = values.into_iter().map(|(name, values)| {
        let mut values: Vec<(String, usize)> = values.into_iter().collect();
        values.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
        let values: Vec<String> = values.into_iter().map(|(value, _)| value).collect();
        format!("{name} = {}", values.join(" or "))
    });
    let named: Vec<String> = named.collect();
    format!(" with {}, which the paper does not state", named.join(", "))
}

/// `Of 220 promises, 157 are broken, 1 is open.`
fn promises(audit: &PaperAudit<'_>) -> Option<String> {
    let counts = audit.promise_counts();
    let open = if counts.open > 0 { format!(", {} open", are(counts.open)) } else { String::new() };
    let broken = match counts.broken {
        0 => "none is".to_owned(),
        count => are(count),
    };
    (counts.all() > 0).then(|| format!("Of {} promises, {broken} broken{open}.", counts.all()))
}

/// A kind of claim: its counts, its name in the plural and in the singular, the verdict of a wrong
/// claim, and the words for this verdict in the singular and in the plural.
type Kind =
    (BTreeMap<&'static str, usize>, &'static str, &'static str, &'static str, [&'static str; 2]);

/// `15 of 43 equations fail, 8 of 10 theorems are refuted.`
fn claims(audit: &PaperAudit<'_>) -> Option<String> {
    let kinds: [Kind; 4] = [
        (audit.equation_counts(), "equations", "equation", "fails", ["fails", "fail"]),
        (audit.range_counts(), "ranges", "range", "inexact", ["is wrong", "are wrong"]),
        (
            audit.smoothness_counts(),
            "statements about smoothness",
            "statement about smoothness",
            "refuted",
            ["is refuted", "are refuted"],
        ),
        (audit.theorem_counts(), "theorems", "theorem", "refuted", ["is refuted", "are refuted"]),
    ];
    let (mut wrong, mut right) = (Vec::new(), Vec::new());
    for (counts, several, one, verdict, is) in kinds {
        let all: usize = counts.values().sum();
        match counts.get(verdict).copied().unwrap_or(0) {
            _ if all == 0 => {}
            0 => right.push(one),
            count => {
                let is = is[usize::from(count != 1)];
                wrong.push(format!("{count} of {all} {several} {is}"));
            }
        }
    }
    match (wrong.is_empty(), right.is_empty()) {
        (false, _) => Some(format!("{}.", wrong.join(", "))),
        (true, false) => Some(format!("No {} was found to be wrong.", right.join(", no "))),
        (true, true) => None,
    }
}
