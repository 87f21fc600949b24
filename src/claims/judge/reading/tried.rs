//! The readings of a table, with their values and the cells that they explain.

use crate::cap::Cap;
use crate::claim::{Cell, Paper, Table};
use crate::diagnostic::Diagnostic;
use crate::evaluation::context::{CellReading, Outcome};
use crate::evaluation::table::Evaluator;
use crate::evaluation::trace::LevelCall;
use crate::exact::Rational;
use crate::finding::{CellKind, Difference, Explanation, TableFinding, Uncomputed, Values};
use crate::judge::reading::consistent::DecimalRounding;
use crate::judge::reading::scale::{SIMPLE_NUMBERS, Scale};
use crate::judge::reading::space::{Change, ReadingSpace, needed, printed, takes_from_elsewhere};
use std::cell::OnceCell;
use std::collections::BTreeSet;

/// A reading with the exact values of the printed cells under it.
pub(crate) struct Evaluated {
    pub(crate) reading: Vec<Change>,
    pub(crate) values: Values,
    /// For depths, the call of `levels` whose result each value is, row by row.
    pub(crate) levels: Vec<Vec<Option<LevelCall>>>,
    /// The cells whose values were not computed, with the first reason.
    uncomputed: Option<(BTreeSet<(usize, usize)>, Cap)>,
    /// Whether the values are proportional to the scale, once this has been asked.
    scaled: OnceCell<bool>,
}

/// The number of parts of the families of a paper's tables. Each has the same share of the luck that is allowed.
pub(crate) fn parts(paper: &Paper) -> usize {
    let printed =
        |table: &&Table| table.cells.iter().flatten().any(|cell| matches!(cell, Cell::Printed(_)));
    2 * paper.tables.iter().filter(printed).count()
}

/// A part of the family: its readings, and the number of readings of this part and of the part
/// before.
pub(crate) struct Part<'p> {
    pub(crate) all: &'p [Evaluated],
    pub(crate) tried: usize,
}

