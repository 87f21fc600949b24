//! Printed numbers that agree with the printed text for one cause: up to one factor, or one summand.

use crate::claim::Printed;
use crate::exact::{Integer, Rational, RealCyclotomic};
use std::collections::BTreeSet;

/// The fewest cells that one factor or summand connects.
const LEAST_CELLS: usize = 3;

/// The fewest units of the last place of a number that a constant connects with others.
const LEAST_UNITS: i64 = 10;

/// An irrational value is cut to a multiple of 2^−64, or of the first of 2^−128, 2^−256, … of which it has this many.
const LEAST_MULTIPLE: u64 = 1 << 63;

/// The binary digits of the smallest unit to which a value is cut.
const MAX_BITS: u32 = 1_024;

/// A printed number, its place, and its value by the printed text.
pub(crate) struct Known<'k> {
    pub(crate) place: (usize, usize),
    pub(crate) printed: &'k Printed,
    pub(crate) value: Option<&'k RealCyclotomic>,
}

/// Two ends, the lesser first.
type Interval = (Rational, Rational);

/// Sets of these cells, by their places in the list, that a factor K or a summand D connects: K·v, or v + D, is less than
/// a unit of the last place from what is printed, for the value v of each cell by the printed text. In every row, every
/// column and in the whole table, it is the K that does this for most cells, at least for three. A cell whose number
/// is less than a unit from v itself is in none of them.
///
/// If a table was computed with another constant, and by the printed text otherwise, these cells tell one number: the
/// constant (`proofs/THEOREMS.md`, 51).
pub(crate) fn connected(cells: &[Known<'_>]) -> Vec<Vec<usize>> {
    let (mut factors, mut summands) = (Vec::new(), Vec::new());
    for (at, cell) in cells.iter().enumerate() {
        let Some(value) = far(cell) else { continue };
        let (shown, unit) = (cell.printed.decimal.value(), cell.printed.decimal.unit());
        let (low, high) = (&shown - &unit, shown + unit);
        if value.sign() != 0 {
            let (one, other) = (&low / &value, &high / &value);
            factors.push((at, if value.sign() > 0 { (one, other) } else { (other, one) }));
        }
        summands.push((at, (low - &value, high - value)));
    }
    let mut sets = Vec::new();
    for intervals in [factors, summands] {
        let place = |at: usize| cells[at].place;
        let rows: BTreeSet<usize> = intervals.iter().map(|(at, _)| place(*at).0).collect();
        let columns: BTreeSet<usize> = intervals.iter().map(|(at, _)| place(*at).1).collect();
        let of = |holds: &dyn Fn((usize, usize)) -> bool| {
            let inside = intervals.iter().filter(|(at, _)| holds(place(*at)));
            meeting(&inside.collect::<Vec<_>>())
        };
        sets.extend(rows.into_iter().map(|row| of(&|place| place.0 == row)));
        sets.extend(columns.into_iter().map(|column| of(&|place| place.1 == column)));
        sets.push(of(&|_| true));
    }
    sets.retain(|set| set.len() >= LEAST_CELLS);
    sets
}

/// The value of a cell, unless the printed number is less than a unit from it, or less than ten units: then many constants
/// suit it.
fn far(cell: &Known<'_>) -> Option<Rational> {
    let value = cut(cell.value?)?;
    let decimal = &cell.printed.decimal;
    let off = (decimal.value() - &value).abs();
    let least = decimal.unit() * Rational::from(LEAST_UNITS);
    (least <= decimal.value().abs() && !off.is_zero() && off >= decimal.unit()).then_some(value)
}

/// A value, cut to a rational number if it is none.
fn cut(value: &RealCyclotomic) -> Option<Rational> {
    if let Some(value) = value.as_rational() {
        return Some(value.clone());
    }
    let mut bits = 64;
    while bits <= MAX_BITS {
        let unit = Integer::one().shifted_left(bits);
        let times = &value.abs() * &RealCyclotomic::from(Rational::from(unit.clone()));
        let multiple = times.floor();
        if multiple >= Integer::from_words(&[LEAST_MULTIPLE]) {
            let size = Rational::new(multiple, unit);
            return Some(if value.sign() < 0 { -size } else { size });
        }
        bits *= 2;
    }
    None
}

/// The most intervals that have a number in common; of several such sets the one with the least number.
fn meeting(intervals: &[&(usize, Interval)]) -> Vec<usize> {
    let (mut lows, mut highs): (Vec<&Rational>, Vec<&Rational>) =
        intervals.iter().map(|(_, (low, high))| (low, high)).unzip();
    lows.sort_unstable();
    highs.sort_unstable();
    // Intervals that meet contain the greatest of their lower ends.
    let count = |x: &Rational| {
        lows.partition_point(|low| *low <= x) - highs.partition_point(|high| *high < x)
    };
    let mut best = None;
    for low in &lows {
        let count = count(low);
        if best.is_none_or(|(most, _)| count > most) {
            best = Some((count, *low));
        }
    }
    let Some((_, x)) = best else { return Vec::new() };
    let holds = |(_, (low, high)): &&&(usize, Interval)| low <= x && x <= high;
    intervals.iter().filter(holds).map(|(at, _)| *at).collect()
}
