//! Judging a table.

use super::compare;
use super::finding::{AsRead, Assumed, CellFinding, Direction, Missing, Verdict};
use super::library::{Library, Unresolved, values};
use super::quantity::Quantities;
use super::reading::{self, DEPTH_ROUNDING, Explanation, HEADER, Search, Settings};
use super::row::{Known, RowDefinitions};
use crate::claim::{Axis, AxisEntry, Cell, LocatedReference, Paper, Printed, Promise, Table};
use crate::diagnostic::Diagnostic;
use crate::exact::{Rational, RealCyclotomic, parse_decimal};
use crate::formula::{FormulaError, FormulaErrorKind, LocatedFormula, Node, Scope, evaluate};
use crate::scheme::SchemeError;
use std::collections::{BTreeMap, BTreeSet};

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

/// A value of the claim file's formula, or what stands in its way.
pub(super) enum Outcome {
    Value(RealCyclotomic),
    Unstated(String),
    Undefined(String),
    BeyondCaps(String),
}

pub(super) struct Judge<'a> {
    pub(super) paper: &'a Paper,
    pub(super) table: &'a Table,
    pub(super) library: &'a Library<'a>,
    pub(super) given: BTreeMap<String, Rational>,
    pub(super) assumed: BTreeMap<String, Rational>,
    /// As printed.
    settings: Settings,
    pub(super) rows: RowDefinitions,
}

/// One cell's place, and how it is looked at.
#[derive(Clone, Copy)]
pub(super) struct At<'n> {
    pub(super) row: usize,
    pub(super) column: usize,
    /// The unstated parameters that get their assumed values.
    pub(super) assume: &'n BTreeSet<String>,
    /// How the formula is read.
    pub(super) settings: &'n Settings,
}

