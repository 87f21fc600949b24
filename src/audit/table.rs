//! Judging a table.

use super::compare;
use super::finding::{AsRead, Assumed, CellFinding, Direction, Missing, Verdict};
use super::judge::{At, Judge, Outcome};
use super::library::Library;
use super::reading::{self, DEPTH_ROUNDING, Explanation, Search, Settings};
use crate::claim::{Cell, Paper, Printed, Table};
use crate::diagnostic::Diagnostic;
use crate::exact::RealCyclotomic;
use std::collections::BTreeSet;

/// What the audit says of a table.
#[derive(Clone, Debug)]
pub struct TableFinding<'a> {
    /// The table.
    pub table: &'a Table,
    /// Its cells, row by row.
    pub cells: Vec<Vec<CellFinding>>,
    /// The search for the reading that it was computed by, unless every cell is as
    /// printed.
    pub search: Option<Search>,
}

/// Judges every cell of a table.
pub(super) fn judge<'a>(
    paper: &'a Paper,
    table: &'a Table,
    library: &Library<'_>,
) -> Result<TableFinding<'a>, Diagnostic> {
    let judge = Judge::new(paper, table, library)?;
    let mut cells = Vec::with_capacity(table.cells.len());
    for row in 0..table.cells.len() {
        let columns = 0..table.cells[row].len();
        cells.push(columns.map(|column| judge.cell(row, column)).collect::<Result<Vec<_>, _>>()?);
    }
    judge.compare_with_neighbours(&mut cells);
    let search = reading::search(&judge, &cells);
    if let Some(reading) = search.as_ref().and_then(|search| search.best.first()) {
        judge.read_as(reading, &mut cells);
    }
    Ok(TableFinding { table, cells, search })
}

impl Judge<'_> {
    fn cell(&self, row: usize, column: usize) -> Result<CellFinding, Diagnostic> {
        let cell = &self.table.cells[row][column];
        let (printed, note) = match cell {
            Cell::Lost => (None, None),
            Cell::Printed(printed) => (Some(printed.text.clone()), printed.note.clone()),
        };
        let mut finding = CellFinding {
            id: format!("{}:{}:{}:{}", self.paper.key, self.table.id, row + 1, column + 1),
            locus: self.locus(row, column),
            printed,
            note,
            verdict: Verdict::NotCheckable(Missing::Cell),
            exact: None,
            undefined: None,
            as_read: None,
            assumed: Assumed::new(),
            verdict_if_assumed: None,
            sound: None,
            kept_by_formula: None,
            kept_by_sound: None,
        };
        // Parameters are assumed one by one, so that those that the value needs
        // are known.
        let mut needed = BTreeSet::new();
        let outcome = loop {
            let at = At { row, column, assume: &needed, settings: &self.settings };
            match self.evaluate(&self.table.value, at)? {
                Outcome::Unstated(name) if needed.insert(name.clone()) => {}
                outcome => break outcome,
            }
        };
        let value = |name: &String| Some((name.clone(), self.assumed.get(name)?.clone()));
        finding.assumed = needed.iter().filter_map(value).collect();
        let mut beyond_caps = None;
        match outcome {
            Outcome::Value(value) => finding.exact = Some(value),
            Outcome::Undefined(why) => finding.undefined = Some(why),
            Outcome::BeyondCaps(why) => {
                finding.undefined = Some(why.clone());
                beyond_caps = Some(Verdict::NotCheckable(Missing::Capacity(why)));
            }
            Outcome::Unstated(name) => {
                let formula = &self.table.value;
                let message = format!("`{name}` has no value, not even an assumed one");
                return Err(Diagnostic::new(&formula.source, formula.span.clone(), message));
            }
        }
        if !needed.is_empty() {
            let names = needed.iter().cloned().collect();
            finding.verdict = Verdict::NotCheckable(Missing::Parameters(names));
        }
        let at = At { row, column, assume: &needed, settings: &self.settings };
        if let Cell::Printed(printed) = cell {
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
        self.judge_promise(cell, at, &mut finding)?;
        Ok(finding)
    }

    fn locus(&self, row: usize, column: usize) -> String {
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
        at: At<'_>,
    ) -> Result<Verdict, Diagnostic> {
        let Some(exact) = exact else { return Ok(Verdict::Refuted) };
        let verdict = compare::judge(&printed.decimal, exact, &[]);
        if verdict == Verdict::Confirmed || !self.is_depth() {
            return Ok(verdict);
        }
        let otherwise = [("down", Direction::DepthDown), ("nearest", Direction::DepthNearest)];
        for (rounded, direction) in otherwise {
            let settings = Settings::new(vec![(DEPTH_ROUNDING.name, rounded)]);
            let at = At { settings: &settings, ..at };
            let value = self.evaluate(&self.table.value, at)?;
            if matches!(value, Outcome::Value(value) if value == printed.decimal.value().into()) {
                return Ok(Verdict::Rounding(direction));
            }
        }
        Ok(Verdict::Refuted)
    }

    /// What a reading makes of the cells that are not as printed: explained, or a
    /// slip away from its value.
    fn read_as(&self, reading: &Explanation, cells: &mut [Vec<CellFinding>]) {
        let differs = reading.differs();
        for (row, findings) in cells.iter_mut().enumerate() {
            for (column, finding) in findings.iter_mut().enumerate() {
                let Cell::Printed(printed) = &self.table.cells[row][column] else { continue };
                let Some(value) = reading.values[row][column].clone() else { continue };
                let verdict = finding.verdict_if_assumed.as_mut().unwrap_or(&mut finding.verdict);
                let read = match verdict {
                    Verdict::Refuted | Verdict::Rounding(_) | Verdict::Misprint(_)
                        if reading.explained[row][column] =>
                    {
                        Verdict::OtherReading
                    }
                    Verdict::Refuted if !self.is_depth() => {
                        compare::judge(&printed.decimal, &value, &[])
                    }
                    _ => continue,
                };
                if matches!(read, Verdict::OtherReading | Verdict::Misprint(_)) {
                    *verdict = read;
                    finding.as_read = Some(AsRead { differs: differs.clone(), value });
                }
            }
        }
    }

    /// Numbers that are no depths may have been copied from a neighbouring cell.
    fn compare_with_neighbours(&self, cells: &mut [Vec<CellFinding>]) {
        if self.is_depth() {
            return;
        }
        let exact: Vec<Vec<Option<RealCyclotomic>>> =
            cells.iter().map(|row| row.iter().map(|cell| cell.exact.clone()).collect()).collect();
        for (row, findings) in cells.iter_mut().enumerate() {
            for (column, finding) in findings.iter_mut().enumerate() {
                let Cell::Printed(printed) = &self.table.cells[row][column] else { continue };
                let (Verdict::Refuted, Some(value)) = (&finding.verdict, &finding.exact) else {
                    continue;
                };
                let around = [(0, 1), (0, -1), (1, 0), (-1, 0)].into_iter().filter_map(|step| {
                    let row = row.checked_add_signed(step.0 as isize)?;
                    let column = column.checked_add_signed(step.1 as isize)?;
                    Some((step, exact.get(row)?.get(column)?.as_ref()?))
                });
                let around: Vec<((i32, i32), &RealCyclotomic)> = around.collect();
                finding.verdict = compare::judge(&printed.decimal, value, &around);
            }
        }
    }
}
