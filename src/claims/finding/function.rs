//! The finding about a closed form in a free parameter.

use super::judgement::{Harm, Judgement};
use crate::cap::Cap;
use crate::claim::{Ends, FunctionClaim};
use crate::exact::{IntervalSet, Rational};
use crate::verdict::Word;

/// The finding about a closed form in a free parameter.
#[derive(Clone, Debug)]
pub struct FunctionFinding<'a> {
    /// `key:function`.
    pub id: String,
    /// The claim.
    pub claim: &'a FunctionClaim,
    /// The verdict.
    pub verdict: FunctionVerdict,
    /// Where the printed form is larger, also beyond the values for which it is stated.
    pub above: IntervalSet,
    /// Where the printed form is smaller, also beyond these values.
    pub below: IntervalSet,
}

impl FunctionFinding<'_> {
    /// The values at which both sides are compared: those for which the printed form is stated, unless they differ
    /// only where a rounded end leaves open whether it is; then those for which it is stated whatever its rounded ends
    /// stand for ([`Ends`]).
    #[must_use]
    pub fn compared(&self) -> Ends {
        let printed = self.claim.domain.interval(Ends::Printed);
        let differ = !self.above.union(&self.below).intersection(&printed).is_empty();
        let holds = self.verdict == FunctionVerdict::Holds;
        if holds && differ { Ends::Least } else { Ends::Printed }
    }
}

impl FunctionFinding<'_> {
    pub(crate) fn judgement(&self) -> Judgement<'_> {
        let cap =
            if let FunctionVerdict::BeyondCap(cap) = &self.verdict { Some(cap) } else { None };
        Judgement { word: Some(self.verdict.word()), cap, harm: Harm::Formula }
    }
}

/// The verdict of a closed form in a free parameter.
#[derive(Clone, Debug, PartialEq)]
pub enum FunctionVerdict {
    /// Both sides are equal at every value of the parameter for which this is stated, whatever the rounded ends of
    /// these values stand for.
    Holds,
    /// They differ somewhere.
    Fails {
        /// Where the printed form is larger, of the values for which it is stated.
        larger: IntervalSet,
        /// Where it is smaller: there a bound that uses it promises too much.
        smaller: IntervalSet,
        /// A value of the parameter at which they differ.
        example: Box<Example>,
    },
    /// A value is beyond a cap.
    BeyondCap(Cap),
}

impl FunctionVerdict {
    /// The word for it.
    #[must_use]
    pub fn word(&self) -> Word {
        match self {
            FunctionVerdict::Holds => Word::Holds,
            FunctionVerdict::Fails { .. } => Word::Fails,
            FunctionVerdict::BeyondCap(_) => Word::NotCheckable,
        }
    }
}

/// Both sides at one value of the parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Example {
    /// The parameter.
    pub at: Rational,
    /// The printed form there.
    pub left: Rational,
    /// The other side there.
    pub right: Rational,
}
