//! The search for the reading that explains most cells of a table.

use crate::claim::Printed;
use crate::evaluation::table::Evaluator;
use crate::exact::{Integer, Rational};
use crate::finding::{COPIED, CellFinding, CellKind, Explanation, Need, Search};
use crate::judge::reading::chance::{chance, is_small, of_decimal, of_depth};
use crate::judge::reading::space::{Family, PrintedCells, Space, needed, printed};
use crate::judge::reading::tried::{PARTS, Part};
use crate::judge::reading::{line, tried};
use std::cmp::Reverse;
use std::collections::BTreeMap;

/// For each recovered parameter, the number of values from which its value was taken.
pub(crate) type Candidates = BTreeMap<String, Integer>;

/// Searches the family for readings of the cells of one kind, where `findings` are all cells of the
/// table as printed. Gives the search, or `None` for it if every cell is as printed and no
/// parameter was recovered, and what the cells need. The whole result is `None` if no cell of this
/// kind is printed, or if a parameter that they need has no value.
pub(crate) fn search(
    judge: &Evaluator<'_>,
    findings: &[Vec<CellFinding>],
    kind: CellKind,
    recovered: &Candidates,
    family: Family,
) -> Option<(Option<Search>, Vec<Need>)> {
    let printed = printed(judge, findings, kind);
    let cells: Vec<&Printed> = printed.iter().flatten().flatten().copied().collect();
    let space = Space::new(judge, needed(findings), &printed, None)?;
    if !space.assume.iter().all(|name| judge.assumed.contains_key(name)) {
        return None;
    }
    let as_printed = space.explained_as_printed();
    let count = as_printed.iter().flatten().filter(|explained| **explained).count();
    let plain = space.evaluated(space.readings());
    let explanations = space.all_explanations(&plain);
    let mut needs = space.needs(&explanations);
    let counts = space.assume.iter().filter_map(|name| recovered.get(name).cloned());
    let recovered = counts.reduce(|all, count| all * count);
    if count == cells.len() && recovered.is_none() {
        return Some((None, needs));
    }
    let likelihood =
        |printed: &Printed| if space.is_depth() { of_depth() } else { of_decimal(printed) };
    // The cells that the printed text gives without assumptions do not support another reading.
    let given = as_printed.iter().flatten().zip(findings.iter().flatten());
    let given = given.map(|(explained, finding)| *explained && finding.is_plain());
    let others = printed.iter().flatten().zip(given).filter(|(_, given)| !given);
    let others: Vec<Rational> = others.filter_map(|(cell, _)| cell.map(likelihood)).collect();
    let values = recovered.clone().unwrap_or_else(Integer::one);
    let least = if recovered.is_some() { 0 } else { count };
    let judged = |explanations: &[Explanation], tried: usize| {
        let best = tried::best(explanations);
        let most = best.first().map_or(0, Explanation::count);
        let beyond = most.saturating_sub(cells.len() - others.len());
        let chance = chance(&others, beyond, Integer::from(PARTS * tried) * &values);
        let best = if most > least && is_small(&chance) { best } else { Vec::new() };
        Found { best, most, chance }
    };
    let mut tried = space.count(&plain);
    let mut found = judged(&explanations, tried);
    let mut parts = vec![Part { all: &plain, tried }];
    let reached = |found: &Found| found.best.first().map_or(count, Explanation::count);
    let copied = if family == Family::Whole && reached(&found) < cells.len() {
        space.evaluated(space.copied_readings())
    } else {
        Vec::new()
    };
    if !copied.is_empty() {
        tried += space.count(&copied);
        parts.push(Part { all: &copied, tried });
        let explanations = space.all_explanations(&copied);
        let other = judged(&explanations, tried);
        if other.best.first().is_some_and(|best| best.count() > reached(&found)) {
            needs = space.needs(&explanations);
            found = other;
        } else if found.best.is_empty() && other.chance < found.chance {
            // The closest reading is reported, though it may be luck.
            found = Found { best: Vec::new(), ..other };
        }
    }
    let Found { best, most, chance } = found;
    let of_row = |row: &Vec<Option<&Printed>>| row.iter().map(|c| c.map(likelihood)).collect();
    let likelihoods: Vec<Vec<Option<Rational>>> = printed.iter().map(of_row).collect();
    let explained = best.first().map(|best| &best.explained).into_iter().chain([&as_printed]);
    let left = left(&printed, explained);
    let lines = line::search(&space, &parts, &likelihoods, left, &values);
    let mut choices = space.names();
    if !copied.is_empty() {
        choices.push(COPIED.to_owned());
    }
    let (cells, as_printed) = (cells.len(), count);
    let elsewhere = !copied.is_empty();
    let search = Search { tried, choices, elsewhere, cells, as_printed, most, best, chance, lines };
    Some((Some(search), needs))
}

/// The printed cells that no reading explains, by row.
fn left<'e>(
    printed: &PrintedCells<'_>,
    explained: impl Iterator<Item = &'e Vec<Vec<bool>>>,
) -> Vec<Vec<bool>> {
    let row = |row: &Vec<Option<&Printed>>| row.iter().map(Option::is_some).collect();
    let mut left: Vec<Vec<bool>> = printed.iter().map(row).collect();
    for explained in explained {
        for (left, explained) in left.iter_mut().flatten().zip(explained.iter().flatten()) {
            *left &= !explained;
        }
    }
    left
}

/// The best readings of a part.
struct Found {
    /// The readings that explain most; empty if they may be luck.
    best: Vec<Explanation>,
    most: usize,
    chance: Rational,
}

/// The stated parameter to which every value of the table is proportional.
pub(crate) fn scale(judge: &Evaluator<'_>, findings: &[Vec<CellFinding>]) -> Option<String> {
    let printed = printed(judge, findings, CellKind::Plain);
    let scale = Space::new(judge, needed(findings), &printed, None)?.scale;
    scale.filter(|scale| scale.stated).map(|scale| scale.name)
}

/// Every reading of the cells of one kind, with the cells that it explains, the best first. If
/// `elsewhere`, these include the readings that take a quantity from another place of the paper.
pub(crate) fn readings(
    judge: &Evaluator<'_>,
    findings: &[Vec<CellFinding>],
    kind: CellKind,
    elsewhere: bool,
) -> Vec<Explanation> {
    let printed = printed(judge, findings, kind);
    let Some(space) = Space::new(judge, needed(findings), &printed, None) else {
        return Vec::new();
    };
    let mut all = space.evaluated(space.readings());
    if elsewhere {
        all.extend(space.evaluated(space.copied_readings()));
    }
    let mut explanations = space.all_explanations(&all);
    explanations.sort_by_key(|explanation| Reverse(explanation.rank()));
    explanations
}
