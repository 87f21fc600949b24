//! Judging a table.

use crate::claim::{Cell, Paper, Printed, Promise, Table};
use crate::diagnostic::Diagnostic;
use crate::evaluation::choices::DEPTH_ROUNDING;
use crate::evaluation::context::{At, Outcome};
use crate::evaluation::library::Library;
use crate::evaluation::settings::Settings;
use crate::evaluation::table::Evaluator;
use crate::exact::{Decimal, RealCyclotomic};
use crate::finding::{
    AsRead, Assumed, CellFinding, CellKind, Direction, Explanation, Missing, Sibling, Slip,
    TableFinding, Values, Verdict,
};
use crate::judge::compare;
use crate::judge::distance::Schemes;
use crate::judge::reading::{search, sibling};
use std::collections::BTreeSet;

/// What a reading is of.
#[derive(Clone, Copy)]
enum Part {
    /// The whole table.
    Table,
    /// A row or column, of which the values stand so many rows down and columns to the
    /// right. The cells around it are read otherwise.
    Line((i32, i32)),
}

/// The places of a paper's tables in groups: tables about a scheme of the same name are
/// judged together, since one can give away a parameter of the other.
pub(crate) fn related(paper: &Paper) -> Vec<Vec<usize>> {
    let mut groups: Vec<(Vec<usize>, BTreeSet<&str>)> = Vec::new();
    for (place, table) in paper.tables.iter().enumerate() {
        let ring = table.promise.as_ref().and_then(Promise::ring);
        let references = table.scheme.iter().chain(ring);
        let names: BTreeSet<&str> = references.flat_map(|one| one.reference.names()).collect();
        let (same, others) = groups
            .into_iter()
            .partition(|(_, others): &(_, BTreeSet<&str>)| !others.is_disjoint(&names));
        groups = others;
        groups.push(same.into_iter().fold((vec![place], names), |mut group, (places, names)| {
            group.0.extend(places);
            group.1.extend(names);
            group
        }));
    }
    let sorted = |(mut places, _): (Vec<usize>, _)| {
        places.sort_unstable();
        places
    };
    groups.into_iter().map(sorted).collect()
}

/// Judges related tables, with their places; those that no reading explains, once more
/// with what the others say of their parameters.
///
/// # Errors
/// The first, with the place of its table.
pub(crate) fn judge_all<'a>(
    paper: &'a Paper,
    places: &[usize],
    after_table: &dyn Fn(),
) -> Result<Vec<(usize, TableFinding<'a>)>, (usize, Diagnostic)> {
    let first = places.iter().map(|&place| {
        let finding = judge(paper, &paper.tables[place], Vec::new());
        after_table();
        finding.map_err(|error| (place, error))
    });
    let mut findings = first.collect::<Result<Vec<TableFinding<'a>>, _>>()?;
    for (i, &place) in places.iter().enumerate() {
        let siblings = sibling::siblings(&findings[i], &findings);
        if !siblings.is_empty() {
            let again = judge(paper, findings[i].table, siblings);
            findings[i] = again.map_err(|error| (place, error))?;
        }
    }
    Ok(places.iter().copied().zip(findings).collect())
}

/// Judges every cell of a table.
fn judge<'a>(
    paper: &'a Paper,
    table: &'a Table,
    siblings: Vec<Sibling>,
) -> Result<TableFinding<'a>, Diagnostic> {
    let library = Library::new(paper);
    let judge = Evaluator::new(paper, table, &library)?;
    let mut cells = judge.cells(&Schemes::default())?;
    judge.compare_with_neighbours(&mut cells);
    let (mut searches, mut needs) = (Vec::new(), Vec::new());
    for kind in CellKind::of(&cells) {
        let (search, needed) = search::search(&judge, &siblings, &cells, kind).unwrap_or_default();
        searches.push(search);
        needs.extend(needed);
    }
    for search in searches.iter().flatten() {
        if let Some(best) = search.best.first() {
            judge.read_as(best, Part::Table, &mut cells);
        }
        for line in &search.lines {
            judge.read_as(&line.best, Part::Line(line.shift), &mut cells);
        }
    }
    let mut searches = searches.into_iter();
    let (search, assumed_search) = (searches.next().flatten(), searches.next().flatten());
    Ok(TableFinding { table, cells, search, assumed_search, needs, siblings })
}

/// Every reading of a table with what it explains, the best first: of the cells that need no
/// assumptions, if there are any.
pub(crate) fn readings(
    paper: &Paper,
    finding: &TableFinding<'_>,
    library: &Library<'_>,
) -> Result<Vec<Explanation>, Diagnostic> {
    let judge = Evaluator::new(paper, finding.table, library)?;
    let kinds = CellKind::of(&finding.cells);
    let kind = kinds.first().copied().unwrap_or(CellKind::Plain);
    Ok(search::readings(&judge, &finding.siblings, &finding.cells, kind))
}

