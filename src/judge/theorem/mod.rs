//! Judging theorems: proved, refuted by exact data, or open.

mod case;
mod correction;
mod curve;
mod evaluate;
mod growth;
mod levels;
mod local_rules;
mod setting;
mod surface;
mod trial;

use crate::claim::{Paper, Quantity, Statement, Theorem};
use crate::diagnostic::Diagnostic;
use crate::evaluation::library::{Library, Resolved};
use crate::finding::{
    CaseFinding, Control, Correction, Naturally, Outcome, Refutation, Repair, TheoremFinding,
    TheoremVerdict, Violation,
};
use crate::judge::distance::has_words;
use crate::judge::theorem::case::{Case, Stage};
use crate::judge::theorem::correction::{corrections, subsets};
use crate::judge::theorem::setting::Setting;
use crate::judge::theorem::trial::Trial;
use crate::limit::Parametrisation;
use crate::scheme::Mask;

/// How exactly the supremum beside a false bound is enclosed, in parts of it.
const PARTS: u32 = 1_000;

/// Tries the theorems of a paper, each by itself.
pub(crate) fn trials(paper: &Paper) -> Result<Vec<TheoremFinding<'_>>, Diagnostic> {
    let one = |theorem| one(paper, theorem, &Library::new(paper), &Stage::default());
    paper.theorems.iter().map(one).collect()
}

/// The masks of the case that refutes a theorem; `None` for a ring.
pub(crate) fn refuted_scheme(
    paper: &Paper,
    theorem: &Theorem,
    refutation: &Refutation,
) -> Result<Option<Resolved>, Diagnostic> {
    let (library, stage) = (Library::new(paper), Stage::default());
    let cases = Case::all(paper, theorem, &library, &stage)?;
    Ok(cases.into_iter().find(|case| case.label == refutation.case).and_then(|case| case.resolved))
}

fn one<'a>(
    paper: &'a Paper,
    theorem: &'a Theorem,
    library: &Library<'_>,
    stage: &Stage,
) -> Result<TheoremFinding<'a>, Diagnostic> {
    let mut finding = TheoremFinding {
        id: format!("{}:{}", paper.key, theorem.id),
        theorem,
        verdict: TheoremVerdict::Open,
        proof: None,
        levels: None,
        refutation: None,
        cases: Vec::new(),
        corrections: Vec::new(),
        repairs: Vec::new(),
        failing: Vec::new(),
    };
    if let Some(hand) = &theorem.by_hand {
        finding.verdict =
            if hand.refutes { TheoremVerdict::Refuted } else { TheoremVerdict::Proved };
        finding.proof = Some(hand.text.clone());
    }
    if matches!(theorem.statement, Statement::Other(_)) {
        return Ok(finding);
    }
    let cases = Case::all(paper, theorem, library, stage)?;
    let parametrisation = Parametrisation::Indexed;
    let as_printed = Trial { paper, theorem, corrections: &[], parametrisation };
    for case in &cases {
        let outcome = as_printed.of(case)?;
        finding.cases.push(CaseFinding { label: case.label.clone(), outcome });
    }
    let violations = finding.cases.iter().zip(&cases).filter_map(|(finding, case)| {
        let Outcome::Refuted(violation) = &finding.outcome else { return None };
        Some((violation, case))
    });
    if let Some((violation, case)) = violations.min_by_key(|(violation, _)| size(violation)) {
        let setting = case.setting.as_deref();
        let Violation { quantity, level, .. } = **violation;
        finding.refutation = Some(Refutation {
            case: case.label.clone(),
            scheme: case.scheme.clone(),
            values: case.chosen.clone(),
            limit: match quantity {
                Quantity::Distance => setting.and_then(Setting::limit).unwrap_or_default().to_vec(),
                _ => Vec::new(),
            },
            violation: (**violation).clone(),
            supremum: setting.and_then(|setting| setting.supremum(quantity, level, PARTS).ok()),
            sound: match quantity {
                Quantity::Distance => setting.and_then(|setting| setting.sound(level)),
                _ => None,
            },
            natural: naturally(paper, theorem, &cases)?,
        });
        (finding.verdict, finding.proof) = (TheoremVerdict::Refuted, None);
        finding.corrections = corrections(paper, theorem, &cases)?;
        finding.repairs = repairs(paper, theorem, &cases, &finding.cases, &finding.corrections)?;
    } else if finding.verdict == TheoremVerdict::Open && closed(theorem) {
        // A theorem about a single scheme, without parameters, is its only case.
        if let [CaseFinding { outcome: Outcome::Proved, .. }] = &finding.cases[..] {
            finding.verdict = TheoremVerdict::Proved;
            finding.proof = Some("by exact suprema at finitely many levels, and T_c".to_owned());
            finding.levels = as_printed.levels(&cases[0])?;
        }
    }
    Ok(finding)
}

