//! Recovering a parameter that the paper does not state from the printed numbers of a table.

use crate::claim::{Cell, Paper, Table};
use crate::evaluation::library::Library;
use crate::evaluation::table::Evaluator;
use crate::exact::{Integer, Rational};
use crate::finding::{Explanation, Recovered, RecoveredFrom};
use crate::judge::reading::plain::as_plain;
use crate::judge::reading::space::{Needed, Space};
use crate::judge::reading::{solve, tried};
use std::cmp::Reverse;
use std::collections::BTreeMap;

/// The value of the parameter at which the search begins. Where the values are proportional to the
/// parameter, or levels depend on it as on a spread, any value will do. For a parameter of a
/// scheme, most schemes converge at this value.
const START: (i64, i64) = (1, 100);

/// The value of an unstated parameter with which some reading gives most of the cells that need it,
/// with the other unstated parameters at these values. `None` where no reading depends on it in a
/// way that can be solved.
pub(crate) fn solved(
    paper: &Paper,
    table: &Table,
    library: &Library<'_>,
    others: &BTreeMap<String, Rational>,
    name: &str,
) -> Option<Recovered> {
    let mut values = others.clone();
    values.insert(name.to_owned(), Rational::new(START.0, START.1));
    let judge = Evaluator::new(paper, table, library, &values).ok()?;
    let needed = needed(&judge)?;
    let printed = table.cells.iter().zip(&needed).map(|(row, needed)| {
        let cells = row.iter().zip(needed);
        cells.map(|(cell, needed)| cell.printed().filter(|_| !needed.is_empty())).collect()
    });
    let printed = printed.collect();
    let space = Space::new(&judge, needed, &printed, Some(name))?;
    let all = space.evaluated(space.readings());
    let mut explanations = space.all_explanations(&all);
    explanations.extend(solve::solve(&space, &all, &tried::best(&explanations)));
    explanations.retain(|explanation| explanation.solved.iter().any(|one| one.name == name));
    // Of equally good ones the first.
    let best = explanations.iter().rev().max_by_key(|one| rank(one))?;
    let solved = best.solved.iter().find(|solved| solved.name == name)?;
    let (low, high) = solved.between.clone();
    let from = RecoveredFrom::Solved(low, high);
    Some(Recovered { value: solved.simplest.clone(), from })
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

/// The unstated parameters that each cell needs. `None` if a formula is wrong.
fn needed(judge: &Evaluator<'_>) -> Option<Needed> {
    let row = |(row, cells): (usize, &Vec<Cell>)| {
        (0..cells.len()).map(|column| Some(judge.needed(row, column).ok()?.0)).collect()
    };
    judge.table.cells.iter().enumerate().map(row).collect()
}
