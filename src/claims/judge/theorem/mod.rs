//! Judging theorems: proved, refuted by exact data, or open.

mod case;
mod correction;
mod evaluate;
mod growth;
mod instance;
mod levels;
mod local_rules;
mod natural;
mod setting;
mod shift;
mod simplest;
mod trial;
mod uniform;

pub(crate) use instance::{Instance, instance};

use crate::claim::{Paper, Quantity, Statement, Theorem};
use crate::diagnostic::Diagnostic;
use crate::evaluation::library::{Library, Resolved};
use crate::finding::{
    CaseFinding, Correction, Outcome, Refutation, Repair, TheoremFinding, TheoremVerdict, Violation,
};
use crate::judge::kind::Judge;
use crate::judge::theorem::case::{Case, Stage};
use crate::judge::theorem::correction::{corrections, subsets};
use crate::judge::theorem::natural::{naturally, outcomes, placed, size};
use crate::judge::theorem::setting::Setting;
use crate::judge::theorem::shift::every_shift;
use crate::judge::theorem::trial::Trial;
use std::collections::BTreeSet;

/// The precision of the supremum that is given beside a false bound: 1/1000 of it.
const PARTS: u32 = 1_000;

impl<'a> Judge<'a> for Theorem {
    type Finding = TheoremFinding<'a>;

    /// All theorems, since one thread has time enough for them.
    fn groups(theorems: &'a [Theorem]) -> Vec<Vec<&'a Theorem>> {
        vec![theorems.iter().collect()]
    }

    fn work(&self) -> usize {
        2
    }

    /// Tries theorems, each by itself.
    fn judge(
        paper: &'a Paper,
        theorems: &[&'a Theorem],
        after_claim: &(dyn Fn() + Sync),
    ) -> Result<Vec<TheoremFinding<'a>>, Diagnostic> {
        let one = |theorem: &&'a Theorem| {
            let found = one(paper, theorem, &Library::new(paper), &Stage::default());
            after_claim();
            found
        };
        theorems.iter().map(one).collect()
    }
}

/// The masks of the cases with these labels, each once; rings have none.
pub(crate) fn schemes_of(
    paper: &Paper,
    theorem: &Theorem,
    labels: &BTreeSet<&str>,
) -> Result<Vec<Resolved>, Diagnostic> {
    let (library, stage) = (Library::new(paper), Stage::default());
    let cases = Case::all(paper, theorem, &library, &stage)?.into_iter();
    let named = cases.filter(|case| labels.contains(&case.label[..]));
    let mut found: Vec<Resolved> = Vec::new();
    for resolved in named.filter_map(|case| case.resolved) {
        if found.iter().all(|other| other.instances != resolved.instances) {
            found.push(resolved);
        }
    }
    Ok(found)
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
        by_kernel: Vec::new(),
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
    let parametrisation = theorem.tried.parametrisation();
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
        let setting = case.setting.as_deref().map(|setting| as_printed.placed(setting));
        let natural = outcomes(paper, theorem, &cases, &finding.cases)?;
        let every_shift = every_shift(theorem, &cases, &natural)?;
        let Violation { quantity, level, .. } = **violation;
        finding.refutation = Some(Refutation {
            case: case.label.clone(),
            scheme: case.scheme.clone(),
            values: case.chosen.clone(),
            limit: match quantity {
                Quantity::Distance if !theorem.tried.natural => {
                    setting.and_then(Setting::limit).unwrap_or_default().to_vec()
                }
                _ => Vec::new(),
            },
            violation: (**violation).clone(),
            supremum: setting.and_then(|setting| setting.supremum(quantity, level, PARTS).ok()),
            sound: match quantity {
                Quantity::Distance => setting.and_then(|setting| setting.sound(level)),
                _ => None,
            },
            natural: (placed(theorem, &cases) && !theorem.tried.natural)
                .then(|| naturally(&cases, &natural, every_shift.as_ref())),
            every_shift,
        });
        (finding.verdict, finding.proof) = (TheoremVerdict::Refuted, None);
        finding.corrections = corrections(paper, theorem, &cases)?;
        finding.repairs = repairs(paper, theorem, &cases, &finding.cases, &finding.corrections)?;
    } else if finding.verdict != TheoremVerdict::Proved && closed(theorem) {
        // A theorem about a single scheme, without open values, has only this case. Its proof is worth more than a
        // text that says the contrary.
        if let [CaseFinding { outcome: Outcome::Proved, .. }] = &finding.cases[..] {
            finding.verdict = TheoremVerdict::Proved;
            finding.proof = Some("by exact suprema at finitely many levels, and T_c".to_owned());
            // The lines of a certificate are about points at i/n^k.
            if !theorem.tried.natural {
                finding.levels = as_printed.levels(&cases[0])?;
            }
        }
    }
    Ok(finding)
}

/// Whether a theorem is about the single case that it is tried on.
fn closed(theorem: &Theorem) -> bool {
    theorem.scheme.is_some() && theorem.tried.values.is_empty()
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
    // Cases that refute the theorem as printed come first: corrections are likely to fail there
    // too.
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
        let parametrisation = theorem.tried.parametrisation();
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
