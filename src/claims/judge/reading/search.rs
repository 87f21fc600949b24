//! The search for the reading that explains most cells of a table.

use crate::claim::Printed;
use crate::diagnostic::Diagnostic;
use crate::evaluation::table::Evaluator;
use crate::exact::{Integer, Rational};
use crate::finding::{COPIED, CellFinding, CellKind, Explanation, Search, WayCounts};
use crate::judge::reading::chance::{BothEvidence, Evidence, is_small};
use crate::judge::reading::space::{Family, PrintedCells, ReadingSpace, needed, printed};
use crate::judge::reading::tried::{Evaluated, Part, parts};
use crate::judge::reading::{line, tried};
use std::cmp::Reverse;
use std::collections::BTreeMap;

/// For each recovered parameter, the number of values from which its value was taken, and whether the numbers of this
/// table give it.
pub(crate) type Candidates = BTreeMap<String, (Integer, bool)>;

/// The search, where one is needed, and what the cells need.
type Searched = (Option<Search>, Vec<WayCounts>);

/// Searches the family for readings of the cells of one kind, where `findings` are all cells of the
/// table as printed. Gives the search, or `None` for it if every cell is as printed and no
/// parameter was recovered, and what the cells need. The whole result is `None` if no cell of this
/// kind is printed, or if a parameter that they need has no value. `plain` keeps the values under the
/// readings that take nothing from elsewhere, for another search of the same cells.
pub(crate) fn search(
    judge: &Evaluator<'_>,
    findings: &[Vec<CellFinding>],
    kind: CellKind,
    candidates: &Candidates,
    family: Family,
    plain: &mut Option<Vec<Evaluated>>,
) -> Result<Option<Searched>, Diagnostic> {
    let printed = printed(judge, findings, kind);
    let cells: Vec<&Printed> = printed.iter().flatten().flatten().copied().collect();
    let Some(space) = ReadingSpace::new(judge, needed(findings), &printed, None) else {
        return Ok(None);
    };
    if !space.assume.iter().all(|name| judge.assumed.contains_key(name)) {
        return Ok(None);
    }
    let as_printed = space.explained_as_printed();
    let count = as_printed.iter().flatten().filter(|explained| **explained).count();
    let plain = match plain {
        Some(plain) => &*plain,
        None => &*plain.insert(space.evaluated(space.readings())?),
    };
    let explanations = space.all_explanations(plain);
    let mut needs = space.needs(&explanations);
    let counts = space.assume.iter().filter_map(|name| candidates.get(name));
    let recovered = counts.map(|(count, _)| count.clone()).reduce(|all, count| all * count);
    if count == cells.len() && recovered.is_none() {
        return Ok(Some((None, needs)));
    }
    // The cells that the printed text gives without assumptions do not support another reading.
    let is_given =
        |row: usize, column: usize| as_printed[row][column] && findings[row][column].is_plain();
    let others = BothEvidence::new(&space, |row, column| !is_given(row, column));
    let given = cells.len() - others.cells();
    let values = recovered.clone().unwrap_or_else(Integer::one);
    let shares = parts(judge.paper);
    let determined = |best: &Explanation, tried: usize| {
        recovered.is_none() || is_determined(&space, best, candidates, shares * tried)
    };
    let least = if recovered.is_some() { 0 } else { count };
    let of_best = |best: Vec<Explanation>, tried: usize| {
        let most = best.first().map_or(0, Explanation::count);
        let (beyond, others) = (most.saturating_sub(given), others.of(best.first()));
        let chance = others.chance(beyond, &(Integer::from(shares * tried) * &values));
        let sure = most > least
            && others.are_enough(beyond)
            && is_small(&chance)
            && best.first().is_some_and(|best| determined(best, tried));
        let best = if sure { best } else { Vec::new() };
        BestOfPart { best, most, chance }
    };
    let judged = |explanations: &[Explanation], tried: usize| {
        let found = of_best(tried::best(explanations), tried);
        // A reading that gives as many and brings no constant needs less to be no luck.
        let other = || of_best(tried::best(&tried::by_choices(explanations)), tried);
        let other = found.best.is_empty().then(other).filter(|other| other.most == found.most);
        other.unwrap_or(found)
    };
    let mut tried = space.count(plain);
    let mut found = judged(&explanations, tried);
    let mut parts = vec![Part { all: plain, tried }];
    let reached = |found: &BestOfPart| found.best.first().map_or(count, Explanation::count);
    let copied = if family == Family::Whole && reached(&found) < cells.len() {
        space.evaluated(space.copied_readings())?
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
            found = BestOfPart { best: Vec::new(), ..other };
        }
    }
    let BestOfPart { best, most, chance } = found;
    // Without a reading of the table nothing determines the values that its numbers give.
    let undetermined =
        best.is_empty() && recovered.is_some() && candidates.values().any(|(_, own)| *own);
    let lines = if undetermined {
        Vec::new()
    } else {
        let explained = best.first().map(|best| &best.explained).into_iter().chain([&as_printed]);
        line::search(&space, &parts, left(&printed, explained), &values)
    };
    let mut choices = space.names();
    if !copied.is_empty() {
        choices.push(COPIED.to_owned());
    }
    let (cells, as_printed, elsewhere) = (cells.len(), count, !copied.is_empty());
    let uncomputed = space.uncomputed(&parts, best.first(), as_printed);
    Ok(Some((
        Some(Search {
            tried,
            choices,
            max_differences: space.most_differences(),
            elsewhere,
            cells,
            as_printed,
            most,
            best,
            chance,
            lines,
            uncomputed,
        }),
        needs,
    )))
}

