//! The formulas of a table, evaluated cell by cell.

use super::kept::Remembered;
use super::library::{Library, Unresolved, values};
use super::quantity::{LevelCall, Quantities};
use super::reading::{HEADER, Settings, Sibling};
use super::row::{Known, RowDefinitions};
use crate::claim::{Axis, AxisEntry, Cell, LocatedReference, Paper, Promise, Table};
use crate::diagnostic::Diagnostic;
use crate::exact::{Rational, RealCyclotomic, parse_decimal};
use crate::formula::{FormulaError, FormulaErrorKind, LocatedFormula, Node, Scope, evaluate};
use crate::scheme::SchemeError;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// A value of the claim file's formula, or what stands in its way.
pub(super) enum Outcome {
    Value(RealCyclotomic),
    Unstated(String),
    Undefined(String),
    BeyondCaps(String),
}

/// A table, with what its formulas refer to.
pub(super) struct Judge<'a> {
    pub(super) paper: &'a Paper,
    pub(super) table: &'a Table,
    pub(super) library: &'a Library<'a>,
    pub(super) given: BTreeMap<String, Rational>,
    pub(super) assumed: BTreeMap<String, Rational>,
    /// As printed.
    pub(super) settings: Settings,
    pub(super) rows: RowDefinitions,
    /// What other tables say of unstated parameters.
    pub(super) siblings: Vec<Sibling>,
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
    pub(super) fn new(
        paper: &'a Paper,
        table: &'a Table,
        library: &'a Library<'a>,
    ) -> Result<Judge<'a>, Diagnostic> {
        let mut given = values(&paper.given)?;
        given.extend(values(&table.given)?);
        let assumed = values(&table.unstated)?;
        let axes = || table.rows.iter().chain([&table.columns]);
        let header = |name: &String| axes().any(|axis| axis.name == *name);
        given.retain(|name, _| !assumed.contains_key(name) && !header(name));
        let (settings, rows) = (Settings::default(), RowDefinitions::default());
        let siblings = Vec::new();
        let mut judge = Judge { paper, table, library, given, assumed, settings, rows, siblings };
        let mut rows = RowDefinitions::find(&judge);
        let assume = judge.assumed.keys().cloned().collect();
        rows.find_choices(&judge, &assume);
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

    pub(super) fn headers(
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
    pub(super) fn header(&self, axis: &Axis, entry: &AxisEntry, settings: &Settings) -> Rational {
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

    /// Whether the cells are depths.
    pub(super) fn is_depth(&self) -> bool {
        matches!(self.table.promise, Some(Promise::Depth { .. }))
    }

    /// Whether the axis gives the tolerances of a table of depths.
    pub(super) fn tolerance(&self, axis: &Axis) -> bool {
        let Some(Promise::Depth { tolerance, .. }) = &self.table.promise else { return false };
        matches!(&tolerance.expr.node, Node::Name(name) if *name == axis.name)
    }

    /// Whether an axis gives tolerances.
    pub(super) fn has_tolerance_headers(&self) -> bool {
        self.table.rows.iter().chain([&self.table.columns]).any(|axis| self.tolerance(axis))
    }

    /// The value of what is printed in a cell.
    pub(super) fn printed(&self, at: At<'_>) -> Option<Rational> {
        match &self.table.cells[at.row][at.column] {
            Cell::Lost => None,
            Cell::Printed(printed) => Some(printed.decimal.value()),
        }
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
            last_levels: std::cell::RefCell::new(None),
        };
        let Some(located) = &self.table.scheme else { return Ok(Ok(quantities)) };
        let scope = self.scope(at, &quantities, &Known::new());
        match self.library.resolve(&located.reference, &scope) {
            Ok(scheme) => {
                quantities.scheme = Some(scheme);
                Ok(Ok(quantities))
            }
            Err(error) => Self::unresolved(located, error).map(Err),
        }
    }

    /// The distances of this ring at a cell.
    pub(super) fn ring(
        &self,
        located: &LocatedReference,
        at: At<'_>,
    ) -> Result<Result<Rc<Remembered>, Outcome>, Diagnostic> {
        let quantities = match self.quantities(at)? {
            Ok(quantities) => quantities,
            Err(outcome) => return Ok(Err(outcome)),
        };
        let scope = self.scope(at, &quantities, &Known::new());
        match self.library.ring_distances(&located.reference, &scope) {
            Ok(distances) => Ok(Ok(distances)),
            Err(error) => Self::unresolved(located, error).map(Err),
        }
    }

    /// Why a reference gives no scheme: a finding, or an error of the claim file.
    fn unresolved(located: &LocatedReference, error: Unresolved) -> Result<Outcome, Diagnostic> {
        match error {
            Unresolved::Formula(error) => Self::sort(error).map_err(|error| {
                let message = format!("in its parameters: {error}");
                Diagnostic::new(&located.source, located.span.clone(), message)
            }),
            Unresolved::Scheme(error) => Err(scheme_error(located, &error)),
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
        let quantities = match self.quantities(at)? {
            Ok(quantities) => quantities,
            Err(outcome) => return Ok(outcome),
        };
        let known = self.rows.of(self, at, &quantities);
        self.evaluate_with(formula, at, &quantities, &known)
    }

    /// The number of levels that a cell's value is, before it is rounded; `None` where
    /// it is another number.
    pub(super) fn level_call(&self, at: At<'_>) -> Option<LevelCall> {
        self.value_and_levels(at)?.1
    }

    /// A cell's value, and the number of levels that it is, where it is one.
    pub(super) fn value_and_levels(
        &self,
        at: At<'_>,
    ) -> Option<(RealCyclotomic, Option<LevelCall>)> {
        let quantities = self.quantities(at).ok()?.ok()?;
        let known = self.rows.of(self, at, &quantities);
        quantities.last_levels.take();
        let value = self.evaluate_with(&self.table.value, at, &quantities, &known);
        let Ok(Outcome::Value(value)) = value else { return None };
        let call = quantities.last_levels.take();
        let is_value =
            |call: &LevelCall| call.level.is_some_and(|level| value == RealCyclotomic::from(level));
        let call = call.filter(is_value);
        Some((value, call))
    }

    /// The same with these quantities, and with the values of some definitions known.
    pub(super) fn evaluate_with(
        &self,
        formula: &LocatedFormula,
        at: At<'_>,
        quantities: &Quantities<'_>,
        known: &Known,
    ) -> Result<Outcome, Diagnostic> {
        // What another formula was given up for says nothing of this one.
        quantities.beyond_caps.set(false);
        match evaluate(&formula.expr, &self.scope(at, quantities, known)) {
            Ok(value) => Ok(Outcome::Value(value)),
            Err(error) => match Self::sort(error).map_err(|error| formula.diagnostic(&error))? {
                Outcome::Undefined(why) if quantities.beyond_caps.get() => {
                    Ok(Outcome::BeyondCaps(why))
                }
                outcome => Ok(outcome),
            },
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
