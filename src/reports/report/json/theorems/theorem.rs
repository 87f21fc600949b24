//! The trial of a theorem.

use super::witness::Witness;
use crate::audit::{self, CaseFinding, Outcome, TheoremFinding, Word};
use serde::Serialize;

/// The trial of a theorem.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Trial<'a> {
    /// What proves it.
    pub proof: Option<&'a str>,
    /// What refutes it.
    pub witness: Option<Witness<'a>>,
    /// The cases that it was tried on.
    pub cases: Vec<Case<'a>>,
    /// Sets of corrections with which it is not refuted.
    pub repairs: Vec<Repair>,
}

/// A case that a theorem was tried on.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Case<'a> {
    /// The scheme and the values of the parameters.
    pub case: &'a str,
    /// `refuted`, `proved`, `holds` up to a level, `unknown`, or `outside` of what the theorem
    /// speaks of.
    pub outcome: &'static str,
    /// The level at which it is refuted, or up to which it holds.
    pub level: Option<u32>,
    /// Why the outcome is unknown, or the case outside.
    pub why: Option<String>,
}

/// Corrections with which a theorem is not refuted.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Repair {
    /// What each of them says.
    pub corrections: Vec<String>,
    /// Whether the theorem is then proved in every case that it speaks of.
    pub proved: bool,
}

impl<'a> Trial<'a> {
    pub(crate) fn of(finding: &'a TheoremFinding<'_>) -> Trial<'a> {
        let says = |i: &usize| finding.corrections[*i].to_string();
        let repair = |repair: &audit::Repair| Repair {
            corrections: repair.corrections.iter().map(says).collect(),
            proved: repair.proved,
        };
        Trial {
            proof: finding.proof.as_deref(),
            witness: finding.refutation.as_ref().map(Witness::of),
            cases: finding.cases.iter().map(Case::of).collect(),
            repairs: finding.repairs.iter().map(repair).collect(),
        }
    }
}

impl<'a> Case<'a> {
    fn of(case: &'a CaseFinding) -> Case<'a> {
        let (outcome, level, why) = match &case.outcome {
            Outcome::Refuted(violation) => (Word::Refuted.name(), Some(violation.level), None),
            Outcome::Proved => (Word::Proved.name(), None, None),
            Outcome::UpTo(level) => (Word::Holds.name(), Some(*level), None),
            Outcome::Unknown(why) => ("unknown", None, Some(why.to_string())),
            Outcome::Outside(why) => ("outside", None, Some(why.to_string())),
        };
        Case { case: &case.label, outcome, level, why }
    }
}
