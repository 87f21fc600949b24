//! The search for the reading that explains most cells of a table.

use super::chance::{chance, is_small, of_decimal, of_depth};
use super::line::{self, LineReading};
use super::needs::Need;
use super::scale::Solved;
use super::solve;
use super::space::{PrintedCells, Space};
use super::tried;
use crate::audit::finding::CellFinding;
use crate::audit::judge::Judge;
use crate::claim::{Cell, Printed};
use crate::exact::{Integer, Rational, RealCyclotomic};
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
    /// The value, where the choice is that of a parameter.
    pub value: Option<Rational>,
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
    pub(super) fn rank(&self) -> (usize, Reverse<usize>) {
        (self.count(), Reverse(self.differences.len()))
    }
}

/// What a search has found.
#[derive(Clone, Debug)]
pub struct Search {
    /// How many readings were compared, every scale that someone would choose counted.
    pub tried: usize,
    /// What they differ in.
    pub choices: Vec<String>,
    /// How many cells are printed.
    pub cells: usize,
    /// How many cells the printed definition explains.
    pub as_printed: usize,
    /// How many cells the best of the readings explain, be it by luck.
    pub most: usize,
    /// The readings that explain most cells, with the fewest differences; empty when
    /// none explains more than the printed definition, or luck could.
    pub best: Vec<Explanation>,
    /// How many readings would do as well as those that explain most on unrelated
    /// numbers, at most.
    pub chance: Rational,
    /// The readings of rows and columns for the cells that `best` leaves.
    pub lines: Vec<LineReading>,
}

/// Searches the family for the readings of some cells of a table whose cells as printed are
/// `findings`: what was found, unless every cell is as printed, and what the cells
/// need; `None` when none of them is printed.
pub(in crate::audit) fn search(
    judge: &Judge<'_>,
    findings: &[Vec<CellFinding>],
    kind: CellKind,
) -> Option<(Option<Search>, Vec<Need>)> {
    let printed = printed(judge, findings, kind);
    let cells: Vec<&Printed> = printed.iter().flatten().flatten().copied().collect();
    let space = Space::new(judge, findings, &printed)?;
    let as_printed = space.explained_as_printed();
    let count = as_printed.iter().flatten().filter(|explained| **explained).count();
    let all = space.evaluated();
    let explanations: Vec<Explanation> =
        space.explanations(&all, |one| one.values.clone()).collect();
    let needs = space.needs(&explanations);
    if count == cells.len() {
        return Some((None, needs));
    }
    let mut best = tried::best(&explanations);
    let likelihood =
        |printed: &Printed| if space.is_depth() { of_depth() } else { of_decimal(printed) };
    let solved = solve::solve(&space, &all, &best);
    let tried = space.count(&all) + solved.tried;
    for explanation in solved.explanations {
        solve::drop_unsolved(&mut best, &explanation);
        keep_best(&mut best, explanation);
    }
    let most = best.first().map_or(0, Explanation::count);
    let free = best.first().map_or(0, |first| space.free(first));
    // What the printed text gives without assumptions tells nothing for another reading.
    let given = as_printed.iter().flatten().zip(findings.iter().flatten());
    let given = given.map(|(explained, finding)| *explained && finding.assumed.is_empty());
    let others = printed.iter().flatten().zip(given).filter(|(_, given)| !given);
    let others: Vec<Rational> = others.filter_map(|(cell, _)| cell.map(likelihood)).collect();
    let beyond = most.saturating_sub(cells.len() - others.len() + free);
    let chance = chance(&others, beyond, solved.candidates + Integer::from(tried));
    if most <= count || !is_small(&chance) {
        best.clear();
    }
    let of_row = |row: &Vec<Option<&Printed>>| row.iter().map(|c| c.map(likelihood)).collect();
    let likelihoods: Vec<Vec<Option<Rational>>> = printed.iter().map(of_row).collect();
    let mut left: Vec<Vec<bool>> =
        printed.iter().map(|row| row.iter().map(Option::is_some).collect()).collect();
    for explained in best.first().map(|best| &best.explained).into_iter().chain([&as_printed]) {
        for (left, explained) in left.iter_mut().flatten().zip(explained.iter().flatten()) {
            *left &= !explained;
        }
    }
    let lines = line::search(&space, &all, &likelihoods, left);
    let mut choices = space.names();
    choices.extend(solve::names(&space));
    let (cells, as_printed) = (cells.len(), count);
    Some((Some(Search { tried, choices, cells, as_printed, most, best, chance, lines }), needs))
}

/// Adds an explanation to those that explain most, or puts it in their place.
fn keep_best(best: &mut Vec<Explanation>, explanation: Explanation) {
    match best.first().map(|first| first.rank().cmp(&explanation.rank())) {
        Some(Ordering::Greater) => {}
        Some(Ordering::Equal) => best.push(explanation),
        _ => *best = vec![explanation],
    }
}

/// The stated parameter that every value of the table is proportional to.
pub(in crate::audit) fn scale(judge: &Judge<'_>, findings: &[Vec<CellFinding>]) -> Option<String> {
    let printed = printed(judge, findings, CellKind::Plain);
    let scale = Space::new(judge, findings, &printed)?.scale.filter(|scale| scale.stated);
    scale.map(|scale| scale.name)
}

/// Every reading of some cells of the table with what it explains, the best first.
pub(in crate::audit) fn readings(
    judge: &Judge<'_>,
    findings: &[Vec<CellFinding>],
    kind: CellKind,
) -> Vec<Explanation> {
    let printed = printed(judge, findings, kind);
    let Some(space) = Space::new(judge, findings, &printed) else { return Vec::new() };
    let all = space.evaluated();
    let mut explanations: Vec<Explanation> =
        space.explanations(&all, |one| one.values.clone()).collect();
    explanations.extend(solve::solve(&space, &all, &tried::best(&explanations)).explanations);
    explanations.sort_by_key(|explanation| Reverse(explanation.rank()));
    explanations
}

/// The printed cells of this kind.
pub(super) fn printed<'a>(
    judge: &Judge<'a>,
    findings: &[Vec<CellFinding>],
    kind: CellKind,
) -> PrintedCells<'a> {
    let cell = |(cell, finding): (&'a Cell, &CellFinding)| match cell {
        Cell::Printed(printed) if kind.holds(finding) => Some(printed),
        _ => None,
    };
    let rows = judge.table.cells.iter().zip(findings);
    rows.map(|(row, findings)| row.iter().zip(findings).map(cell).collect()).collect()
}

/// Which cells of a table are read together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CellKind {
    /// Those whose value as printed needs no assumption.
    Plain,
    /// Those that need one.
    Assumed,
}

impl CellKind {
    fn holds(self, finding: &CellFinding) -> bool {
        finding.assumed.is_empty() == (self == CellKind::Plain)
    }

    /// The kinds of the printed cells of a table.
    pub(in crate::audit) fn of(findings: &[Vec<CellFinding>]) -> Vec<CellKind> {
        let printed = || findings.iter().flatten().filter(|finding| finding.printed.is_some());
        let kinds = [CellKind::Plain, CellKind::Assumed].into_iter();
        kinds.filter(|kind| printed().any(|finding| kind.holds(finding))).collect()
    }
}
