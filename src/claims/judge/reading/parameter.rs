//! Solving for a parameter of the scheme that the paper does not state.
//!
//! Under a reading a cell is a piecewise polynomial function of the parameter. The parameters at
//! which it rounds to what is printed are therefore a union of intervals with algebraic ends. For
//! the first few cells these intervals are found on the whole range. They are short, and in each of
//! them the other cells are added one by one.

use crate::claim::Printed;
use crate::evaluation::context::CellReading;
use crate::evaluation::parametric;
use crate::evaluation::settings::Settings;
use crate::exact::{
    Enclosed, Integer, Interval, IntervalSet, PiecewisePolynomial, Rational, RealAlgebraic,
};
use crate::finding::{Explanation, Solved};
use crate::judge::reading::consistent::DecimalRounding;
use crate::judge::reading::plain::{height, plainest_between};
use crate::judge::reading::space::{Change, ReadingSpace};
use std::ops::Bound;

/// An unstated parameter of a scheme is searched from −10 to 10.
pub(crate) const RANGE: i64 = 10;

/// The most intervals that are followed from one cell under one reading.
const MAX_INTERVALS: usize = 64;

/// Solves for the unknown parameter under each reading, with the other parameters at their values.
/// Finds nothing for tables of depths, if the values are proportional to the parameter, or if the
/// formula is no function of it that is computed.
pub(crate) fn search(
    space: &ReadingSpace<'_>,
    readings: &[Vec<Change>],
    least: usize,
) -> Vec<Explanation> {
    let mut found = Vec::new();
    let solvable =
        !space.is_depth() && space.scale.is_none() && parametric::is_function(space.judge);
    let Some(name) = space.unknown.filter(|_| solvable) else { return found };
    for reading in readings {
        let settings = space.settings(reading);
        let unknown = Unknown::new(space, &settings, name);
        for rounding in space.roundings(reading) {
            let solutions = unknown.solutions(rounding, least);
            let explanations =
                solutions.iter().filter_map(|one| unknown.explanation(one, reading, rounding));
            found.extend(explanations);
        }
    }
    let most = found.iter().map(Explanation::count).max();
    found.retain(|explanation| Some(explanation.count()) == most);
    let least = found.iter().map(cost).min();
    found.retain(|explanation| Some(cost(explanation)) == least);
    found
}

/// The cost of a reading: one for each digit of the solved parameter, and one for each difference,
/// since a difference is one of about ten. A simple number with decimals cut is likelier than
/// 15169/12641 with decimals rounded.
fn cost(explanation: &Explanation) -> usize {
    let digits = |solved: &Solved| {
        let Solved { simplest, .. } = solved;
        let digits = |part: Integer| part.abs().to_string().trim_end_matches('0').len().max(1);
        digits(simplest.numerator()) + digits(simplest.denominator())
    };
    explanation.differences.len() + explanation.solved.iter().map(digits).sum::<usize>()
}

struct PrintedCell<'s> {
    row: usize,
    column: usize,
    printed: &'s Printed,
}

/// A parameter under one reading.
struct Unknown<'s> {
    space: &'s ReadingSpace<'s>,
    settings: &'s Settings,
    name: &'s str,
    cells: Vec<PrintedCell<'s>>,
    /// The first cells as functions on the whole range.
    first: Vec<Option<PiecewisePolynomial>>,
}

