//! Solving for the scale of the data.

use crate::claim::Printed;
use crate::exact::{Enclosed, Integer, Rational, RealCyclotomic};
use crate::judge::reading::consistent::DecimalRounding;
use std::cmp::Reverse;

/// A parameter to which the values of a table are proportional.
pub(crate) struct Scale {
    pub(crate) name: String,
    /// Its stated or assumed value.
    pub(crate) base: Rational,
    pub(crate) stated: bool,
}

/// Two ends, the lesser first.
type Interval = (Rational, Rational);

/// The precision of the ends: enclosures of 128 binary digits.
const PRECISION: u32 = 1;

/// The simple number s > 0 for which s/base times the value rounds to the printed number in most
/// cells, and the ends of the interval of all s that do so in these cells.
pub(crate) fn solve(
    cells: &[(&Printed, &RealCyclotomic)],
    base: &Rational,
    rounding: DecimalRounding,
) -> Option<(Rational, Interval)> {
    let consistent = Consistent::new(cells, base, rounding);
    // A number printed as 0 does not determine a scale.
    let starts = consistent.intervals.iter().map(|(interval, _)| interval);
    let starts = starts.filter(|(low, _)| low.sign() > 0);
    let mut starts: Vec<(usize, &Interval)> =
        starts.map(|interval| (consistent.meeting(&interval.0), interval)).collect();
    // Intervals that have a point in common contain the greatest of their lower ends, or have it as
    // an end.
    starts.sort_by_key(|(count, _)| Reverse(*count));
    let size = |s: &Rational| Reverse((s.denominator(), s.numerator()));
    let mut best = None;
    for (meeting, interval) in starts {
        if best.as_ref().is_some_and(|((most, _), _)| meeting <= *most) {
            break;
        }
        // If the simplest number in an interval is not simple, no other number in it is.
        if !is_simple(&simplest(&interval.0, &interval.1)) {
            continue;
        }
        for s in simple_between(interval) {
            let rank = (consistent.at(&s), size(&s));
            if best.as_ref().is_none_or(|(known, _)| rank > *known) {
                best = Some((rank, s));
            }
        }
    }
    let (_, s) = best?;
    let around = consistent.around(&s)?;
    Some((s, around))
}

/// For each cell, the s for which s/base times its value rounds to what is printed, and whether the lower end is none of them.
struct Consistent {
    intervals: Vec<(Interval, bool)>,
    /// Their lower ends, each with whether it does not belong to the interval, and their upper ends,
    /// each in order.
    lows: Vec<(Rational, bool)>,
    highs: Vec<Rational>,
    rounding: DecimalRounding,
}

impl Consistent {
    fn new(
        cells: &[(&Printed, &RealCyclotomic)],
        base: &Rational,
        rounding: DecimalRounding,
    ) -> Consistent {
        let (mut intervals, mut lows, mut highs) = (Vec::new(), Vec::new(), Vec::new());
        for (printed, value) in cells {
            let Some((low, high)) = interval(printed, value, rounding) else { continue };
            let (low, high) = (low * base, high * base);
            let decimal = &printed.decimal;
            let is_closed = decimal.is_one_unit() || decimal.is_fraction();
            let is_open = rounding == DecimalRounding::Away && !is_closed;
            lows.push((low.clone(), is_open));
            highs.push(high.clone());
            intervals.push(((low, high), is_open));
        }
        lows.sort_unstable();
        highs.sort_unstable();
        Consistent { intervals, lows, highs, rounding }
    }

    /// How many intervals contain s or have it as an end: those that begin at s or before, less
    /// those that end before s.
    fn meeting(&self, s: &Rational) -> usize {
        self.lows.partition_point(|(low, _)| low <= s) - self.highs.partition_point(|high| high < s)
    }

    fn has_ended(&self, high: &Rational, s: &Rational) -> bool {
        high < s || high == s && self.rounding == DecimalRounding::Cut
    }

    /// How many intervals contain s, where it depends on the rounding which ends belong to them.
    fn at(&self, s: &Rational) -> usize {
        let begun = self.lows.partition_point(|(low, open)| has_begun((low, *open), s));
        begun - self.highs.partition_point(|high| self.has_ended(high, s))
    }

    /// The ends of the intersection of all intervals that contain s.
    fn around(&self, s: &Rational) -> Option<Interval> {
        let holds = |((low, high), open): &&(Interval, bool)| {
            has_begun((low, *open), s) && !self.has_ended(high, s)
        };
        let holding = || self.intervals.iter().filter(holds).map(|(interval, _)| interval);
        let low = holding().map(|(low, _)| low).max()?;
        let high = holding().map(|(_, high)| high).min()?;
        Some((low.clone(), high.clone()))
    }
}

fn has_begun((low, is_open): (&Rational, bool), s: &Rational) -> bool {
    low < s || low == s && !is_open
}

/// The s > 0 for which s·value rounds to what is printed.
fn interval(
    printed: &Printed,
    value: &RealCyclotomic,
    rounding: DecimalRounding,
) -> Option<Interval> {
    let (shown, unit) = (printed.decimal.value(), printed.decimal.unit());
    if value.sign() == 0 || shown.sign() == -value.sign() {
        return None;
    }
    let (shown, half) = (shown.abs(), &unit / Rational::from(2));
    let (low, high) = match rounding {
        DecimalRounding::Nearest => (&shown - &half, &shown + &half),
        DecimalRounding::Cut => (shown.clone(), &shown + &unit),
        DecimalRounding::Away if printed.decimal.is_one_unit() => (half, shown.clone()),
        DecimalRounding::Away => (&shown - &unit, shown.clone()),
    };
    let enclosure = value.abs().enclosure(PRECISION);
    if enclosure.lower().sign() <= 0 || high.sign() <= 0 {
        return None;
    }
    Some((low.max(Rational::zero()) / enclosure.upper(), high / enclosure.lower()))
}

/// The greatest numerator and denominator of a scale that someone would choose.
const MAX_SIMPLE: i64 = 100;

/// How many fractions in lowest terms these give.
pub(crate) const SIMPLE_NUMBERS: usize = 6_087;

/// Whether someone would choose this as the scale of data.
pub(crate) fn is_simple(scale: &Rational) -> bool {
    let most = Integer::from(MAX_SIMPLE);
    scale.numerator() <= most && scale.denominator() <= most
}

/// The simple numbers in an interval of positive numbers, its ends included, in lowest terms.
fn simple_between((low, high): &Interval) -> impl Iterator<Item = Rational> {
    (1..=MAX_SIMPLE).flat_map(move |denominator| {
        let over = Rational::from(denominator);
        let first = (low * &over).ceil().max(Integer::one());
        let last = (high * &over).floor().min(Integer::from(MAX_SIMPLE));
        let ends = first.to_i64().zip(last.to_i64());
        let (first, last) = ends.unwrap_or((1, 0));
        let numbers = (first..=last).map(move |numerator| Rational::new(numerator, denominator));
        numbers.filter(move |s| s.denominator() == Integer::from(denominator))
    })
}

/// The fraction of least denominator, and of these the least numerator, from `low` to `high`.
fn simplest(low: &Rational, high: &Rational) -> Rational {
    let size = |value: &Rational| (value.denominator(), value.numerator());
    let ends = [low.clone(), high.clone()].into_iter();
    let inside = (low < high).then(|| simplest_between(low, high));
    ends.chain(inside).min_by_key(size).unwrap_or_else(|| low.clone())
}

/// The fraction of least denominator, and of these the least numerator, strictly between
/// two numbers that are not negative.
pub(crate) fn simplest_between(low: &Rational, high: &Rational) -> Rational {
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
