//! Judging a table.

use crate::claim::{Cell, Paper, Printed, Table};
use crate::diagnostic::Diagnostic;
use crate::evaluation::choices::DEPTH_ROUNDING;
use crate::evaluation::context::{CellReading, Outcome};
use crate::evaluation::library::Library;
use crate::evaluation::settings::Settings;
use crate::evaluation::table::Evaluator;
use crate::exact::{Integer, RealCyclotomic};
use crate::finding::{
    AsRead, Assumed, CellFinding, CellKind, Direction, Explanation, Missing, Recovered,
    RecoveredFrom, TableFinding, Verdict,
};
use crate::judge::compare;
use crate::judge::distance::Schemes;
use crate::judge::reading::plain::as_plain;
use crate::judge::reading::search::{self, Candidates};
use crate::judge::reading::space::{Family, needed};
use crate::judge::reading::tried::Evaluated;
use crate::judge::slips::Part;
use std::collections::BTreeMap;

/// Judges every cell of a table at these recovered values of parameters, by this part of the family
/// of readings. Its promises are judged by [`judge_promises`].
pub(crate) fn judge<'a>(
    paper: &'a Paper,
    table: &'a Table,
    recovered: BTreeMap<String, Recovered>,
    family: Family,
) -> Result<TableFinding<'a>, Diagnostic> {
    judge_with(&Library::new(paper), paper, table, recovered, family)
}

/// As [`judge`], with the constants of this library.
pub(crate) fn judge_with<'a>(
    library: &Library<'a>,
    paper: &'a Paper,
    table: &'a Table,
    recovered: BTreeMap<String, Recovered>,
    family: Family,
) -> Result<TableFinding<'a>, Diagnostic> {
    let mut finding = TableFinding {
        table,
        cells: Vec::new(),
        search: None,
        assumed_search: None,
        needs: Vec::new(),
        recovered,
        fitting: None,
    };
    let judge = Evaluator::new(paper, table, library, &finding.values())?;
    let mut cells = judge.cells()?;
    judge.compare_with_neighbours(&mut cells);
    let candidates = candidates(paper, &finding.recovered);
    let kinds = CellKind::of(&cells);
    let families = match family {
        Family::InTurn => &[Family::Plain, Family::Whole][..],
        ref one => std::slice::from_ref(one),
    };
    let mut plain: Vec<Option<Vec<Evaluated>>> = kinds.iter().map(|_| None).collect();
    for &family in families {
        finding.needs.clear();
        for (&kind, plain) in kinds.iter().zip(&mut plain) {
            let found = search::search(&judge, &cells, kind, &candidates, family, plain)?;
            let (search, needs) = found.unwrap_or_default();
            finding.needs.extend(needs);
            if kind == CellKind::Plain || kinds.len() == 1 {
                finding.search = search;
            } else {
                finding.assumed_search = search;
            }
        }
        if finding.is_explained() {
            break;
        }
    }
    for search in finding.searches() {
        if let Some(best) = search.best.first() {
            let bears = best.count() * 2 >= search.cells;
            judge.read_as(best, Part::Table(bears), &mut cells);
        }
        for line in &search.lines {
            judge.read_as(&line.best, Part::Line(line.shift), &mut cells);
        }
    }
    finding.cells = cells;
    finding.leave_open();
    finding.reproduce();
    Ok(finding)
}

/// The number of candidates for each recovered value: the values that are as plain or, if another
/// table gave it, the tables of the paper that may give one; and whether it is the table's own.
fn candidates(paper: &Paper, recovered: &BTreeMap<String, Recovered>) -> Candidates {
    let count = |(name, recovered): (&String, &Recovered)| {
        let open = |table: &&Table| table.unstated.get(name).is_some_and(Option::is_none);
        let count = match &recovered.from {
            RecoveredFrom::Solved(..) | RecoveredFrom::Tried => as_plain(&recovered.value),
            RecoveredFrom::Table { .. } => Integer::from(paper.tables.iter().filter(open).count()),
        };
        (name.clone(), (count, recovered.is_own()))
    };
    recovered.iter().map(count).collect()
}