impl<'a> Judge<'a> {
    fn new(
        paper: &'a Paper,
        table: &'a Table,
        library: &'a Library<'a>,
    ) -> Result<Judge<'a>, Diagnostic> {
        let mut given = values(&paper.given)?;
        given.extend(values(&table.given)?);
        let assumed = values(&table.unstated)?;
        given.retain(|name, _| !assumed.contains_key(name));
        let (settings, rows) = (Settings::default(), RowDefinitions::default());
        let mut judge = Judge { paper, table, library, given, assumed, settings, rows };
        let mut rows = RowDefinitions::find(&judge);
        let assume = judge.assumed.keys().cloned().collect();
        let (row, column, settings) = (0, 0, &Settings::default());
        rows.find_choices(&judge, At { row, column, assume: &assume, settings });
        judge.rows = rows;
        Ok(judge)
    }

    fn scope<'s>(
        &'s self,
        at: At<'s>,
        functions: &'s Quantities<'s>,
        known: &Known,
    ) -> Scope<'s, RealCyclotomic> {
        let definitions = at.settings.definitions.as_ref().unwrap_or(&self.paper.definitions);
        let mut scope = Scope::new(definitions, functions);
        for (name, value) in &self.given {
            let value = at.settings.parameters.get(name).unwrap_or(value);
            scope = scope.with(name, value.clone().into());
        }
        for (name, value) in &self.assumed {
            let value = at.settings.parameters.get(name).unwrap_or(value);
            scope = if at.assume.contains(name) {
                scope.with(name, value.clone().into())
            } else {
                scope.with_unstated(name)
            };
        }
        for (name, value) in known {
            scope = scope.with(name, value.clone());
        }
        for (axis, entry) in self.headers(at.row, at.column) {
            scope = scope.with(&axis.name, self.header(axis, entry, at.settings).into());
        }
        scope
    }

    fn headers(
        &self,
        row: usize,
        column: usize,
    ) -> impl Iterator<Item = (&'a Axis, &'a AxisEntry)> {
        let rows = self.table.rows.as_ref().map(|axis| (axis, &axis.entries[row]));
        let columns = &self.table.columns;
        rows.into_iter().chain([(columns, &columns.entries[column])])
    }

    /// The value of a header: a tolerance may stand for either end of its rounding
    /// interval.
    fn header(&self, axis: &Axis, entry: &AxisEntry, settings: &Settings) -> Rational {
        let value = entry.value.clone();
        let Some(word) = settings.word(&HEADER) else { return value };
        let Some(decimal) =
            self.tolerance(axis).then(|| parse_decimal(&entry.printed).ok()).flatten()
        else {
            return value;
        };
        let (low, high) = decimal.interval();
        if word == "less" { low } else { high }
    }

    /// Whether the axis gives the tolerances of a table of depths.
    fn tolerance(&self, axis: &Axis) -> bool {
        let Some(Promise::Depth { tolerance, .. }) = &self.table.promise else { return false };
        matches!(&tolerance.expr.node, Node::Name(name) if *name == axis.name)
    }

    /// Whether an axis gives tolerances.
    pub(super) fn has_tolerance_headers(&self) -> bool {
        self.table.rows.iter().chain([&self.table.columns]).any(|axis| self.tolerance(axis))
    }

    /// The quantities of this cell's scheme.
    pub(super) fn quantities<'s>(
        &'s self,
        at: At<'s>,
    ) -> Result<Result<Quantities<'s>, Outcome>, Diagnostic> {
        let mut quantities = Quantities {
            library: self.library,
            scheme: None,
            settings: at.settings,
            beyond_caps: std::cell::Cell::new(false),
        };
        let Some(located) = &self.table.scheme else { return Ok(Ok(quantities)) };
        let LocatedReference { reference, source, span } = located;
        match self.library.resolve(reference, &self.scope(at, &quantities, &Known::new())) {
            Ok(scheme) => {
                quantities.scheme = Some(scheme);
                Ok(Ok(quantities))
            }
            Err(Unresolved::Formula(error)) => Self::sort(error).map(Err).map_err(|error| {
                Diagnostic::new(source, span.clone(), format!("in its parameters: {error}"))
            }),
            Err(Unresolved::Scheme(error)) => Err(scheme_error(located, &error)),
        }
    }

    /// A formula error that is a finding, or one that is the claim file's.
    fn sort(error: FormulaError) -> Result<Outcome, FormulaError> {
        match error.kind {
            FormulaErrorKind::Unstated(name) => Ok(Outcome::Unstated(name)),
            FormulaErrorKind::Undefined(why) => Ok(Outcome::Undefined(why)),
            FormulaErrorKind::DivisionByZero => {
                Ok(Outcome::Undefined("the definition divides by zero".to_owned()))
            }
            _ => Err(error),
        }
    }

    /// The value of a formula at a cell.
    pub(super) fn evaluate(
        &self,
        formula: &LocatedFormula,
        at: At<'_>,
    ) -> Result<Outcome, Diagnostic> {
        self.evaluate_knowing(formula, at, &self.rows.of(self, at))
    }

    /// The same with the values of some definitions known.
    pub(super) fn evaluate_knowing(
        &self,
        formula: &LocatedFormula,
        at: At<'_>,
        known: &Known,
    ) -> Result<Outcome, Diagnostic> {
        let quantities = match self.quantities(at)? {
            Ok(quantities) => quantities,
            Err(outcome) => return Ok(outcome),
        };
        match evaluate(&formula.expr, &self.scope(at, &quantities, known)) {
            Ok(value) => Ok(Outcome::Value(value)),
            Err(error) => match Self::sort(error).map_err(|error| formula.diagnostic(&error))? {
                Outcome::Undefined(why) if quantities.beyond_caps.get() => {
                    Ok(Outcome::BeyondCaps(why))
                }
                outcome => Ok(outcome),
            },
        }
    }

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
        if verdict == Verdict::Confirmed
            || !matches!(self.table.promise, Some(Promise::Depth { .. }))
        {
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

    fn is_depth(&self) -> bool {
        matches!(self.table.promise, Some(Promise::Depth { .. }))
    }

    /// Numbers that are no depths may have been copied from a neighbouring cell.
    fn compare_with_neighbours(&self, cells: &mut [Vec<CellFinding>]) {
        if matches!(self.table.promise, Some(Promise::Depth { .. })) {
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

/// An error of a scheme, at the place that names it or, for a scheme of the claim
/// file's own, inside it.
pub(super) fn scheme_error(located: &LocatedReference, error: &SchemeError) -> Diagnostic {
    match error {
        SchemeError::File(inner) if inner.source == located.source => (**inner).clone(),
        other => Diagnostic::new(&located.source, located.span.clone(), other.to_string()),
    }
}