impl Evaluator<'_> {
    fn cells(&self, distances: &Schemes) -> Result<Vec<Vec<CellFinding>>, Diagnostic> {
        let row = |(row, cells): (usize, &Vec<Cell>)| {
            (0..cells.len()).map(|column| self.cell(row, column, distances)).collect()
        };
        self.table.cells.iter().enumerate().map(row).collect()
    }

    fn cell(
        &self,
        row: usize,
        column: usize,
        distances: &Schemes,
    ) -> Result<CellFinding, Diagnostic> {
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
            kept: None,
            kept_naturally: None,
        };
        // Parameters are assumed one by one, so that those that the value needs
        // are known.
        let (mut needed, settings) = (BTreeSet::new(), Settings::default());
        let outcome = loop {
            let at = At { row, column, assume: &needed, settings: &settings };
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
        let at = At { row, column, assume: &needed, settings: &settings };
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
        self.judge_promise(cell, at, distances, &mut finding)?;
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
            let settings = Settings::new(vec![(DEPTH_ROUNDING.key, rounded)]);
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
    fn read_as(&self, reading: &Explanation, part: Part, cells: &mut [Vec<CellFinding>]) {
        let shift = if let Part::Line(shift) = part { shift } else { (0, 0) };
        for (row, findings) in cells.iter_mut().enumerate() {
            for (column, finding) in findings.iter_mut().enumerate() {
                let Cell::Printed(printed) = &self.table.cells[row][column] else { continue };
                let Some(value) = reading.values[row][column].clone() else { continue };
                let verdict = finding.verdict_if_assumed.as_mut().unwrap_or(&mut finding.verdict);
                let explained = reading.explained[row][column];
                let read = match verdict {
                    Verdict::Refuted if explained && shift != (0, 0) => {
                        Verdict::Misprint(Slip::Neighbour(shift.0, shift.1))
                    }
                    Verdict::Refuted | Verdict::Rounding(_) | Verdict::Misprint(_)
                        if explained && shift == (0, 0) =>
                    {
                        Verdict::OtherReading
                    }
                    Verdict::Refuted if !self.is_depth() && shift == (0, 0) => match part {
                        Part::Table => self.slip(&printed.decimal, &reading.values, row, column),
                        Part::Line(_) => compare::judge(&printed.decimal, &value, &[]),
                    },
                    _ => continue,
                };
                let mut rounded = None;
                *verdict = match read {
                    Verdict::OtherReading | Verdict::Misprint(_) => read,
                    Verdict::Rounding(direction) if compare::says_enough(&printed.decimal) => {
                        rounded = Some(direction);
                        Verdict::OtherReading
                    }
                    _ => continue,
                };
                let (differences, solved) = (reading.differences.clone(), reading.solved.clone());
                finding.as_read = Some(AsRead { differences, solved, rounded, value });
            }
        }
    }

    /// The verdict on a cell for these values of the table, its neighbours regarded.
    fn slip(&self, printed: &Decimal, values: &Values, row: usize, column: usize) -> Verdict {
        let Some(value) = &values[row][column] else { return Verdict::Refuted };
        match self.exchanged(values, row, column) {
            Some(slip) => Verdict::Misprint(slip),
            None => compare::judge(printed, value, &compare::around(values, row, column)),
        }
    }

    /// Numbers that are no depths may have been copied from a neighbouring cell, or
    /// exchanged with one.
    fn compare_with_neighbours(&self, cells: &mut [Vec<CellFinding>]) {
        if self.is_depth() {
            return;
        }
        let values = |counts: fn(&CellFinding) -> bool| -> Values {
            let value = |cell: &CellFinding| cell.exact.clone().filter(|_| counts(cell));
            cells.iter().map(|row| row.iter().map(value).collect()).collect()
        };
        // What needs assumptions does not count where nothing is assumed.
        let plain = values(|cell| cell.assumed.is_empty());
        let all = values(|_| true);
        for (row, findings) in cells.iter_mut().enumerate() {
            for (column, finding) in findings.iter_mut().enumerate() {
                let Cell::Printed(printed) = &self.table.cells[row][column] else { continue };
                let exact = if finding.assumed.is_empty() { &plain } else { &all };
                let verdict = finding.verdict_if_assumed.as_mut().unwrap_or(&mut finding.verdict);
                if *verdict == Verdict::Refuted {
                    *verdict = self.slip(&printed.decimal, exact, row, column);
                }
            }
        }
    }

    /// The neighbour that this cell is exchanged with: each prints the other's value.
    fn exchanged(&self, values: &Values, row: usize, column: usize) -> Option<Slip> {
        let printed = |row: usize, column: usize| {
            Some(&self.table.cells.get(row)?.get(column)?.printed()?.decimal)
        };
        let (here, own) = (printed(row, column)?, values.get(row)?.get(column)?.as_ref()?);
        compare::around(values, row, column).into_iter().find_map(|((rows, columns), other)| {
            let (row, column) = compare::moved(row, column, (rows, columns))?;
            compare::exchanged(here, own, printed(row, column)?, other)
                .then_some(Slip::Exchanged(rows, columns))
        })
    }
}
