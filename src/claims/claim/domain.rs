//! Intervals of a free parameter, as papers print them.

use crate::exact::{Decimal, Interval, IntervalSet, Rational, RealAlgebraic};
use std::ops::{Bound, Range};

/// The digits that a decimal needs to be called rounded, from the first that is not 0.
const MIN_DIGITS: usize = 2;

/// Whether an end of a range, or a side of an equation, may be a rounded one.
pub(crate) fn is_rounded(end: &Decimal) -> bool {
    end.significant_digits() >= MIN_DIGITS
}

/// How the ends of a printed range are taken. A *rounded* end stands for all numbers that are less than a unit of its
/// last place away, as the cell of a table does that is rounded in some way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// As they are printed.
    Printed,
    /// The values that are in the range whatever the rounded ends stand for.
    Least,
    /// The values that are in the range for something that the rounded ends stand for.
    Most,
}

/// The values of a free parameter for which a paper states something: an interval with printed ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Domain {
    /// The lower end; `None` when the interval has none.
    pub from: Option<RangeEnd>,
    /// The upper end; `None` when the interval has none.
    pub to: Option<RangeEnd>,
    /// Whether the ends belong to the interval. Where the paper does not say it, they do not.
    pub closed: bool,
}

impl Domain {
    /// The interval. Without a number in it, it is empty.
    #[must_use]
    pub fn interval(&self, ends: Ends) -> IntervalSet {
        let sides = [(self.from.as_ref(), 1), (self.to.as_ref(), -1)];
        let printed = sides.map(|(end, _)| end.map(|end| end.value.clone()));
        // The rounded ends so many units further in.
        let moved = |units: i64| {
            sides.map(|(end, inwards)| {
                let decimal = end?.decimal.as_ref().filter(|decimal| is_rounded(decimal))?;
                let by = decimal.unit() * Rational::from(units * inwards);
                Some(RealAlgebraic::from(decimal.value() + by))
            })
        };
        let [from, to] = moved(1);
        let least = from.as_ref().or(printed[0].as_ref()).zip(to.as_ref().or(printed[1].as_ref()));
        let rounded = match ends {
            // Nothing is in the range whatever its ends stand for.
            _ if least.is_some_and(|(from, to)| from >= to) => [None, None],
            Ends::Printed => [None, None],
            Ends::Least => [from, to].map(|end| end.map(Bound::Included)),
            Ends::Most => moved(-1).map(|end| end.map(Bound::Excluded)),
        };
        let as_printed = |end: Option<RealAlgebraic>| match end {
            None => Bound::Unbounded,
            Some(end) if self.closed => Bound::Included(end),
            Some(end) => Bound::Excluded(end),
        };
        let [low, high] = printed.map(as_printed);
        let [from, to] = rounded;
        let (low, high) = (from.unwrap_or(low), to.unwrap_or(high));
        let ordered = match (&low, &high) {
            (
                Bound::Included(low) | Bound::Excluded(low),
                Bound::Included(high) | Bound::Excluded(high),
            ) => low < high,
            _ => true,
        };
        if ordered { IntervalSet::from(Interval { low, high }) } else { IntervalSet::default() }
    }
}

/// An end of a printed interval.
#[derive(Clone, Debug, PartialEq)]
pub struct RangeEnd {
    /// The end as printed.
    pub text: String,
    /// The decimal, where a decimal is printed.
    pub decimal: Option<Decimal>,
    /// Its value.
    pub value: RealAlgebraic,
    /// Its range of bytes in the file.
    pub span: Range<usize>,
}