impl ReadingSpace<'_> {
    /// Readings with their values.
    ///
    /// # Errors
    /// The error of an alternative of the claim file.
    pub(crate) fn evaluated(
        &self,
        readings: Vec<Vec<Change>>,
    ) -> Result<Vec<Evaluated>, Diagnostic> {
        readings.into_iter().map(|reading| self.evaluate(reading)).collect()
    }

    fn evaluate(&self, reading: Vec<Change>) -> Result<Evaluated, Diagnostic> {
        let settings = self.settings(&reading);
        let (mut values, mut levels) = (Values::new(), Vec::new());
        let mut uncomputed: Option<(BTreeSet<(usize, usize)>, Cap)> = None;
        for (row, printed) in self.printed.iter().enumerate() {
            let (mut of_row, mut levels_of_row) = (Vec::new(), Vec::new());
            for (column, printed) in printed.iter().enumerate() {
                let at = self.at(row, column, &settings);
                let found = match printed {
                    None => (None, None),
                    Some(_) => match self.outcome(&reading, at)? {
                        (Outcome::Value(value), call) => (Some(value), call),
                        (Outcome::BeyondCap(cap), _) => {
                            let known = uncomputed.get_or_insert_with(|| (BTreeSet::new(), cap));
                            known.0.insert((row, column));
                            (None, None)
                        }
                        (Outcome::Undefined(_) | Outcome::Unstated(_), _) => (None, None),
                    },
                };
                of_row.push(found.0);
                levels_of_row.push(found.1);
            }
            values.push(of_row);
            levels.push(levels_of_row);
        }
        Ok(Evaluated { reading, values, levels, uncomputed, scaled: OnceCell::new() })
    }

    /// The outcome of a cell under a reading. A formula that is wrong with alternatives alone is an
    /// error of the claim file; one that is wrong with a choice, or with a quantity from another
    /// place, has no value there.
    fn outcome(
        &self,
        reading: &[Change],
        at: CellReading<'_>,
    ) -> Result<(Outcome, Option<LevelCall>), Diagnostic> {
        let found = if self.is_depth() {
            self.judge.value_and_levels(at)
        } else {
            self.judge.evaluate(&self.judge.table.value, at).map(|outcome| (outcome, None))
        };
        found.or_else(|mut error| {
            if let Some(cap) = error.cap.take() {
                Ok((Outcome::BeyondCap(*cap), None))
            } else if reading.iter().all(|change| matches!(change, Change::Definition(_))) {
                Err(error)
            } else {
                Ok((Outcome::Undefined(error.message), None))
            }
        })
    }

    /// What the values that were not computed leave open, where this reading was taken, or else the
    /// printed text, which explains so many cells.
    pub(crate) fn uncomputed(
        &self,
        parts: &[Part<'_>],
        taken: Option<&Explanation>,
        as_printed: usize,
    ) -> Option<Uncomputed> {
        let open = parts.iter().flat_map(|part| part.all);
        let mut open = open.filter_map(|one| Some((one, one.uncomputed.as_ref()?))).peekable();
        // As a rule there are none, and then nothing is looked for.
        let (_, (_, cap)) = open.peek()?;
        let mut found = Uncomputed { cap: cap.clone(), cells: BTreeSet::new(), overtakes: false };
        let count = taken.map_or(as_printed, Explanation::count);
        let taken = taken.map_or(&[][..], |taken| &taken.differences);
        let taken = reading(self, taken).map(|(changes, _)| self.differences(&changes));
        for (one, (cells, _)) in open {
            found.cells.extend(cells);
            let explanations = self.all_explanations(std::slice::from_ref(one));
            let most = explanations.iter().map(Explanation::count).max().unwrap_or(0);
            let is_taken = taken.as_ref().is_some_and(|own| *own == self.differences(&one.reading));
            found.overtakes |= !is_taken && most + cells.len() > count;
        }
        Some(found)
    }

    /// The number of readings that these stand for: with each rounding of the decimals, and with
    /// each simple scale besides the stated one. A reading that takes a quantity from elsewhere has
    /// no other scale.
    pub(crate) fn count(&self, all: &[Evaluated]) -> usize {
        let scales = match &self.scale {
            Some(scale) => usize::from(scale.stated) + SIMPLE_NUMBERS,
            None => 1,
        };
        let of = |one: &Evaluated| {
            let scales = if takes_from_elsewhere(&one.reading) { 1 } else { scales };
            scales * self.roundings(&one.reading).len()
        };
        all.iter().map(of).sum()
    }

    /// The explanations by each of these readings, with each rounding of the decimals; `values`
    /// gives the values of a reading.
    pub(crate) fn explanations<'v>(
        &'v self,
        all: &'v [Evaluated],
        values: impl Fn(&Evaluated) -> Values + 'v,
    ) -> impl Iterator<Item = Explanation> + 'v {
        all.iter().flat_map(move |one| {
            let values = values(one);
            let roundings = self.roundings(&one.reading);
            let proportional = |scale: &Scale| {
                let is_scale = || self.is_scale(scale, &one.values, &self.settings(&one.reading));
                !takes_from_elsewhere(&one.reading) && *one.scaled.get_or_init(is_scale)
            };
            let explain = |rounding| self.explain(&one.reading, rounding, &values, &proportional);
            roundings.into_iter().flat_map(explain).collect::<Vec<Explanation>>()
        })
    }

    /// As [`ReadingSpace::explanations`], with the values of these readings themselves.
    pub(crate) fn all_explanations(&self, all: &[Evaluated]) -> Vec<Explanation> {
        self.explanations(all, |one| one.values.clone()).collect()
    }
}

/// How many of the cells that a reading explains it still explains at another value of a parameter;
/// without a reading, the printed text is meant.
pub(crate) fn remaining(
    judge: &Evaluator<'_>,
    finding: &TableFinding<'_>,
    by: Option<&Explanation>,
    name: &str,
    value: &Rational,
) -> usize {
    let cells = &finding.cells;
    let left = CellKind::of(cells).into_iter().map(|kind| {
        let printed = printed(judge, cells, kind);
        ReadingSpace::new(judge, needed(cells), &printed, None)
            .map_or(0, |space| of_cells(&space, by, name, value))
    });
    left.sum()
}

