//! Findings about theorems.

use super::witness;
use crate::audit::{
    ByHand, Correction, EveryShift, KernelProof, Naturally, Outcome, Refutation, TheoremFinding,
    TheoremVerdict, Unshiftable, Violation, Word,
};
use crate::claim::{Statement, Theorem};
use crate::exact::{RealCyclotomic, format::short};
use crate::report::words::kernel::CHECKED;

/// The most digits of a decimal.
const DIGITS: u32 = 12;

/// The verdict, its reason, the corrections that would save a false theorem, and the premises that
/// fail.
pub(crate) fn outcome(finding: &TheoremFinding<'_>) -> String {
    let name = finding.verdict.word();
    let mut lines = match (&finding.refutation, &finding.proof) {
        (Some(refutation), _) => refuted(finding, refutation),
        (None, Some(proof)) => vec![format!("{name} · {proof}")],
        (None, None) => vec![tried(name, finding)],
    };
    lines.extend(repairs(finding));
    lines.extend(premises(finding));
    let separator = if lines.len() > 1 && finding.refutation.is_some() { "\n" } else { " · " };
    lines.join(separator)
}

/// The parametrisations in which a theorem is refuted, where every shift of the parameter comes
/// first.
fn refuted(finding: &TheoremFinding<'_>, refutation: &Refutation) -> Vec<String> {
    let (name, by_kernel) = (finding.verdict.word(), &finding.by_kernel);
    let (stated, place) = if finding.theorem.tried.natural {
        ("at natural parameters", " at natural parameters")
    } else {
        ("with points at i/n^k", "")
    };
    let Refutation { case, violation, natural, every_shift, .. } = refutation;
    let Violation { level, attained, bound, .. } = violation;
    let checked = |proof| if by_kernel.contains(&proof) { CHECKED } else { "" };
    let mut printed = exceeded(case, *level, &attained.value, bound);
    printed.push_str(checked(KernelProof::Refuted));
    match (every_shift, natural) {
        (Some(EveryShift::Refuted { case, data, .. }), _) => {
            let Unshiftable { level, overshoot, bound, .. } = &**data;
            let survives = exceeded(case, *level, &overshoot.gap().into(), bound);
            vec![
                format!("{name} in every shift of the parameter · {survives}"),
                format!("{stated} · {printed}"),
            ]
        }
        (_, Some(Naturally::Holds)) => vec![
            format!("{name} with points at i/n^k · {printed}"),
            "not refuted at natural parameters".to_owned(),
        ],
        (_, Some(Naturally::Refuted { case, violation, .. })) => {
            let Violation { level, attained, bound, .. } = &**violation;
            let mut natural = exceeded(case, *level, &attained.value, bound);
            natural.push_str(checked(KernelProof::RefutedNaturally));
            vec![
                format!("{name} with points at i/n^k · {printed}"),
                format!("refuted at natural parameters too · {natural}"),
                "not known whether in every shift of the parameter".to_owned(),
            ]
        }
        (_, Some(Naturally::AsInEveryShift | Naturally::Open)) => vec![
            format!("{name} with points at i/n^k · {printed}"),
            "not known whether at natural parameters".to_owned(),
        ],
        (Some(EveryShift::Open), None) => vec![
            format!("{name}{place} · {printed}"),
            "not known whether in every shift of the parameter".to_owned(),
        ],
        (_, None) => vec![format!("{name}{place} · {printed}")],
    }
}

/// `six-point:w=3/256, c = 2 · k = 1: 2.34 > 1.41`.
fn exceeded(case: &str, level: u32, value: &RealCyclotomic, bound: &RealCyclotomic) -> String {
    let (value, bound) = apart(value, bound);
    format!("{case} · k = {level}: {value} > {bound}")
}

/// Two different numbers with as many digits as it takes to tell them apart.
fn apart(left: &RealCyclotomic, right: &RealCyclotomic) -> (String, String) {
    let digits = |digits| (short(left, digits), short(right, digits));
    (4..DIGITS).map(digits).find(|(left, right)| left != right).unwrap_or_else(|| digits(DIGITS))
}

