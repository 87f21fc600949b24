//! The search for the reading that explains most cells of a table.

use super::chance::{chance, is_small, of_decimal, of_depth};
use super::choice::{Choice, Effect};
use super::choices::{DECIMAL_ROUNDING, FAMILY};
use super::consistent::DecimalRounding;
use super::scale::{Solved, simplest_between, solve};
use super::settings::Settings;
use crate::audit::finding::CellFinding;
use crate::audit::table::{At, Judge, Outcome};
use crate::claim::{Cell, Printed, Promise};
use crate::exact::{Rational, RealCyclotomic};
use crate::formula::{FreeNames, LocatedFormula};
use std::collections::{BTreeMap, BTreeSet};

/// The most differences from the printed text that a reading may have.
pub const MAX_DIFFERENCES: usize = 4;

/// The most readings of one table.
const MAX_READINGS: usize = 4_096;

/// A respect in which a reading differs from the printed text.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Difference {
    /// The choice, or the definition.
    pub choice: String,
    /// What holds instead of the printed text.
    pub says: String,
}

/// A reading that explains cells of a table.
#[derive(Clone, Debug)]
pub struct Explanation {
    /// Its differences from the printed text.
    pub differences: Vec<Difference>,
    /// The parameters that were solved for.
    pub solved: Vec<Solved>,
    /// The exact value of each cell, row by row, where there is one.
    pub values: Vec<Vec<Option<RealCyclotomic>>>,
    /// Which printed cells it explains.
    pub explained: Vec<Vec<bool>>,
}

impl Explanation {
    /// How many cells it explains.
    #[must_use]
    pub fn count(&self) -> usize {
        self.explained.iter().flatten().filter(|explained| **explained).count()
    }
}

/// What a search has found.
#[derive(Clone, Debug)]
pub struct Search {
    /// How many readings were compared.
    pub tried: usize,
    /// What they differ in.
    pub choices: Vec<String>,
    /// How many cells are printed.
    pub cells: usize,
    /// How many cells the printed definition explains.
    pub as_printed: usize,
    /// The readings that explain most cells, with the fewest differences; empty when
    /// none explains more than the printed definition, or luck could.
    pub best: Vec<Explanation>,
    /// How many readings would do as well on unrelated numbers, at most.
    pub chance: Rational,
}

/// A way of a choice other than the printed one.
#[derive(Clone)]
enum Change {
    Word(&'static Choice, &'static str, &'static str),
    Definition(usize),
}

/// Searches the family for the readings of a table whose cells as printed are
/// `findings`; `None` when every cell is as printed, or nothing is printed.
pub(in crate::audit) fn search(judge: &Judge<'_>, findings: &[Vec<CellFinding>]) -> Option<Search> {
    let printed = printed(judge);
    let cells: Vec<&Printed> = printed.iter().flatten().flatten().copied().collect();
    let space = Space::new(judge, findings, &printed)?;
    let as_printed = space.as_printed();
    if as_printed.count() == cells.len() {
        return None;
    }
    let readings = space.readings();
    let likelihood =
        |printed: &&Printed| if space.is_depth() { of_depth() } else { of_decimal(printed) };
    let likelihoods: Vec<Rational> = cells.iter().map(likelihood).collect();
    let (mut tried, mut best) = (0, Vec::<Explanation>::new());
    for reading in &readings {
        for explanation in space.explain(reading) {
            tried += 1;
            let rank = |e: &Explanation| (e.count(), MAX_DIFFERENCES + 1 - e.differences.len());
            match best.first().map(|first| rank(first).cmp(&rank(&explanation))) {
                Some(std::cmp::Ordering::Greater) => {}
                Some(std::cmp::Ordering::Equal) => best.push(explanation),
                _ => best = vec![explanation],
            }
        }
    }
    let explained = best.first().map_or(0, Explanation::count);
    let free = best.first().map_or(0, |first| first.solved.len());
    let chance = chance(&likelihoods, explained, free, tried);
    if explained <= as_printed.count() || !is_small(&chance) {
        best.clear();
    }
    let choices = space.names();
    Some(Search {
        tried,
        choices,
        cells: cells.len(),
        as_printed: as_printed.count(),
        best,
        chance,
    })
}

type PrintedCells<'a> = Vec<Vec<Option<&'a Printed>>>;

fn printed<'a>(judge: &Judge<'a>) -> PrintedCells<'a> {
    let cell = |cell: &'a Cell| match cell {
        Cell::Printed(printed) => Some(printed),
        Cell::Lost => None,
    };
    judge.table.cells.iter().map(|row| row.iter().map(cell).collect()).collect()
}