/// As [`remaining`], for the cells of one kind.
fn of_cells(
    space: &ReadingSpace<'_>,
    by: Option<&Explanation>,
    name: &str,
    value: &Rational,
) -> usize {
    let differences = by.map_or(&[][..], |by| &by.differences);
    let Some((reading, rounding)) = reading(space, differences) else { return 0 };
    let mut settings = space.settings(&reading);
    settings.parameters.insert(name.to_owned(), value.clone());
    let now = space.explained(&space.values(&settings), rounding);
    let before = |row: usize, column: usize| by.is_none_or(|by| by.explained[row][column]);
    let cells = now.iter().enumerate().flat_map(|(row, cells)| {
        cells.iter().enumerate().filter(move |(column, now)| **now && before(row, *column))
    });
    cells.count()
}

/// The reading with these differences, and its rounding of decimals.
fn reading(
    space: &ReadingSpace<'_>,
    differences: &[Difference],
) -> Option<(Vec<Change>, DecimalRounding)> {
    let named = |difference: &Difference| differences.contains(difference);
    let changes = |reading: &Vec<Change>| {
        let own = reading.iter().map(|change| space.difference(change));
        own.filter(named).count() == reading.len()
    };
    // The longest of the readings whose changes are all among the differences.
    let readings = space.readings().into_iter().chain(space.copied_readings());
    let reading = readings.filter(changes).max_by_key(Vec::len)?;
    let roundings = DecimalRounding::ALL.into_iter().map(|(_, rounding)| rounding);
    let mut roundings =
        roundings.filter(|rounding| rounding.difference().is_some_and(|d| named(&d)));
    Some((reading, roundings.next().unwrap_or(DecimalRounding::Nearest)))
}

/// Of the cells that need a parameter, for each by row whether the reading gives it and its number tells something of
/// the parameter's value, or whether the reading does not give it; `None` for the others. A number tells something if
/// the reading does not give it at one of a few other values.
pub(crate) fn telling(
    space: &ReadingSpace<'_>,
    by: &Explanation,
    name: &str,
) -> Vec<Vec<Option<bool>>> {
    let row = |row: usize| {
        let cell = |column: usize| {
            let needs = space.printed[row][column].is_some() && space.needs_name(row, column, name);
            (needs && !by.explained[row][column]).then_some(false)
        };
        (0..space.printed[row].len()).map(cell).collect()
    };
    let mut all: Vec<Vec<Option<bool>>> = (0..space.printed.len()).map(row).collect();
    let (Some(value), Some((reading, rounding))) =
        (space.judge.assumed.get(name), reading(space, &by.differences))
    else {
        return all;
    };
    for probe in probes(value) {
        let mut settings = space.settings(&reading);
        settings.parameters.insert(name.to_owned(), probe);
        for (row, cells) in all.iter_mut().enumerate() {
            for (column, cell) in cells.iter_mut().enumerate() {
                let Some(printed) = space.printed[row][column] else { continue };
                if cell.is_some() || !space.needs_name(row, column, name) {
                    continue;
                }
                let value = space.value(space.at(row, column, &settings));
                if value.is_none_or(|value| !rounding.gives(&printed.decimal, &value)) {
                    *cell = Some(true);
                }
            }
        }
    }
    all
}

/// Other values of a parameter.
fn probes(value: &Rational) -> [Rational; 8] {
    let [one, two, ten] = [1, 2, 10].map(Rational::from);
    let near = [value + &one, value - &one, value + &one / &ten, value + &ten];
    let [a, b, c, d] = near;
    [a, b, c, d, value * &two, value / &two, value * &ten, value / &ten]
}

/// The explanations of most cells and, among these, those with the fewest differences.
pub(crate) fn best(explanations: &[Explanation]) -> Vec<Explanation> {
    let most = explanations.iter().map(Explanation::rank).max();
    explanations.iter().filter(|one| Some(one.rank()) == most).cloned().collect()
}

/// The explanations by readings that bring no constant.
pub(crate) fn by_choices(explanations: &[Explanation]) -> Vec<Explanation> {
    explanations.iter().filter(|one| !one.brings_constants()).cloned().collect()
}
