//! A claim with its verdict.

use super::exact::Named;
use crate::audit::{self, EndFinding, KernelProof};
use crate::exact::Rounding;
use crate::report::json::smooth::smoothness::SmoothnessDetails;
use crate::report::json::tables::cell::{AsRead, CellSound};
use crate::report::json::theorems::theorem::Trial;
use serde::Serialize;
use std::borrow::Cow;

/// A claim: a cell of a table, an equation or another relation, a closed form, a range, a claim about smoothness or a theorem.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Claim<'a> {
    /// The id: `key:table:row:column` for a cell, `key:claim` for other claims.
    pub id: &'a str,
    /// Where in the paper it is.
    pub locus: &'a str,
    /// `number` for a cell, `equation`, `relation`, `function` for a closed form, `range`, `smoothness`,
    /// `exponent` or `theorem`.
    pub kind: &'static str,
    /// What is printed; null where a cell is lost.
    pub printed: Option<Cow<'a, str>>,
    /// The exact value of a cell's definition, or the exact range.
    pub exact: Option<String>,
    /// That value as a decimal.
    pub decimal: Option<String>,
    /// The trial of a theorem; its fields stand here, and are missing for other claims.
    #[serde(flatten)]
    pub trial: Option<Trial<'a>>,
    /// The verdict.
    pub verdict: &'static str,
    /// The reading that explains a cell, where it is another one than the printed.
    pub reading: Option<AsRead>,
    /// A sound statement on a bound, a depth or a range, whatever its verdict is.
    pub sound: Option<Sound<'a>>,
    /// What Coq's kernel accepts of a cell or a theorem: some of `value`, `constant` (which the value rests on),
    /// `sound`, `broken`, `broken-naturally`, `refuted` and `refuted-naturally`. Missing where it is nothing.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub checked_by_coq: Vec<&'static str>,
    /// What else there is to say.
    pub note: Option<Cow<'a, str>>,
    /// The fields that only claims of one kind have; they stand here.
    #[serde(flatten)]
    pub details: Details<'a>,
    /// The result of the checker for the certificate; its fields stand here, and are missing where
    /// the checker was not asked.
    #[serde(flatten)]
    pub certificate: Option<Certificate>,
}

/// A sound statement on a claim, whatever its verdict is.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum Sound<'a> {
    /// Of a cell.
    Cell(Box<CellSound<'a>>),
    /// Of a range.
    Range {
        /// Whether the condition holds in the whole printed range.
        kept: bool,
    },
}

/// The fields that only claims of one kind have.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum Details<'a> {
    /// Of a cell.
    Cell {
        /// The values that were put in for parameters that the paper does not state.
        assumed: Option<Named<String>>,
        /// The verdict if these values were stated.
        verdict_if_assumed: Option<&'static str>,
    },
    /// Of an equation or another relation.
    Equation {
        /// The cases in which the claim is false; null where there are none.
        failures: Option<Vec<Failure<'a>>>,
        /// Changes of one symbol after which the equation holds.
        mends: Option<&'a [String]>,
        /// Of a relation about real values of an index: where it is true, for each combination of the other indices. Where it is
        /// claimed for no other number, all real numbers count, and else those for which it is claimed.
        holds_for: Option<Vec<String>>,
    },
    /// Of a closed form in a free parameter.
    Function {
        /// The parameter.
        variable: &'a str,
        /// The values of the parameter for which the closed form is stated, if not all.
        domain: Option<String>,
        /// A value of the parameter at which the sides differ.
        failures: Option<[Failure<'a>; 1]>,
        /// Where the printed form is larger.
        printed_larger: Option<String>,
        /// Where it is smaller.
        printed_smaller: Option<String>,
    },
    /// Of a range of a free parameter.
    Range {
        /// The parameter.
        variable: &'a str,
        /// The printed ends.
        ends: Vec<End<'a>>,
    },
    /// Of a claim about smoothness.
    Smoothness(Box<SmoothnessDetails>),
    /// Of a theorem.
    Theorem {
        /// What it bounds: `distance`, `step`, `difference` or `depth`; null where it says
        /// something else.
        bounds: Option<&'static str>,
        /// The first level that it is stated for.
        from: Option<u32>,
        /// The ids of the claims that it rests on.
        rests: &'a [String],
        /// The ids of those among them that do not hold.
        failing: Vec<&'a str>,
    },
}

/// A case in which two sides differ.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Failure<'a> {
    /// The case in words.
    pub at: Cow<'a, str>,
    /// The left side.
    pub left: String,
    /// The right side.
    pub right: String,
    /// The left side less the right one.
    pub difference: String,
    /// Of one decimal on one side: `nearest`, `cut` or `away`, as it came from the other side; missing otherwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rounding: Option<&'static str>,
}

/// An end of a printed range.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct End<'a> {
    /// The end as printed.
    pub printed: &'a str,
    /// The end of the exact range; null where it has none there.
    pub exact: Option<String>,
    /// How the printed end and the exact end compare.
    pub relation: String,
    /// Whether the printed end is within the exact range.
    pub inside: bool,
    /// The value of the condition at the printed end.
    pub value: String,
}

/// The result of the checker for a claim, or for the table of a cell.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Certificate {
    /// Whether there is a valid certificate.
    pub certified: bool,
    /// `valid`, or `cited`, `invalid` or `incomplete` with the reason.
    pub certificate: String,
}

impl<'a> Claim<'a> {
    /// A claim that has no exact value.
    pub(crate) fn plain(
        id: &'a str,
        locus: &'a str,
        kind: &'static str,
        printed: impl Into<Cow<'a, str>>,
        verdict: &'static str,
        details: Details<'a>,
    ) -> Claim<'a> {
        Claim {
            id,
            locus,
            kind,
            printed: Some(printed.into()),
            exact: None,
            decimal: None,
            trial: None,
            verdict,
            reading: None,
            sound: None,
            checked_by_coq: Vec::new(),
            note: None,
            details,
            certificate: None,
        }
    }
}

pub(crate) fn names(proofs: &[KernelProof]) -> Vec<&'static str> {
    proofs.iter().map(|proof| proof.name()).collect()
}

/// A reason and a note, joined as far as they exist.
pub(crate) fn joined(reason: Option<String>, note: Option<&str>) -> Option<Cow<'_, str>> {
    match (reason, note) {
        (Some(reason), Some(note)) => Some(format!("{reason}; {note}").into()),
        (Some(reason), None) => Some(reason.into()),
        (None, note) => note.map(Cow::Borrowed),
    }
}

impl<'a> Failure<'a> {
    pub(crate) fn of(failure: &'a audit::Failure) -> Failure<'a> {
        Failure {
            at: failure.at.as_str().into(),
            left: failure.left.to_string(),
            right: failure.right.to_string(),
            difference: failure.difference().to_string(),
            rounding: failure.rounding.map(|rounding| match rounding {
                Rounding::Cut => "cut",
                Rounding::Up => "away",
                _ => "nearest",
            }),
        }
    }
}

impl<'a> End<'a> {
    pub(crate) fn of(end: &'a EndFinding) -> End<'a> {
        End {
            printed: &end.printed,
            exact: end.exact.as_ref().map(ToString::to_string),
            relation: end.relation.to_string(),
            inside: end.inside,
            value: end.value.to_string(),
        }
    }
}
