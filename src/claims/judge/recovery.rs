//! The values of a table's open parameters with which a reading gives most of its cells.

use crate::claim::{Paper, Table};
use crate::cores;
use crate::diagnostic::Diagnostic;
use crate::evaluation::library::Library;
use crate::finding::{CellKind, Fitting, Recovered, RecoveredFrom, TableFinding, Verdict, values};
use crate::judge::reading::plain::plain_numbers;
use crate::judge::reading::recover::solved;
use crate::judge::reading::space::Family;
use crate::judge::table::{judge, judge_with};
use std::collections::BTreeMap;

/// Recovered parameters by name.
pub(crate) type Values = BTreeMap<String, Recovered>;

/// The values of a table's open parameters that its numbers give.
pub(crate) enum RecoveredValues<'a> {
    /// The table judged at values with which a reading gives so many cells that it is no luck.
    Values(Box<TableFinding<'a>>),
    /// Values with which a reading gives some, which may be luck.
    Fitting(Fitting),
    /// There are none.
    Nothing,
}

/// The values of a table's open parameters with which a reading gives most of its cells. `offers`
/// lists for each open parameter the values that other tables have for it.
pub(crate) fn recover<'a>(
    paper: &'a Paper,
    table: &'a Table,
    offers: &[(String, Vec<Recovered>)],
) -> Result<RecoveredValues<'a>, Diagnostic> {
    let mut recovery = Recovery { paper, table, best: None, likeliest: None };
    let mut ways = Vec::new();
    for (name, _) in offers {
        let others: Vec<_> = offers.iter().filter(|(other, _)| other != name).cloned().collect();
        ways.extend(combinations(&others).into_iter().map(|others| (Some(name), others)));
    }
    ways.extend(combinations(offers).into_iter().map(|values| (None, values)));
    recovery.attempt(&ways)?;
    if let [(first, _), (second, _)] = offers {
        let cells = table.cells.iter().flatten().filter(|cell| cell.printed().is_some()).count();
        for value in plain_numbers() {
            if recovery.count() * 2 >= cells {
                break;
            }
            let ways = [(first, second), (second, first)].map(|(name, other)| {
                let tried = Recovered { value: value.clone(), from: RecoveredFrom::Tried };
                (Some(name), Values::from([(other.clone(), tried)]))
            });
            recovery.attempt(&ways)?;
        }
    }
    if let Some((_, finding)) = recovery.best {
        return Ok(RecoveredValues::Values(Box::new(finding)));
    }
    let Some((cells, values)) = recovery.likeliest else { return Ok(RecoveredValues::Nothing) };
    // What the first part of the family gives may be luck, and what the whole family gives none.
    let found = judge(paper, table, values.clone(), Family::Whole)?;
    let given = reproduced(&found) > 0;
    Ok(if given {
        RecoveredValues::Values(Box::new(found))
    } else {
        RecoveredValues::Fitting(Fitting { values, cells })
    })
}

/// How many cells of a table are reproduced.
pub(crate) fn reproduced(finding: &TableFinding<'_>) -> usize {
    let cells = finding.cells.iter().flatten();
    cells.filter(|cell| cell.verdict == Verdict::Reproduced).count()
}

/// The best values so far.
struct Recovery<'a> {
    paper: &'a Paper,
    table: &'a Table,
    /// How many cells are reproduced, and the table judged there.
    best: Option<(usize, TableFinding<'a>)>,
    /// The values at which a reading gives most cells, and how many, while no cell is reproduced.
    likeliest: Option<(usize, Values)>,
}

/// A parameter to solve for, if there is one, and the values of the others.
type Attempt<'n> = (Option<&'n String>, Values);

impl Recovery<'_> {
    fn count(&self) -> usize {
        self.best.as_ref().map_or(0, |(count, _)| *count)
    }

    /// Judges the table at the values of each of these ways. Of equally good values the first
    /// remain.
    fn attempt(&mut self, ways: &[Attempt<'_>]) -> Result<(), Diagnostic> {
        let (paper, table) = (self.paper, self.table);
        for judged in cores::map(ways, |way| judged(paper, table, way)) {
            let Some((values, found)) = judged? else { continue };
            let count = reproduced(&found);
            let most = found.search_of(CellKind::Assumed).map_or(0, |search| search.most);
            if most > self.likeliest.as_ref().map_or(0, |(most, _)| *most) {
                self.likeliest = Some((most, values));
            }
            if count > self.count() {
                self.best = Some((count, found));
            }
        }
        Ok(())
    }
}

/// The table judged at the values of a way, and these values; `None` where there is nothing to solve
/// for the parameter.
fn judged<'a>(
    paper: &'a Paper,
    table: &'a Table,
    (name, others): &Attempt<'_>,
) -> Result<Option<(Values, TableFinding<'a>)>, Diagnostic> {
    let (library, mut all, mut family) = (Library::new(paper), others.clone(), Family::Plain);
    if let Some(name) = name {
        let Some((value, by)) = solved(paper, table, &library, &values(others), name)? else {
            return Ok(None);
        };
        all.insert((*name).clone(), value);
        family = by;
    }
    let found = judge_with(&library, paper, table, all.clone(), family)?;
    Ok(Some((all, found)))
}

/// The most combinations of values that other tables offer.
const MAX_COMBINATIONS: usize = 8;

/// Every combination of one offered value for each parameter. There is none if a parameter has no
/// value; without parameters there is one, the empty one.
pub(crate) fn combinations(offers: &[(String, Vec<Recovered>)]) -> Vec<Values> {
    let mut all = vec![Values::new()];
    for (name, values) in offers {
        let with = |known: &Values, value: &Recovered| {
            let mut values = known.clone();
            values.insert(name.clone(), value.clone());
            values
        };
        let longer =
            all.iter().flat_map(|known| values.iter().map(move |value| with(known, value)));
        all = longer.take(MAX_COMBINATIONS).collect();
    }
    all
}