impl TableFinding<'_> {
    /// Whether the searches for readings leave no cell unexplained.
    pub(crate) fn is_explained(&self) -> bool {
        self.searches().all(|search| search.explained() >= search.cells)
    }

    /// Leaves open the cells that a reading with values beyond the caps may explain.
    fn leave_open(&mut self) {
        let uncomputed = self.search_of(CellKind::Plain).and_then(|one| one.uncomputed.clone());
        let Some(uncomputed) = uncomputed else { return };
        for (row, cells) in self.cells.iter_mut().enumerate() {
            for (column, cell) in cells.iter_mut().enumerate() {
                if cell.verdict == Verdict::Refuted && uncomputed.leaves_open((row, column)) {
                    let missing = Missing::Reading(uncomputed.cap.clone());
                    cell.verdict = Verdict::NotCheckable(missing);
                }
            }
        }
    }

    /// Marks as reproduced the cells that a reading explains at recovered values, if this is no
    /// luck.
    fn reproduce(&mut self) {
        let search = self.search_of(CellKind::Assumed).cloned();
        let table = self.table;
        let recovered = |name: &String| table.unstated[name].is_none();
        for (row, cells) in self.cells.iter_mut().enumerate() {
            for (column, cell) in cells.iter_mut().enumerate() {
                if !cell.assumed.iter().any(|(name, _)| recovered(name)) || cell.unknown.is_some() {
                    continue;
                }
                let Some(search) = &search else { continue };
                let lines = search.lines.iter().filter(|line| line.shift == (0, 0));
                let readings = search.best.first().into_iter().chain(lines.map(|line| &line.best));
                let mut by = readings.filter(|reading| reading.explained[row][column]);
                let Some(reading) = by.next() else { continue };
                if let Some(value) = &reading.values[row][column] {
                    let differences = reading.differences.clone();
                    let as_read = AsRead {
                        differences,
                        solved: Vec::new(),
                        rounded: None,
                        value: value.clone(),
                    };
                    cell.as_read = (!reading.differences.is_empty()).then_some(as_read);
                    cell.verdict = Verdict::Reproduced;
                    cell.verdict_if_assumed = None;
                }
            }
        }
    }
}

/// Judges the promises of a table.
pub(crate) fn judge_promises(
    paper: &Paper,
    finding: &mut TableFinding<'_>,
) -> Result<(), Diagnostic> {
    let (library, table) = (Library::new(paper), finding.table);
    let judge = Evaluator::new(paper, table, &library, &finding.values())?;
    let (distances, settings) = (Schemes::default(), Settings::default());
    let needed = needed(&finding.cells);
    for (row, cells) in finding.cells.iter_mut().enumerate() {
        for (column, cell) in cells.iter_mut().enumerate() {
            let at = CellReading { row, column, assume: &needed[row][column], settings: &settings };
            judge.judge_promise(&table.cells[row][column], at, &distances, cell)?;
        }
    }
    Ok(())
}

/// Every reading of the cells of a kind with what it explains, the best first.
pub(crate) fn readings(
    paper: &Paper,
    finding: &TableFinding<'_>,
    kind: CellKind,
    library: &Library<'_>,
) -> Result<Vec<Explanation>, Diagnostic> {
    let judge = Evaluator::new(paper, finding.table, library, &finding.values())?;
    let search = finding.search_of(kind);
    let elsewhere = search.is_some_and(|search| search.elsewhere);
    search::readings(&judge, &finding.cells, kind, elsewhere)
}