/// Whether the cells that tell something of the recovered values are no luck under a reading, for
/// each value that the numbers of this table give, where so many readings were tried.
fn is_determined(
    space: &ReadingSpace<'_>,
    best: &Explanation,
    candidates: &Candidates,
    tried: usize,
) -> bool {
    let mut own = candidates.iter().filter(|(_, (_, own))| *own).map(|(name, _)| name);
    own.all(|name| {
        let telling = tried::telling(space, best, name);
        let m = telling.iter().flatten().filter(|telling| **telling == Some(true)).count();
        let counts = |row: usize, column: usize| telling[row][column].is_some();
        let cells = Evidence::new(space.printed, space.is_depth(), None, counts);
        let needed = space.needed_with(name);
        let values = needed.iter().filter_map(|name| candidates.get(name));
        let values = values.fold(Integer::one(), |all, (count, _)| all * count.clone());
        is_small(&cells.chance(m, &(Integer::from(tried) * values)))
    })
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
struct BestOfPart {
    /// The readings that explain most; empty if they may be luck.
    best: Vec<Explanation>,
    most: usize,
    chance: Rational,
}

/// The stated parameter to which every value of the table is proportional.
pub(crate) fn scale(judge: &Evaluator<'_>, findings: &[Vec<CellFinding>]) -> Option<String> {
    let printed = printed(judge, findings, CellKind::Plain);
    let scale = ReadingSpace::new(judge, needed(findings), &printed, None)?.scale;
    scale.filter(|scale| scale.stated).map(|scale| scale.name)
}

/// Every reading of the cells of one kind, with the cells that it explains, the best first. If
/// `elsewhere`, these include the readings that take a quantity from another place of the paper.
pub(crate) fn readings(
    judge: &Evaluator<'_>,
    findings: &[Vec<CellFinding>],
    kind: CellKind,
    elsewhere: bool,
) -> Result<Vec<Explanation>, Diagnostic> {
    let printed = printed(judge, findings, kind);
    let Some(space) = ReadingSpace::new(judge, needed(findings), &printed, None) else {
        return Ok(Vec::new());
    };
    let mut all = space.evaluated(space.readings())?;
    if elsewhere {
        all.extend(space.evaluated(space.copied_readings())?);
    }
    let mut explanations = space.all_explanations(&all);
    explanations.sort_by_key(|explanation| Reverse(explanation.rank()));
    Ok(explanations)
}