/// What a theorem is with each point at its natural parameter; `None` where that is the same.
fn naturally(
    paper: &Paper,
    theorem: &Theorem,
    cases: &[Case<'_>],
) -> Result<Option<Naturally>, Diagnostic> {
    let moves =
        |case: &Case<'_>| case.setting.as_deref().is_some_and(|own| own.natural().is_some());
    if !cases.iter().any(moves) {
        return Ok(None);
    }
    let trial =
        Trial { paper, theorem, corrections: &[], parametrisation: Parametrisation::Natural };
    let (mut refuted, mut known) = (Vec::new(), true);
    for case in cases {
        match trial.of(case)? {
            Outcome::Refuted(violation) => refuted.push((case, violation)),
            Outcome::Proved | Outcome::UpTo(_) | Outcome::Outside(_) => {}
            Outcome::Unknown(_) => known = false,
        }
    }
    let least = refuted.into_iter().min_by_key(|(_, violation)| size(violation));
    Ok(Some(match least {
        Some((case, violation)) => {
            let resolved = case.resolved.iter().flat_map(|scheme| &scheme.constants);
            let masks: Vec<&Mask> = resolved.map(|axis| axis.mask()).collect();
            Naturally::Refuted {
                case: case.label.clone(),
                scheme: case.scheme.clone(),
                values: case.chosen.clone(),
                certifiable: has_words(&masks, &violation.attained),
                violation,
            }
        }
        None if known => Naturally::Holds,
        None => Naturally::Open,
    }))
}

/// Whether a theorem is about the single case that it is tried on.
fn closed(theorem: &Theorem) -> bool {
    theorem.scheme.is_some() && theorem.tried.values.is_empty()
}

/// How much there is to check: the level, the number of points, the length of numbers.
fn size(violation: &Violation) -> (u32, usize, usize) {
    let points = match &violation.attained.control {
        Control::Polygon(polygon) => polygon.points.len(),
        Control::Net { rows, .. } => rows.iter().map(Vec::len).sum(),
        Control::Points(points) => points.len(),
    };
    let text = format!("{}{}", violation.attained.value, violation.bound);
    (violation.level, points, text.len())
}

/// The smallest sets of corrections with which nothing refutes a theorem.
fn repairs(
    paper: &Paper,
    theorem: &Theorem,
    cases: &[Case<'_>],
    found: &[CaseFinding],
    all: &[Correction],
) -> Result<Vec<Repair>, Diagnostic> {
    let mut repairs: Vec<Repair> = Vec::new();
    // Where it is false as printed, it may well be so with corrections.
    let mut order: Vec<usize> = (0..cases.len()).collect();
    order.sort_by_key(|&i| !matches!(found[i].outcome, Outcome::Refuted(_)));
    for set in subsets(all).into_iter().skip(1) {
        let places: Vec<usize> = set
            .iter()
            .filter_map(|chosen| all.iter().position(|correction| correction == *chosen))
            .collect();
        let larger = |known: &Repair| known.corrections.iter().all(|i| places.contains(i));
        if repairs.iter().any(larger) {
            continue;
        }
        let parametrisation = Parametrisation::Indexed;
        let trial = Trial { paper, theorem, corrections: &set, parametrisation };
        let (mut saved, mut proved) = (true, true);
        for case in order.iter().map(|&i| &cases[i]) {
            match trial.of(case)? {
                Outcome::Refuted(_) => saved = false,
                Outcome::Proved | Outcome::Outside(_) => {}
                _ => proved = false,
            }
            if !saved {
                break;
            }
        }
        if saved {
            repairs.push(Repair { corrections: places, proved });
        }
    }
    Ok(repairs)
}
