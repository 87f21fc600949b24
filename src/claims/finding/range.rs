//! The finding about a range of a free parameter.

use super::judgement::{Harm, Judgement};
use crate::cap::Cap;
use crate::claim::RangeClaim;
use crate::exact::{IntervalSet, Rational, RealAlgebraic};
use crate::finding::cell::Direction;
use crate::verdict::Word;
use std::fmt;

/// The finding about a range of a free parameter.
#[derive(Clone, Debug)]
pub struct RangeFinding<'a> {
    /// `key:range`.
    pub id: String,
    /// The claim.
    pub claim: &'a RangeClaim,
    /// What is found; where a value is beyond a cap, this cap.
    pub found: Result<FoundRange, Cap>,
}

impl RangeFinding<'_> {
    /// The word for its verdict.
    #[must_use]
    pub fn verdict(&self) -> Word {
        self.found.as_ref().map_or(Word::NotCheckable, |found| found.verdict.word())
    }
}

impl RangeFinding<'_> {
    pub(crate) fn judgement(&self) -> Judgement<'_> {
        let harm = if self.found.as_ref().is_ok_and(|found| found.kept) {
            Harm::NotSharp
        } else {
            Harm::Broken
        };
        Judgement { word: Some(self.verdict()), cap: self.found.as_ref().err(), harm }
    }
}

/// A printed range against the exact set.
#[derive(Clone, Debug)]
pub struct FoundRange {
    /// The verdict.
    pub verdict: RangeVerdict,
    /// The limit.
    pub limit: Rational,
    /// The exact set where the value keeps the limit.
    pub exact: IntervalSet,
    /// Where the value is below the limit.
    pub below: IntervalSet,
    /// Where the value is above the limit.
    pub above: IntervalSet,
    /// The ends that are printed, the lower one first.
    pub ends: Vec<EndFinding>,
    /// Whether the value keeps the limit in the whole printed range. A range for
    /// which it does is safe to use, though it may be too small.
    pub kept: bool,
}

/// The verdict of a range of a free parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RangeVerdict {
    /// The printed range is the exact set.
    Exact,
    /// It is, up to the rounding of its printed ends.
    Rounding,
    /// It is not.
    Inexact,
}

impl RangeVerdict {
    /// The word for it.
    #[must_use]
    pub fn word(self) -> Word {
        match self {
            RangeVerdict::Exact => Word::Exact,
            RangeVerdict::Rounding => Word::Rounding,
            RangeVerdict::Inexact => Word::Inexact,
        }
    }
}

/// A printed end of a range.
#[derive(Clone, Debug, PartialEq)]
pub struct EndFinding {
    /// The end as printed.
    pub printed: String,
    /// The end of the exact set on this side that is nearest to the printed one; `None` when the
    /// exact set has no finite end on this side.
    pub exact: Option<RealAlgebraic>,
    /// How the printed end came from the exact one.
    pub relation: EndRelation,
    /// Whether the printed number is in the exact set.
    pub inside: bool,
    /// The value at the printed number.
    pub value: Rational,
}

/// How a printed end of a range came from the exact one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EndRelation {
    /// They are equal.
    Equal,
    /// Equal numbers, but the printed one belongs to the range and the exact one
    /// does not, or the other way round.
    Belonging,
    /// Correctly rounded.
    Nearest,
    /// Cut, or rounded away from zero.
    Rounded(Direction),
    /// The exact end does not belong to the set, and this is the last decimal of its
    /// length that does.
    LastInside,
    /// Other numbers, and the printed one has one digit: it is taken as it stands, and not as a rounded one.
    FewDigits,
    /// None of these.
    Apart,
}

impl fmt::Display for EndRelation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            EndRelation::Equal => f.write_str("exact"),
            EndRelation::Belonging => f.write_str("the same number, but open for closed"),
            EndRelation::Nearest => f.write_str("correctly rounded"),
            EndRelation::Rounded(direction) => direction.fmt(f),
            EndRelation::LastInside => f.write_str("the last decimal of its length in the set"),
            EndRelation::FewDigits => {
                f.write_str("another number, and of one digit is none rounded")
            }
            EndRelation::Apart => f.write_str("not this end rounded"),
        }
    }
}
