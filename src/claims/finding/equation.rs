//! The finding about an equation.

use super::judgement::{Harm, Judgement};
use crate::cap::Cap;
use crate::claim::Equation;
use crate::exact::{Polynomial, Rational, Rounding};
use crate::verdict::Word;

/// The finding about an equation.
#[derive(Clone, Debug)]
pub struct EquationFinding<'a> {
    /// `key:equation`.
    pub id: String,
    /// The equation.
    pub equation: &'a Equation,
    /// The verdict.
    pub verdict: EquationVerdict,
}

impl EquationFinding<'_> {
    pub(crate) fn judgement(&self) -> Judgement<'_> {
        let cap =
            if let EquationVerdict::BeyondCap(cap) = &self.verdict { Some(cap) } else { None };
        Judgement { word: Some(self.verdict.word()), cap, harm: Harm::Formula }
    }
}

/// The verdict of an equation.
#[derive(Clone, Debug, PartialEq)]
pub enum EquationVerdict {
    /// The claim is true in all cases.
    Holds {
        /// The number of combinations of the indices, times that of the comparisons.
        cases: usize,
    },
    /// The claim is true for all integers from one on.
    Proved,
    /// It is not decided for all integers from one on, and true in these cases.
    Tried {
        /// The number of combinations of the indices that were tried, times that of the comparisons.
        cases: usize,
    },
    /// They differ somewhere.
    Fails {
        /// The number of combinations of the indices, times that of the comparisons; 1 of a claim about all integers from one on.
        cases: usize,
        /// The cases in which the sides differ.
        failures: Vec<Failure>,
        /// Changes of one symbol after which the equation holds in all cases.
        mends: Vec<String>,
    },
    /// The equation needs something that is absent, as the claim says.
    NotCheckable,
    /// A value is beyond a cap.
    BeyondCap(Cap),
}

impl EquationVerdict {
    /// The word for it.
    #[must_use]
    pub fn word(&self) -> Word {
        match self {
            EquationVerdict::Holds { .. } | EquationVerdict::Proved => Word::Holds,
            EquationVerdict::Tried { .. } => Word::Open,
            EquationVerdict::Fails { .. } => Word::Fails,
            EquationVerdict::NotCheckable | EquationVerdict::BeyondCap(_) => Word::NotCheckable,
        }
    }

    /// Whether it fails only since the decimals that are printed are rounded or cut.
    #[must_use]
    pub fn is_rounded(&self) -> bool {
        let EquationVerdict::Fails { failures, .. } = self else { return false };
        failures.iter().all(|failure| failure.rounding.is_some())
    }
}

/// A case in which the two sides differ.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// The indices in words; empty when there are none.
    pub at: String,
    /// The values of the indices.
    pub indices: Vec<Rational>,
    /// The left side.
    pub left: Polynomial,
    /// The right side.
    pub right: Polynomial,
    /// Where one side is one decimal and the other side a number: how the decimal came from it.
    pub rounding: Option<Rounding>,
}

impl Failure {
    /// left − right.
    #[must_use]
    pub fn difference(&self) -> Polynomial {
        &self.left - &self.right
    }
}
