//! Judging theorems: proved, refuted by exact data, or open.

mod case;
mod correction;
mod curve;
mod evaluate;
mod growth;
mod levels;
mod premises;
mod ring;
mod setting;
mod surface;
mod trial;
mod witness;

pub use correction::Correction;
pub use levels::{LevelEvidence, Levels};
pub use premises::FailingPremise;
pub use trial::Outcome;
pub use witness::{Attained, Control, Place, Supremum, Violation};

use super::PaperAudit;
use super::library::Library;
use crate::claim::{Paper, Quantity, Statement, Theorem};
use crate::diagnostic::Diagnostic;
use crate::exact::{Rational, RealCyclotomic};
use case::{Case, Stage};
use correction::{corrections, subsets};
use setting::Setting;
use trial::Trial;

/// How exactly the supremum beside a false bound is enclosed, in parts of it.
const PARTS: u32 = 1_000;

/// What the audit says of a theorem.
#[derive(Clone, Debug)]
pub struct TheoremFinding<'a> {
    /// `key:theorem`.
    pub id: String,
    /// The theorem.
    pub theorem: &'a Theorem,
    /// The verdict.
    pub verdict: TheoremVerdict,
    /// What shows it; `None` for an open theorem.
    pub proof: Option<String>,
    /// Of a theorem about a single scheme that is proved without a proof by hand, the levels that
    /// prove it.
    pub levels: Option<Levels>,
    /// Of a refuted theorem, the simplest data that refute it.
    pub refutation: Option<Refutation>,
    /// What it was tried on.
    pub cases: Vec<CaseFinding>,
    /// Of a refuted theorem, how a reader may try to save it.
    pub corrections: Vec<Correction>,
    /// The smallest sets of corrections with which nothing refutes it.
    pub repairs: Vec<Repair>,
    /// The claims that do not hold and that it rests on, at once or through other
    /// theorems. It may be true in spite of them; its proof does not show it.
    pub failing: Vec<FailingPremise<'a>>,
}

/// The verdict of a theorem.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TheoremVerdict {
    /// It is true.
    Proved,
    /// It is false.
    Refuted,
    /// Neither is known.
    Open,
}

impl TheoremVerdict {
    /// The verdict's name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            TheoremVerdict::Proved => "proved",
            TheoremVerdict::Refuted => "refuted",
            TheoremVerdict::Open => "open",
        }
    }
}

/// A case, and what the theorem is there.
#[derive(Clone, Debug, PartialEq)]
pub struct CaseFinding {
    /// The scheme and the values.
    pub label: String,
    /// What the trial has shown.
    pub outcome: Outcome,
}

/// A case in which a theorem is false.
#[derive(Clone, Debug, PartialEq)]
pub struct Refutation {
    /// The scheme and the values, in a few words.
    pub case: String,
    /// The scheme, as the claim refers to it.
    pub scheme: String,
    /// The values of the names that the theorem leaves open.
    pub values: Vec<(String, Rational)>,
    /// Of a distance of a ring, the weights of its limit.
    pub limit: Vec<RealCyclotomic>,
    /// The data.
    pub violation: Violation,
    /// The supremum over all control data, at this level.
    pub supremum: Option<Supremum>,
    /// The sound block bound of the distance, at this level.
    pub sound: Option<RealCyclotomic>,
}

/// Corrections with which nothing refutes a theorem.
#[derive(Clone, Debug, PartialEq)]
pub struct Repair {
    /// The places of the corrections.
    pub corrections: Vec<usize>,
    /// Whether it is then proved in every case that it speaks of.
    pub proved: bool,
}

/// Tries the theorems of a paper, each by itself.
pub(super) fn trials<'a>(
    paper: &'a Paper,
    library: &Library<'_>,
) -> Result<Vec<TheoremFinding<'a>>, Diagnostic> {
    let one = |theorem| one(paper, theorem, library, &Stage::default());
    paper.theorems.iter().map(one).collect()
}

/// Finds what the theorems rest on that does not hold, when all claims are judged.
pub(super) fn premises(audit: &mut PaperAudit<'_>) {
    let mut findings = std::mem::take(&mut audit.theorems);
    premises::find(audit, &mut findings);
    audit.theorems = findings;
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
    let as_printed = Trial { paper, theorem, corrections: &[] };
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
        let trial = Trial { paper, theorem, corrections: &set };
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