impl<'s> Unknown<'s> {
    fn new(space: &'s ReadingSpace<'s>, settings: &'s Settings, name: &'s str) -> Unknown<'s> {
        let mut cells = Vec::new();
        for (row, line) in space.printed.iter().enumerate() {
            let line = line.iter().enumerate();
            cells.extend(line.filter_map(|(column, printed)| {
                Some(PrintedCell { row, column, printed: (*printed)? })
            }));
        }
        let mut unknown = Unknown { space, settings, name, cells, first: Vec::new() };
        // So many that at least one of them is right if at most a quarter of all cells is wrong.
        let count = (unknown.cells.len() / 4 + 1).max(2).min(unknown.cells.len());
        let whole = (Rational::from(-RANGE), Rational::from(RANGE));
        let function = |cell: &PrintedCell<'s>| {
            unknown.function(cell, &whole).filter(|function| function.as_constant().is_none())
        };
        let first = unknown.cells[..count].iter().map(function).collect();
        unknown.first = first;
        unknown
    }

    /// The value of a cell as a function of the parameter in a window.
    fn function(
        &self,
        cell: &PrintedCell<'_>,
        window: &(Rational, Rational),
    ) -> Option<PiecewisePolynomial> {
        let at = self.at(cell, self.settings);
        parametric::of_cell(self.space.judge, at, self.name, window)
    }

    fn at<'n>(&'n self, cell: &PrintedCell<'_>, settings: &'n Settings) -> CellReading<'n> {
        self.space.at(cell.row, cell.column, settings)
    }

    /// The intervals of the parameter on which most cells round to what is printed, at
    /// least `least`.
    fn solutions(&self, rounding: DecimalRounding, least: usize) -> Vec<Interval> {
        let range = Interval {
            low: Bound::Included(Rational::from(-RANGE).into()),
            high: Bound::Included(Rational::from(RANGE).into()),
        };
        let range = IntervalSet::from(range);
        let (mut best, mut most) = (Vec::new(), least);
        for (seed, function) in self.first.iter().enumerate() {
            let Some(function) = function else { continue };
            let cell = &self.cells[seed];
            let set = range.intersection(&consistent(function, cell.printed, rounding));
            for interval in set.intervals().iter().take(MAX_INTERVALS) {
                if self.possible(seed, interval) < most {
                    continue;
                }
                for (interval, count) in self.agreeing(seed, interval.clone(), rounding, most) {
                    if count > most {
                        best.clear();
                        most = count;
                    }
                    if count == most && !best.contains(&interval) {
                        best.push(interval);
                    }
                }
            }
        }
        best
    }

    /// An estimate of how many cells may round to what is printed somewhere in a short interval,
    /// from their values at its ends.
    fn possible(&self, seed: usize, interval: &Interval) -> usize {
        let (low, high) = bounds(interval);
        let mut possible = 0;
        for (place, cell) in self.cells.iter().enumerate() {
            let values = [&low, &high].map(|end| self.value(cell, end));
            let [Some(a), Some(b)] = values else { continue };
            let slack = (&a - &b).abs() + cell.printed.decimal.unit();
            let shown = cell.printed.decimal.value();
            let near = (&a - &shown).abs().min((&b - &shown).abs()) <= slack;
            possible += usize::from(place == seed || near);
        }
        possible
    }

    /// The value of a cell at one value of the parameter.
    fn value(&self, cell: &PrintedCell<'_>, parameter: &Rational) -> Option<Rational> {
        let settings = self.settings.with_parameter(self.name, parameter);
        self.space.value(self.at(cell, &settings))?.as_rational().cloned()
    }

    /// The parts of an interval in which the seed and as many other cells as possible, taken in
    /// turn, round to what is printed, each with the number of these cells.
    fn agreeing(
        &self,
        seed: usize,
        interval: Interval,
        rounding: DecimalRounding,
        least: usize,
    ) -> Vec<(Interval, usize)> {
        let mut found = Vec::new();
        let mut stack = vec![(interval, 0, 1)];
        while let Some((interval, place, count)) = stack.pop() {
            let Some(cell) = self.cells.get(place) else {
                found.push((interval, count));
                continue;
            };
            if place == seed {
                stack.push((interval, place + 1, count));
                continue;
            }
            let function = self.function(cell, &bounds(&interval));
            let set = function.map(|function| consistent(&function, cell.printed, rounding));
            let set = set.unwrap_or_default().intersection(&IntervalSet::from(interval.clone()));
            let left = self.cells.len() - place - 1 - usize::from(seed > place);
            if set.is_empty() && count + left >= least {
                stack.push((interval, place + 1, count));
            } else if found.len() + stack.len() + set.intervals().len() <= MAX_INTERVALS {
                let parts = set.intervals().iter().cloned();
                stack.extend(parts.map(|part| (part, place + 1, count + 1)));
            }
        }
        found
    }

    /// The reading with the parameter at the plainest number of the interval, and what it explains.
    fn explanation(
        &self,
        interval: &Interval,
        reading: &[Change],
        rounding: DecimalRounding,
    ) -> Option<Explanation> {
        let simplest = plainest_in(interval)?;
        let settings = self.settings.with_parameter(self.name, &simplest);
        let values = self.space.values(&settings);
        let explained = self.space.explained(&values, rounding);
        let changes = reading.iter().map(|change| self.space.difference(change));
        let differences = changes.chain(rounding.difference()).collect();
        let solved = Solved { name: self.name.to_owned(), between: bounds(interval), simplest };
        Some(Explanation { differences, solved: vec![solved], values, explained })
    }
}

/// Rational numbers that enclose the interval, at most 2^−64 away from its ends.
fn bounds(interval: &Interval) -> (Rational, Rational) {
    let low = end(&interval.low).map(|end| end.enclosure(0).lower().clone());
    let high = end(&interval.high).map(|end| end.enclosure(0).upper().clone());
    let range = Rational::from(RANGE);
    (low.unwrap_or_else(|| -&range), high.unwrap_or(range))
}

fn end(bound: &Bound<RealAlgebraic>) -> Option<&RealAlgebraic> {
    match bound {
        Bound::Unbounded => None,
        Bound::Included(end) | Bound::Excluded(end) => Some(end),
    }
}

/// The parameters at which the value of the function rounds to the printed number.
fn consistent(
    function: &PiecewisePolynomial,
    printed: &Printed,
    rounding: DecimalRounding,
) -> IntervalSet {
    let (value, unit) = (printed.decimal.value(), printed.decimal.unit());
    let towards = match value.sign() {
        -1 => function.scaled(&-Rational::one()),
        0 => function.magnitude(),
        _ => function.clone(),
    };
    let (shown, half) = (value.abs(), &unit / Rational::from(2));
    let away = towards.scaled(&-Rational::one());
    let (below, above) = match rounding {
        // Nothing was rounded to a fraction.
        _ if printed.decimal.is_fraction() => (towards.at_most(&shown), away.at_most(&-shown)),
        DecimalRounding::Nearest => {
            (towards.at_most(&(&shown + &half)), away.at_most(&(half - shown)))
        }
        DecimalRounding::Cut => (towards.below(&(&shown + unit)), away.at_most(&-shown)),
        DecimalRounding::Away if printed.decimal.is_one_unit() => {
            (towards.at_most(&shown), away.at_most(&-half))
        }
        DecimalRounding::Away => (towards.at_most(&shown), away.below(&(unit - shown))),
    };
    below.intersection(&above)
}

/// The plainest number in an interval; `None` if the interval is one irrational number.
fn plainest_in(interval: &Interval) -> Option<Rational> {
    let own = [&interval.low, &interval.high].into_iter().filter_map(|bound| match bound {
        Bound::Included(end) => end.as_rational().cloned(),
        _ => None,
    });
    // Bounds inside, for irrational ends.
    let low = end(&interval.low).map(|end| end.enclosure(0).upper().clone())?;
    let high = end(&interval.high).map(|end| end.enclosure(0).lower().clone())?;
    let inside = (low < high).then(|| plainest_between(&low, &high));
    own.chain(inside).min_by_key(height)
}
