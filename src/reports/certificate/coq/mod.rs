//! Findings as theorems of Coq, for the library in `proofs/coq`.
//!
//! Nothing here is trusted: each file holds masks, numbers and one application of a lemma to each
//! statement, and Coq accepts or rejects it.

mod numbers;

use crate::audit::{
    Excess, KernelFinding, KernelStatement, PaperAudit, RingExcess, kernel_findings,
};
use crate::bound::Operator;
use crate::diagnostic::Diagnostic;
use crate::exact::Rational;
use crate::scheme::Rules;
use numbers::{integers, over_one, rational, rules, rules_over, signed};
use std::fmt::Write as _;

/// The theorems about one claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CoqFile {
    /// The file's name with its folder, such as `mustafa2020_nary/table_1.v`.
    pub name: String,
    /// What it holds.
    pub text: String,
    /// The number of its theorems.
    pub theorems: usize,
}

/// What Coq can check of a paper's findings, in one file for each claim.
///
/// ```
/// use subcert::audit::audit;
/// use subcert::certificate::coq_files;
/// use subcert::claim::embedded_papers;
///
/// let papers = embedded_papers()?;
/// let files = coq_files(&audit(&papers[2])?)?;
/// assert!(files.iter().any(|file| file.name == "khan2019_newton/lemma_6_1.v"));
/// # Ok::<(), subcert::diagnostic::Diagnostic>(())
/// ```
///
/// # Errors
/// When a formula of the claim file is wrong.
pub fn coq_files(audit: &PaperAudit<'_>) -> Result<Vec<CoqFile>, Diagnostic> {
    let findings = kernel_findings(audit)?;
    let mut files = Vec::new();
    for claims in findings.chunk_by(|a, b| a.claim == b.claim) {
        let name = format!("{}/{}.v", word(&audit.paper.key), word(&claims[0].claim));
        let mut file = File::default();
        for finding in claims {
            file.theorem(finding);
        }
        let KernelFinding { kind, claim, assumed, .. } = &claims[0];
        let key = &audit.paper.key;
        let mut head = format!("(** {key}, {kind} {claim} (written by `subcert prove --coq`) *)\n");
        if !assumed.is_empty() {
            let values = assumed.iter().map(|(name, value)| format!("{name} = {value}"));
            let values = values.collect::<Vec<String>>().join(", ");
            let _ = writeln!(head, "(* Not stated: {values} *)");
        }
        let _ = write!(head, "\n{HEAD}");
        let text = format!("{head}{}", file.text);
        files.push(CoqFile { name, text, theorems: claims.len() });
    }
    Ok(files)
}

const HEAD: &str = "\
From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.
";

/// Every theorem is one application, and one computation that decides its conditions.
const PROOF: &str = "vm_cast_no_check (eq_refl true). Qed.";

/// A file in the making, with the objects that it has defined.
#[derive(Default)]
struct File {
    text: String,
    defined: Vec<(String, String)>,
    theorems: usize,
}

impl File {
    /// The name of an object, which is defined where it is new.
    fn define(&mut self, kind: &str, value: String) -> String {
        let of_kind = self.defined.iter().filter(|(name, _)| name.starts_with(kind));
        if let Some((name, _)) = of_kind.clone().find(|(_, known)| *known == value) {
            return name.clone();
        }
        let name = format!("{kind}_{}", of_kind.count() + 1);
        let _ = write!(self.text, "\nDefinition {name} :=\n  {value}.\n");
        self.defined.push((name.clone(), value));
        name
    }

    fn theorem(&mut self, finding: &KernelFinding) {
        let (statement, lemma) = match &finding.statement {
            KernelStatement::Constant { mask, operator, backwards, levels, value } => {
                let scheme = self.define("scheme", rules(mask.rules()));
                self.constant(
                    (&scheme, mask.rules()),
                    *operator,
                    backwards.as_ref(),
                    (*levels, value),
                )
            }
            KernelStatement::Distance { mask, level, bound, block: (most, block) } => {
                let scheme = self.define("scheme", rules(mask.rules()));
                let bound = rational(bound);
                (
                    format!("bounds_distance {scheme} 0 {level} {bound}"),
                    format!("bounds_distance_by {scheme} 0 {most} {block}"),
                )
            }
            KernelStatement::Depth { mask, level, spread, tolerance, block: (most, block) } => {
                let scheme = self.define("scheme", rules(mask.rules()));
                let (spread, tolerance) = (rational(spread), rational(tolerance));
                (
                    format!("sufficient_depth {scheme} 0 {spread} {tolerance} {level}"),
                    format!("sufficient_depth_by {scheme} 0 {most} {block}"),
                )
            }
            KernelStatement::Exceeds { mask, shift, level, first, points, excess, bound } => {
                let scheme = self.define("scheme", rules(mask.rules()));
                let data = format!("{} {}", signed(*first), integers(points));
                let bound = rational(bound);
                let of = match excess {
                    Excess::Difference(_) => format!("{scheme} {level}"),
                    _ => format!("{scheme} {} {level}", rational(shift)),
                };
                exceeds(&of, &data, excess, &bound)
            }
            KernelStatement::Net { masks, shifts, level, polygons, excess, bound } => {
                let names = masks.each_ref().map(|mask| self.define("scheme", rules(mask.rules())));
                let data = polygons
                    .each_ref()
                    .map(|(first, points)| format!("{} {}", signed(*first), integers(points)));
                let shifts = shifts.each_ref().map(rational);
                let of = format!("{} {} {level}", names.join(" "), shifts.join(" "));
                net_exceeds(&of, &data.join(" "), excess, &rational(bound))
            }
            KernelStatement::Ring { weights, edges, level, points, excess, bound } => {
                let edges: Vec<String> = edges.iter().map(|(a, b)| format!("({a}, {b})")).collect();
                let mut ring = |weights: &[Vec<Rational>]| {
                    let (denominator, rows) = over_one(weights);
                    let edges = edges.join("; ");
                    self.define("ring", format!("Ring {denominator} {rows}\n    [{edges}]%nat"))
                };
                let mut of = ring(weights);
                if let RingExcess::Step(_, earlier) = excess {
                    let _ = write!(of, " {}", ring(earlier));
                }
                let bound = rational(bound);
                ring_exceeds(&format!("{of} {level}"), &integers(points), excess, &bound)
            }
        };
        self.theorems += 1;
        let (place, about) = (comment(&finding.place), comment(&finding.about));
        let _ = write!(self.text, "\n(* {place} *)\n(* {about} *)\n");
        let number = self.theorems;
        let lemma = if lemma.contains(' ') { format!("({lemma})") } else { lemma };
        let _ = write!(
            self.text,
            "Theorem finding_{number} :\n  {statement}.\nProof. apply {lemma}. {PROOF}\n"
        );
    }

