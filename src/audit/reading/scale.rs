//! Solving for the scale of the data.

use super::consistent::DecimalRounding;
use crate::claim::Printed;
use crate::exact::{Enclosed, Integer, Rational, RealCyclotomic};
use std::cmp::Reverse;

/// A parameter that the paper does not state, as the printed numbers determine it.
#[derive(Clone, Debug, PartialEq)]
pub struct Solved {
    /// Its name.
    pub name: String,
    /// The values with which every explained cell is consistent lie between these,
    /// up to 2^−60 of them.
    pub between: (Rational, Rational),
    /// The simplest number among them; of a spread, the assumed one where it is among
    /// them.
    pub simplest: Rational,
}

/// A parameter that the values of a table are proportional to.
pub(super) struct Scale {
    pub(super) name: String,
    /// Its stated or assumed value.
    pub(super) base: Rational,
    pub(super) stated: bool,
}

/// The most intervals that are looked at for a number that someone would choose.
const MAX_INTERVALS: usize = 12;

/// The precision of the ends: enclosures of 128 binary digits.
const PRECISION: u32 = 1;

/// The values of s for which some cells are consistent with s times their exact values:
/// the ends of each proper interval, those of most cells first.
pub(super) fn solve(
    cells: &[(&Printed, &RealCyclotomic)],
    rounding: DecimalRounding,
) -> impl Iterator<Item = (Rational, Rational)> {
    let intervals: Vec<(Rational, Rational)> =
        cells.iter().filter_map(|(printed, value)| interval(printed, value, rounding)).collect();
    let covers = |(low, high): &(Rational, Rational), s: &Rational| low <= s && s <= high;
    let mut ends: [Vec<&Rational>; 2] = [
        intervals.iter().map(|(low, _)| low).collect(),
        intervals.iter().map(|(_, high)| high).collect(),
    ];
    for ends in &mut ends {
        ends.sort_unstable();
    }
    // Those that begin up to s less those that end before it.
    let count = |s: &Rational| {
        ends[0].partition_point(|low| *low <= s) - ends[1].partition_point(|high| *high < s)
    };
    // The greatest number of intervals meets at the lower end of one of them.
    let mut lows: Vec<(usize, Rational)> =
        intervals.iter().map(|(low, _)| (count(low), low.clone())).collect();
    lows.sort_by_key(|(count, _)| Reverse(*count));
    lows.into_iter().take(MAX_INTERVALS).filter_map(move |(_, s)| {
        let meeting = || intervals.iter().filter(|interval| covers(interval, &s));
        let low = meeting().map(|(low, _)| low.clone()).max()?;
        let high = meeting().map(|(_, high)| high.clone()).min()?;
        (low < high).then_some((low, high))
    })
}

/// The s > 0 for which s·value rounds to what is printed.
fn interval(
    printed: &Printed,
    value: &RealCyclotomic,
    rounding: DecimalRounding,
) -> Option<(Rational, Rational)> {
    let (shown, unit) = (printed.decimal.value().abs(), printed.decimal.unit());
    let half = &unit / Rational::from(2);
    let (low, high) = match rounding {
        DecimalRounding::Nearest => (&shown - &half, &shown + &half),
        DecimalRounding::Cut => (shown.clone(), &shown + &unit),
        DecimalRounding::Away => (&shown - &unit, shown.clone()),
    };
    let enclosure = value.abs().enclosure(PRECISION);
    if enclosure.lower().sign() <= 0 || low.sign() <= 0 {
        return None;
    }
    Some((low / enclosure.upper(), high / enclosure.lower()))
}

/// The greatest numerator and denominator of a scale that someone would choose.
const MAX_SIMPLE: i64 = 100;

/// Whether someone would choose this as the scale of data.
pub(super) fn is_simple(scale: &Rational) -> bool {
    let most = Integer::from(MAX_SIMPLE);
    scale.numerator() <= most && scale.denominator() <= most
}

/// The fraction of least denominator, and of these the least numerator, in an
/// interval that holds those of its ends that the rounding lets it.
pub(super) fn simplest(low: &Rational, high: &Rational, rounding: DecimalRounding) -> Rational {
    let (with_low, with_high) = match rounding {
        DecimalRounding::Nearest => (true, true),
        DecimalRounding::Cut => (true, false),
        DecimalRounding::Away => (false, true),
    };
    let ends = [(with_low, low), (with_high, high)].into_iter();
    let ends = ends.filter(|(with, _)| *with).map(|(_, end)| end.clone());
    let size = |value: &Rational| (value.denominator(), value.numerator());
    let inside = simplest_between(low, high);
    ends.fold(inside, |best, end| if size(&end) < size(&best) { end } else { best })
}

/// The same strictly between two numbers that are not negative.
pub(super) fn simplest_between(low: &Rational, high: &Rational) -> Rational {
    let whole = low.floor();
    let next = Rational::from(&whole + Integer::one());
    if next < *high {
        return next;
    }
    // low = whole + 1/x and high = whole + 1/y with y < x: the simplest is whole
    // plus the reciprocal of the simplest between y and x.
    let whole = Rational::from(whole);
    let (below, above) = (low - &whole, high - &whole);
    let y = above.recip();
    let inner = if below.is_zero() {
        // Anything greater than y will do.
        Rational::from(y.floor() + Integer::one())
    } else {
        simplest_between(&y, &below.recip())
    };
    whole + inner.recip()
}