impl Evaluator<'_> {
    fn cells(&self) -> Result<Vec<Vec<CellFinding>>, Diagnostic> {
        let row = |(row, cells): (usize, &Vec<Cell>)| {
            (0..cells.len()).map(|column| self.cell(row, column)).collect()
        };
        self.table.cells.iter().enumerate().map(row).collect()
    }

    fn cell(&self, row: usize, column: usize) -> Result<CellFinding, Diagnostic> {
        let cell = &self.table.cells[row][column];
        let (printed, note) = match cell {
            Cell::Lost | Cell::Blank => (None, None),
            Cell::Printed(printed) => (Some(printed.text.clone()), printed.note.clone()),
        };
        let mut finding = CellFinding {
            id: format!("{}:{}:{}:{}", self.paper.key, self.table.id, row + 1, column + 1),
            locus: self.locus(row, column),
            printed,
            note,
            verdict: Verdict::NotCheckable(match cell {
                Cell::Blank => Missing::Number,
                _ => Missing::Cell,
            }),
            exact: None,
            undefined: None,
            as_read: None,
            assumed: Assumed::new(),
            unknown: None,
            verdict_if_assumed: None,
            sound: None,
            kept_by_formula: None,
            kept_by_sound: None,
            kept: None,
            kept_naturally: None,
            natural: Vec::new(),
            by_kernel: Vec::new(),
        };
        let (needed, outcome) = self.needed(row, column)?;
        let settings = Settings::default();
        let value = |name: &String| Some((name.clone(), self.assumed.get(name)?.clone()));
        finding.assumed = needed.iter().filter_map(value).collect();
        let mut beyond_caps = None;
        match outcome {
            Outcome::Value(value) => finding.exact = Some(value),
            Outcome::Undefined(why) => finding.undefined = Some(why),
            Outcome::BeyondCap(cap) => {
                finding.undefined = Some(cap.to_string());
                beyond_caps = Some(Verdict::NotCheckable(Missing::Capacity(cap)));
            }
            Outcome::Unstated(name) => finding.unknown = Some(name),
        }
        if !needed.is_empty() && *cell != Cell::Blank {
            let names = needed.iter().cloned().collect();
            finding.verdict = Verdict::NotCheckable(Missing::Parameters(names));
        }
        let at = CellReading { row, column, assume: &needed, settings: &settings };
        if let (Cell::Printed(printed), None) = (cell, &finding.unknown) {
            let verdict = match beyond_caps {
                Some(verdict) => verdict,
                None => self.verdict(printed, finding.exact.as_ref(), at)?,
            };
            if needed.is_empty() {
                finding.verdict = verdict;
            } else {
                finding.verdict_if_assumed = Some(verdict);
            }
        }
        Ok(finding)
    }

    /// Where a cell stands, in words.
    pub(crate) fn locus(&self, row: usize, column: usize) -> String {
        let headers = self.headers(row, column);
        let headers: Vec<String> =
            headers.map(|(axis, entry)| format!("{} = {}", axis.label, entry.printed)).collect();
        format!("{}, {}", self.table.locus, headers.join(", "))
    }

    /// The verdict, without regard to the neighbouring cells.
    fn verdict(
        &self,
        printed: &Printed,
        exact: Option<&RealCyclotomic>,
        at: CellReading<'_>,
    ) -> Result<Verdict, Diagnostic> {
        let Some(exact) = exact else { return Ok(Verdict::Refuted) };
        let verdict = compare::judge(&printed.decimal, exact, &[]);
        if verdict == Verdict::Confirmed || !self.is_depth() {
            return Ok(verdict);
        }
        let otherwise = [("down", Direction::DepthDown), ("nearest", Direction::DepthNearest)];
        for (rounded, direction) in otherwise {
            let settings = Settings::new(vec![(DEPTH_ROUNDING.key, rounded)]);
            let at = CellReading { settings: &settings, ..at };
            let value = self.evaluate(&self.table.value, at)?;
            if matches!(value, Outcome::Value(value) if value == printed.decimal.value().into()) {
                return Ok(Verdict::Rounding(direction));
            }
        }
        Ok(Verdict::Refuted)
    }
}
