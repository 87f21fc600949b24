//! Recovering a parameter that the paper does not state from the printed numbers of a table.

use crate::claim::{Cell, Paper, Table};
use crate::diagnostic::Diagnostic;
use crate::evaluation::library::Library;
use crate::evaluation::table::Evaluator;
use crate::exact::{Integer, Rational};
use crate::finding::{Explanation, Recovered, RecoveredFrom};
use crate::judge::reading::plain::as_plain;
use crate::judge::reading::space::{Change, Family, Needed, ReadingSpace};
use crate::judge::reading::{solve, tried};
use std::cmp::Reverse;
use std::collections::BTreeMap;

/// The value of the parameter at which the search begins. Where the values are proportional to the
/// parameter, or levels depend on it as on a spread, any value will do. For a parameter of a
/// scheme, most schemes converge at this value.
const START: (i64, i64) = (1, 100);

/// The value of an unstated parameter with which some reading gives most of the cells that need it,
/// with the other unstated parameters at these values; and the part of the family with that reading.
/// `None` where no reading depends on it in a way that can be solved.
pub(crate) fn solved(
    paper: &Paper,
    table: &Table,
    library: &Library<'_>,
    others: &BTreeMap<String, Rational>,
    name: &str,
) -> Result<Option<(Recovered, Family)>, Diagnostic> {
    let mut values = others.clone();
    values.insert(name.to_owned(), Rational::new(START.0, START.1));
    let judge = Evaluator::new(paper, table, library, &values)?;
    let needed = needed(&judge)?;
    let printed = table.cells.iter().zip(&needed).map(|(row, needed)| {
        let cells = row.iter().zip(needed);
        cells.map(|(cell, needed)| cell.printed().filter(|_| !needed.is_empty())).collect()
    });
    let printed = printed.collect();
    let Some(space) = ReadingSpace::new(&judge, needed, &printed, Some(name)) else {
        return Ok(None);
    };
    let cells = printed.iter().flatten().flatten().count();
    let mut best = None;
    // The same scheme with other numbers of its points is tried where nothing else gives half of the
    // cells.
    let count =
        |best: &Option<(Explanation, Family)>| best.as_ref().map_or(0, |best| best.0.count());
    for family in [Family::Plain, Family::InTurn] {
        if count(&best) * 2 >= cells {
            break;
        }
        let plain = family == Family::Plain;
        let readings = if plain { space.readings() } else { space.numbered_readings() };
        let found = best_of(&space, name, readings)?.map(|found| (found, family));
        if best.is_none() || count(&found) > count(&best) {
            best = found;
        }
    }
    let Some((best, family)) = best else { return Ok(None) };
    let Some(solved) = best.solved.iter().find(|solved| solved.name == name) else {
        return Ok(None);
    };
    let (low, high) = solved.between.clone();
    let from = RecoveredFrom::Solved(low, high);
    Ok(Some((Recovered { value: solved.simplest.clone(), from }, family)))
}

/// The best explanation by these readings that solves for the parameter; of equally good ones the
/// first.
fn best_of(
    space: &ReadingSpace<'_>,
    name: &str,
    readings: Vec<Vec<Change>>,
) -> Result<Option<Explanation>, Diagnostic> {
    let all = space.evaluated(readings)?;
    let mut explanations = space.all_explanations(&all);
    explanations.extend(solve::solve(space, &all, &tried::best(&explanations)));
    explanations.retain(|explanation| explanation.solved.iter().any(|one| one.name == name));
    Ok(explanations.into_iter().rev().max_by_key(rank))
}

/// The rank of an explanation: by the number of cells that it gives, then by how few candidates
/// there are. These are the values as plain as the solved one, times ten for each difference from
/// the printed text.
fn rank(explanation: &Explanation) -> (usize, Reverse<Integer>) {
    let differences = u32::try_from(explanation.differences.len()).unwrap_or(u32::MAX);
    let values = explanation.solved.iter().map(|solved| as_plain(&solved.simplest));
    let cost = values.fold(Integer::power_of_ten(differences), |cost, values| cost * values);
    (explanation.count(), Reverse(cost))
}

/// The unstated parameters that each cell needs.
fn needed(judge: &Evaluator<'_>) -> Result<Needed, Diagnostic> {
    let row = |(row, cells): (usize, &Vec<Cell>)| {
        (0..cells.len()).map(|column| Ok(judge.needed(row, column)?.0)).collect()
    };
    judge.table.cells.iter().enumerate().map(row).collect()
}