/// The readings of one table.
struct Space<'s> {
    judge: &'s Judge<'s>,
    printed: &'s PrintedCells<'s>,
    /// The parameters that have to be assumed, and the one among them that the
    /// values are proportional to.
    assume: BTreeSet<String>,
    scale: Option<String>,
    /// The definitions that do not depend on the column.
    row_definitions: Vec<String>,
    /// For each choice, the ways other than the printed one.
    changes: Vec<Vec<Change>>,
}

impl<'s> Space<'s> {
    fn new(
        judge: &'s Judge<'s>,
        findings: &[Vec<CellFinding>],
        printed: &'s PrintedCells<'s>,
    ) -> Option<Space<'s>> {
        let all = findings.iter().flatten().filter(|finding| finding.printed.is_some());
        let assume: BTreeSet<String> =
            all.flat_map(|finding| finding.assumed.iter().map(|(name, _)| name.clone())).collect();
        let settings = Settings::default();
        let (scale, row_definitions, changes) = Default::default();
        let mut space = Space { judge, printed, assume, scale, row_definitions, changes };
        space.row_definitions = space.find_row_definitions();
        space.values(&settings);
        let consulted = settings.consulted();
        for choice in FAMILY {
            let ways = choice.ways.iter();
            let ways: Vec<Change> = match choice.effect {
                Effect::Option { .. } => match consulted.get(choice.name) {
                    None => continue,
                    Some(printed) => ways
                        .filter(|way| way.word != printed)
                        .map(|way| Change::Word(choice, way.word, way.says))
                        .collect(),
                },
                Effect::Header if judge.has_tolerance_headers() => ways
                    .skip(1)
                    .map(|way| Change::Word(choice, way.word, way.says))
                    .collect(),
                // The roundings of decimals are compared on the same values.
                Effect::Header | Effect::Decimal => continue,
            };
            space.changes.push(ways);
        }
        let alternatives = &judge.paper.alternatives;
        let used = judge.definitions_used();
        let names: BTreeSet<&String> = alternatives.iter().map(|other| &other.of).collect();
        for name in names.into_iter().filter(|name| used.contains(*name)) {
            let ways = (0..alternatives.len()).filter(|&i| alternatives[i].of == *name);
            space.changes.push(ways.map(Change::Definition).collect());
        }
        space.scale = space.find_scale();
        printed.iter().flatten().any(Option::is_some).then_some(space)
    }

    fn is_depth(&self) -> bool {
        matches!(self.judge.table.promise, Some(Promise::Depth { .. }))
    }

    /// The names of what the readings differ in.
    fn names(&self) -> Vec<String> {
        let name = |ways: &Vec<Change>| match ways.first()? {
            Change::Word(choice, ..) => Some(choice.name.to_owned()),
            Change::Definition(i) => Some(self.judge.paper.alternatives[*i].of.clone()),
        };
        let mut names: Vec<String> = self.changes.iter().filter_map(name).collect();
        if !self.is_depth() {
            names.push(DECIMAL_ROUNDING.name.to_owned());
        }
        names
    }

    /// Every combination of at most [`MAX_DIFFERENCES`] changes, the printed text
    /// first.
    fn readings(&self) -> Vec<Vec<Change>> {
        let mut readings = vec![Vec::new()];
        for ways in &self.changes {
            let longer: Vec<Vec<Change>> = readings
                .iter()
                .filter(|reading| reading.len() < MAX_DIFFERENCES)
                .flat_map(|reading| {
                    ways.iter().map(|way| [reading.clone(), vec![way.clone()]].concat())
                })
                .collect();
            readings.extend(longer);
        }
        readings.sort_by_key(Vec::len);
        readings.truncate(MAX_READINGS);
        readings
    }

    fn settings(&self, reading: &[Change]) -> Settings {
        let words = reading.iter().filter_map(|change| match change {
            Change::Word(choice, word, _) => Some((choice.name, *word)),
            Change::Definition(_) => None,
        });
        let mut settings = Settings::new(words.collect());
        let alternatives = &self.judge.paper.alternatives;
        let replaced = reading.iter().filter_map(|change| match change {
            Change::Definition(i) => Some(&alternatives[*i]),
            Change::Word(..) => None,
        });
        for alternative in replaced {
            settings
                .definitions
                .get_or_insert_with(|| self.judge.paper.definitions.clone())
                .insert(alternative.of.clone(), alternative.value.clone());
        }
        settings
    }

    /// The exact values of the printed cells; where the formula has none under the
    /// reading, there is none.
    fn values(&self, settings: &Settings) -> Vec<Vec<Option<RealCyclotomic>>> {
        let value = |row: usize, column: usize, known: &BTreeMap<String, RealCyclotomic>| {
            self.printed[row][column]?;
            let at = At { row, column, assume: &self.assume, settings, known: Some(known) };
            self.value(&self.judge.table.value, at)
        };
        let rows = 0..self.printed.len();
        rows.map(|row| {
            let known = self.of_row(row, settings);
            (0..self.printed[row].len()).map(|column| value(row, column, &known)).collect()
        })
        .collect()
    }

    fn value(&self, formula: &LocatedFormula, at: At<'_>) -> Option<RealCyclotomic> {
        match self.judge.evaluate(formula, at) {
            Ok(Outcome::Value(value)) => Some(value),
            _ => None,
        }
    }

    /// The values of the definitions that do not depend on the column.
    fn of_row(&self, row: usize, settings: &Settings) -> BTreeMap<String, RealCyclotomic> {
        let definitions = settings.definitions.as_ref().unwrap_or(&self.judge.paper.definitions);
        let mut known = BTreeMap::new();
        for name in &self.row_definitions {
            let at = At { row, column: 0, assume: &self.assume, settings, known: Some(&known) };
            if let Some(value) = self.value(&definitions[name], at) {
                known.insert(name.clone(), value);
            }
        }
        known
    }

    /// The definitions that the formula uses and that depend on the row's parameter,
    /// stated and assumed ones alone, whichever alternative stands for a definition.
    fn find_row_definitions(&self) -> Vec<String> {
        let Judge { paper, table, given, assumed, .. } = self.judge;
        let mut definitions = paper.definitions.clone();
        let mut varying = BTreeSet::new();
        for readings in 0..=paper.alternatives.len() {
            if let Some(other) = readings.checked_sub(1).map(|i| &paper.alternatives[i]) {
                definitions.insert(other.of.clone(), other.value.clone());
            }
            let mut free = FreeNames::new(&definitions);
            let fixed = |name: &String| {
                table.rows.as_ref().is_some_and(|axis| axis.name == *name)
                    || given.contains_key(name)
                    || assumed.contains_key(name)
            };
            let depends = |name: &&String| !free.of_name(name).iter().all(fixed);
            varying.extend(definitions.keys().filter(depends).cloned().collect::<Vec<_>>());
        }
        let used = self.judge.definitions_used();
        used.into_iter().filter(|name| !varying.contains(name)).collect()
    }

    /// The only assumed parameter, if every value is proportional to it.
    fn find_scale(&self) -> Option<String> {
        let name = self.assume.first().filter(|_| self.assume.len() == 1)?;
        let assumed = self.judge.assumed.get(name)?;
        let mut double = Settings::default();
        double.parameters.insert(name.clone(), assumed + assumed);
        let (once, twice) = (self.values(&Settings::default()), self.values(&double));
        let pairs = once.iter().flatten().zip(twice.iter().flatten());
        let proportional = pairs.into_iter().all(|(once, twice)| match (once, twice) {
            (Some(once), Some(twice)) => &(once + once) == twice,
            (None, None) => true,
            _ => false,
        });
        proportional.then(|| name.clone())
    }

    fn as_printed(&self) -> Explanation {
        let values = self.values(&Settings::default());
        self.explanation(&[], None, values, None)
    }

    /// What a reading explains, for each rounding of the decimals and with the scale
    /// as it is assumed or solved for.
    fn explain(&self, reading: &[Change]) -> Vec<Explanation> {
        let values = self.values(&self.settings(reading));
        let roundings = DecimalRounding::ALL.into_iter().filter(|(word, _)| {
            word.is_none() || (!self.is_depth() && reading.len() < MAX_DIFFERENCES)
        });
        let mut found = Vec::new();
        for (word, rounding) in roundings {
            let solved = self.scale.as_ref().and_then(|name| self.solve(name, &values, rounding));
            found.push(self.explanation(reading, word, values.clone(), solved));
        }
        found
    }

    fn solve(
        &self,
        name: &str,
        values: &[Vec<Option<RealCyclotomic>>],
        rounding: DecimalRounding,
    ) -> Option<Solved> {
        let cells = self.printed.iter().flatten().zip(values.iter().flatten());
        let cells: Vec<(&Printed, &RealCyclotomic)> =
            cells.filter_map(|(printed, value)| Some(((*printed)?, value.as_ref()?))).collect();
        let (low, high) = solve(&cells, rounding)?;
        let assumed = self.judge.assumed.get(name)?;
        let between = (low * assumed, high * assumed);
        let simplest = simplest_between(&between.0, &between.1);
        Some(Solved { name: name.to_owned(), between, simplest })
    }

    fn explanation(
        &self,
        reading: &[Change],
        rounding: Option<&'static str>,
        mut values: Vec<Vec<Option<RealCyclotomic>>>,
        solved: Option<Solved>,
    ) -> Explanation {
        if let Some(solved) = &solved
            && let Some(assumed) = self.judge.assumed.get(&solved.name)
        {
            let factor = RealCyclotomic::from(&solved.simplest / assumed);
            for value in values.iter_mut().flatten().flatten() {
                *value = &*value * &factor;
            }
        }
        let way = DecimalRounding::ALL.into_iter().find(|(word, _)| *word == rounding);
        let way = way.map_or(DecimalRounding::Nearest, |(_, way)| way);
        let explained = self.printed.iter().zip(&values).map(|(printed, values)| {
            let pairs = printed.iter().zip(values);
            let gives = |(printed, value): (&Option<&Printed>, &Option<RealCyclotomic>)| {
                let (Some(printed), Some(value)) = (printed, value) else { return false };
                way.gives(&printed.decimal, value)
            };
            pairs.map(gives).collect()
        });
        let explained = explained.collect();
        let differences = reading.iter().map(|change| match change {
            Change::Word(choice, _, says) => {
                Difference { choice: choice.name.to_owned(), says: (*says).to_owned() }
            }
            Change::Definition(i) => {
                let other = &self.judge.paper.alternatives[*i];
                Difference { choice: other.of.clone(), says: other.label.clone() }
            }
        });
        let decimals = rounding.and_then(|word| {
            let way = DECIMAL_ROUNDING.ways.iter().find(|way| way.word == word)?;
            let choice = DECIMAL_ROUNDING.name.to_owned();
            Some(Difference { choice, says: way.says.to_owned() })
        });
        let differences = differences.chain(decimals).collect();
        Explanation { differences, solved: solved.into_iter().collect(), values, explained }
    }
}
