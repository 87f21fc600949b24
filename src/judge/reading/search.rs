//! The search for the reading that explains most cells of a table.

use crate::claim::Printed;
use crate::evaluation::table::Evaluator;
use crate::exact::{Integer, Rational};
use crate::finding::{CellFinding, CellKind, Explanation, Need, Search, Sibling};
use crate::judge::reading::chance::{chance, is_small, of_decimal, of_depth};
use crate::judge::reading::space::{Space, printed};
use crate::judge::reading::{line, solve, tried};
use std::cmp::{Ordering, Reverse};

/// Searches the family for the readings of some cells of a table whose cells as printed are
/// `findings`: what was found, unless every cell is as printed, and what the cells
/// need; `None` when none of them is printed.
pub(crate) fn search(
    judge: &Evaluator<'_>,
    siblings: &[Sibling],
    findings: &[Vec<CellFinding>],
    kind: CellKind,
) -> Option<(Option<Search>, Vec<Need>)> {
    let printed = printed(judge, findings, kind);
    let cells: Vec<&Printed> = printed.iter().flatten().flatten().copied().collect();
    let space = Space::new(judge, siblings, findings, &printed)?;
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
pub(crate) fn scale(judge: &Evaluator<'_>, findings: &[Vec<CellFinding>]) -> Option<String> {
    let printed = printed(judge, findings, CellKind::Plain);
    let scale = Space::new(judge, &[], findings, &printed)?.scale.filter(|scale| scale.stated);
    scale.map(|scale| scale.name)
}

/// Every reading of some cells of the table with what it explains, the best first.
pub(crate) fn readings(
    judge: &Evaluator<'_>,
    siblings: &[Sibling],
    findings: &[Vec<CellFinding>],
    kind: CellKind,
) -> Vec<Explanation> {
    let printed = printed(judge, findings, kind);
    let Some(space) = Space::new(judge, siblings, findings, &printed) else { return Vec::new() };
    let all = space.evaluated();
    let mut explanations: Vec<Explanation> =
        space.explanations(&all, |one| one.values.clone()).collect();
    explanations.extend(solve::solve(&space, &all, &tried::best(&explanations)).explanations);
    explanations.sort_by_key(|explanation| Reverse(explanation.rank()));
    explanations
}
