//! The search for the reading that explains most cells of a table.

use super::chance::{chance, is_small, of_decimal, of_depth};
use super::scale::Solved;
use super::space::{Change, PrintedCells, Space};
use crate::audit::finding::CellFinding;
use crate::audit::judge::Judge;
use crate::claim::{Cell, Printed};
use crate::exact::{Rational, RealCyclotomic};
use std::cmp::{Ordering, Reverse};

/// The most differences from the printed text that a reading may have.
pub const MAX_DIFFERENCES: usize = 4;

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

    /// How it differs from the printed text, in words.
    #[must_use]
    pub fn differs(&self) -> String {
        let differences = self.differences.iter().map(|difference| difference.says.clone());
        let solved = self.solved.iter().filter(|solved| {
            self.differences.iter().all(|difference| difference.choice != solved.name)
        });
        let solved = solved.map(|solved| format!("{} = {}", solved.name, solved.simplest));
        differences.chain(solved).collect::<Vec<String>>().join("; ")
    }

    /// The better, the more cells it explains, and of those the fewer differences.
    fn rank(&self) -> (usize, Reverse<usize>) {
        (self.count(), Reverse(self.differences.len()))
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

/// Searches the family for the readings of a table whose cells as printed are
/// `findings`; `None` when every cell is as printed, or nothing is printed.
pub(in crate::audit) fn search(judge: &Judge<'_>, findings: &[Vec<CellFinding>]) -> Option<Search> {
    let printed = printed(judge);
    let cells: Vec<&Printed> = printed.iter().flatten().flatten().copied().collect();
    let space = Space::new(judge, findings, &printed)?;
    let as_printed = space.explained_as_printed();
    if as_printed == cells.len() {
        return None;
    }
    let readings = space.readings();
    let likelihood =
        |printed: &&Printed| if space.is_depth() { of_depth() } else { of_decimal(printed) };
    let likelihoods: Vec<Rational> = cells.iter().map(likelihood).collect();
    let (mut tried, mut best) = (0, Vec::<Explanation>::new());
    for reading in &readings {
        let roundings = space.roundings(reading);
        let least = best.first().map_or(0, |first| least(first, reading));
        let Some(values) = space.values(&space.settings(reading), least) else {
            tried += roundings.len();
            continue;
        };
        let explanations =
            roundings.into_iter().flat_map(|rounding| space.explain(reading, rounding, &values));
        for explanation in explanations {
            tried += 1;
            match best.first().map(|first| first.rank().cmp(&explanation.rank())) {
                Some(Ordering::Greater) => {}
                Some(Ordering::Equal) => best.push(explanation),
                _ => best = vec![explanation],
            }
        }
    }
    let explained = best.first().map_or(0, Explanation::count);
    let free = best.first().map_or(0, |first| first.solved.len());
    let chance = chance(&likelihoods, explained, free, tried);
    if explained <= as_printed || !is_small(&chance) {
        best.clear();
    }
    let choices = space.names();
    Some(Search { tried, choices, cells: cells.len(), as_printed, best, chance })
}

/// How many cells a reading has to explain at least to be as good as another.
fn least(best: &Explanation, reading: &[Change]) -> usize {
    best.count() + usize::from(reading.len() > best.differences.len())
}

fn printed<'a>(judge: &Judge<'a>) -> PrintedCells<'a> {
    let cell = |cell: &'a Cell| match cell {
        Cell::Printed(printed) => Some(printed),
        Cell::Lost => None,
    };
    judge.table.cells.iter().map(|row| row.iter().map(cell).collect()).collect()
}