    fn constant(
        &mut self,
        (scheme, mask): (&str, &Rules),
        operator: Operator,
        backwards: Option<&Rules>,
        (levels, value): (u32, &Rational),
    ) -> (String, String) {
        let value = rational(value);
        match (operator, backwards) {
            (Operator::Difference, None) => (
                format!("contraction_constant {scheme} {levels} {value}"),
                "contraction_constant_by".to_owned(),
            ),
            (Operator::Difference, Some(difference)) => {
                let difference = self.define("difference", rules_over(difference, mask));
                (
                    format!("backwards_constant {scheme} {difference} {levels} {value}"),
                    "backwards_constant_by".to_owned(),
                )
            }
            (Operator::Scheme, None) => {
                (format!("scheme_norm {scheme} {levels} {value}"), "scheme_norm_by".to_owned())
            }
            (Operator::Scheme, Some(_)) => (
                format!("scheme_norm (backwards {scheme}) {levels} {value}"),
                "scheme_norm_by".to_owned(),
            ),
        }
    }
}

fn exceeds(of: &str, data: &str, excess: &Excess, bound: &str) -> (String, String) {
    match excess {
        Excess::Difference(place) => (
            format!("exceeds_difference {of} 1 {bound}"),
            format!("exceeds_difference_by {of} {data} {}", signed(*place)),
        ),
        Excess::Step(place) => (
            format!("exceeds_step {of} 1 {bound}"),
            format!("exceeds_step_by {of} {data} {}", rational(place)),
        ),
        Excess::Distance { place, later, tail, block: (most, block) } => (
            format!("exceeds_distance {of} 1 {bound}"),
            format!(
                "exceeds_distance_by {of} {data} {} 1 {bound}\n  {later} {most} {block} {}",
                rational(place),
                rational(tail)
            ),
        ),
    }
}

fn net_exceeds(of: &str, data: &str, excess: &[Excess; 2], bound: &str) -> (String, String) {
    match excess {
        [
            Excess::Distance { place: s, later, tail, block: (most, block) },
            Excess::Distance { place: t, later: later2, tail: tail2, block: (most2, block2) },
        ] => (
            format!("exceeds_net_distance {of} 1 {bound}"),
            format!(
                "exceeds_net_distance_by {of} {data} {} {} 1 {bound}\n  {} {most} {block} {} {most2} {block2} {}",
                rational(s),
                rational(t),
                later.max(later2),
                rational(tail),
                rational(tail2)
            ),
        ),
        [Excess::Step(s), Excess::Step(t)] => (
            format!("exceeds_net_step {of} 1 {bound}"),
            format!("exceeds_net_step_by {of} {data} {} {}", rational(s), rational(t)),
        ),
        _ => unreachable!("both directions have the same quantity"),
    }
}

fn ring_exceeds(of: &str, data: &str, excess: &RingExcess, bound: &str) -> (String, String) {
    match excess {
        RingExcess::Difference(a, b) => (
            format!("exceeds_ring_difference {of} 1 {bound}"),
            format!("exceeds_ring_difference_by {of} {data} {a} {b}"),
        ),
        RingExcess::Step(a, _) => (
            format!("exceeds_ring_step {of} 1 {bound}"),
            format!("exceeds_ring_step_by {of} {data} {a}"),
        ),
        RingExcess::Distance(a, weights) => {
            let (denominator, row) = over_one(std::slice::from_ref(weights));
            (
                format!("exceeds_ring_distance {of} 1 {bound}"),
                format!("exceeds_ring_distance_by {of} {data} {a} {denominator} {row}"),
            )
        }
    }
}

/// An id as an identifier of Coq.
fn word(id: &str) -> String {
    id.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect()
}

/// A text that a comment of Coq can hold, in one line.
fn comment(text: &str) -> String {
    let words: Vec<&str> = text.split_whitespace().collect();
    words.join(" ").replace("(*", "( *").replace("*)", "* )").replace('"', "'")
}