/// An open theorem, and the cases that it was tried on.
fn tried(name: Word, finding: &TheoremFinding<'_>) -> String {
    let count = |what: fn(&Outcome) -> bool| {
        finding.cases.iter().filter(|case| what(&case.outcome)).count()
    };
    let proved = count(|outcome| matches!(outcome, Outcome::Proved));
    let holds = count(|outcome| matches!(outcome, Outcome::UpTo(_)));
    let within = count(|outcome| !matches!(outcome, Outcome::Outside(_)));
    if proved > 0 && proved == within {
        let cases = if within == 1 { "case" } else { "cases" };
        return format!("proved in the {within} {cases} stated · {name} for others");
    }
    let mut parts = vec![name.to_string()];
    if proved > 0 {
        parts.push(format!("true in {proved} of {within} cases tried"));
    }
    if holds > 0 {
        let cases = if holds == 1 { "case" } else { "cases" };
        parts.push(format!("no counterexample in {holds} {cases}"));
    }
    parts.join(" · ")
}

/// The corrections that would save a false theorem.
fn repairs(finding: &TheoremFinding<'_>) -> Option<String> {
    finding.refutation.as_ref()?;
    let sets: Vec<String> = finding
        .repairs
        .iter()
        .map(|repair| {
            let says: Vec<String> =
                repair.corrections.iter().map(|i| finding.corrections[*i].to_string()).collect();
            let how = if repair.proved { " (then true in all cases tried)" } else { "" };
            format!("{}{how}", says.join(", and "))
        })
        .collect();
    if sets.is_empty() {
        return (!finding.corrections.is_empty())
            .then(|| "false under every reading tried".to_owned());
    }
    Some(format!("not refuted with {}", sets.join("; or with ")))
}

/// The claims that it rests on and that fail.
fn premises(finding: &TheoremFinding<'_>) -> Option<String> {
    let mut loci: Vec<&str> = Vec::new();
    for premise in &finding.failing {
        // Several claims may stand in one place.
        if !loci.contains(&premise.locus) {
            loci.push(premise.locus);
        }
    }
    // A theorem may be proved here though the paper's own proof fails.
    let proved = finding.verdict == TheoremVerdict::Proved;
    let rests = if proved { "the paper's own proof rests on" } else { "rests on" };
    match loci.len() {
        0 => None,
        1 => Some(format!("{rests} {}, which fails", loci[0])),
        _ => Some(format!("{rests} {}, which fail", loci.join("; "))),
    }
}

/// The statement, in the formula language.
pub(crate) fn statement(theorem: &Theorem) -> String {
    let place =
        if theorem.tried.natural { ", with all points at their natural parameters" } else { "" };
    format!("{}{place}", bound(&theorem.statement))
}

fn bound(statement: &Statement) -> String {
    match statement {
        Statement::Bound { quantity, by, from } => {
            format!("{} ≤ {} for k ≥ {from}", quantity.notation(), by.text)
        }
        Statement::Depth(by) => format!("‖P^∞ − P^k‖ ≤ epsilon for k ≥ {}", by.text),
        Statement::Other(says) => says.clone(),
    }
}

/// The data that refute it, what was corrected, and what it was tried on.
pub(crate) fn details(
    finding: &TheoremFinding<'_>,
    hand: Option<&ByHand>,
) -> Vec<(String, String)> {
    let mut facts = witness::facts(finding, hand);
    facts.extend(corrections(finding));
    facts.extend(finding.cases.iter().map(|case| (case.label.clone(), in_case(&case.outcome))));
    facts
}

/// Each correction, and whether it is enough by itself.
fn corrections(finding: &TheoremFinding<'_>) -> Vec<(String, String)> {
    let alone = |i: usize| finding.repairs.iter().any(|repair| repair.corrections == [i]);
    let says = |(i, correction): (usize, &Correction)| {
        let still = if alone(i) { "no longer refuted" } else { "still false" };
        ("corrected".to_owned(), format!("{correction}: {still}"))
    };
    finding.corrections.iter().enumerate().map(says).collect()
}

fn in_case(outcome: &Outcome) -> String {
    match outcome {
        Outcome::Refuted(violation) => {
            let (value, bound) = apart(&violation.attained.value, &violation.bound);
            format!("✗ k = {}: {value} > {bound}", violation.level)
        }
        Outcome::Proved => "✓ true at every level".to_owned(),
        Outcome::UpTo(level) => format!("? no counterexample up to level {level}"),
        Outcome::Unknown(why) => format!("? {why}"),
        Outcome::Outside(why) => format!("not in question: {why}"),
    }
}
