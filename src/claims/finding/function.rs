//! The finding about a closed form in a free parameter.

use super::judgement::{Harm, Judgement};
use crate::cap::Cap;
use crate::claim::FunctionClaim;
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
    /// Both sides are equal at every value of the parameter.
    Holds,
    /// They differ somewhere.
    Fails {
        /// Where the printed form is larger.
        larger: IntervalSet,
        /// Where the printed form is smaller: there a bound that uses it promises too much.
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
