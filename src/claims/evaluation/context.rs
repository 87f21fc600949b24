//! The context of a table's formulas, cell by cell.

use crate::cap::Cap;
use crate::claim::{Axis, AxisEntry, Cell, LocatedReference, Paper, Promise, Table};
use crate::diagnostic::Diagnostic;
use crate::evaluation::choices::HEADER;
use crate::evaluation::copied::references;
use crate::evaluation::library::{Library, values};
use crate::evaluation::quantity::Quantities;
use crate::evaluation::reference::{Unresolved, in_parameters, scheme_error};
use crate::evaluation::settings::Settings;
use crate::exact::{Rational, RealCyclotomic, parse_decimal};
use crate::formula::{FormulaError, FormulaErrorKind, LocatedFormula, Node, Scope, evaluate};
use crate::scheme::{Instance, LocalRules};
use std::collections::{BTreeMap, BTreeSet};

/// The values of definitions that are known already.
pub(crate) type DefinitionValues = BTreeMap<String, RealCyclotomic>;

/// The value of a formula, or why it has none.
pub(crate) enum Outcome {
    Value(RealCyclotomic),
    Unstated(String),
    Undefined(String),
    BeyondCap(Cap),
}

/// The place of a cell, and how its formula is read.
#[derive(Clone, Copy)]
pub(crate) struct CellReading<'n> {
    pub(crate) row: usize,
    pub(crate) column: usize,
    /// The unstated parameters that have their assumed or recovered values, where these are known.
    pub(crate) assume: &'n BTreeSet<String>,
    /// How the formula is read.
    pub(crate) settings: &'n Settings,
}

/// A table, and everything that its formulas refer to.
pub(crate) struct TableContext<'a> {
    pub(crate) paper: &'a Paper,
    pub(crate) table: &'a Table,
    pub(crate) library: &'a Library<'a>,
    /// The values that are stated, for the paper or for the table.
    pub(crate) given: BTreeMap<String, Rational>,
    /// The values of unstated parameters that are assumed or recovered.
    pub(crate) assumed: BTreeMap<String, Rational>,
    /// The rounding intervals of the tolerances that are headers, in their order.
    tolerances: Vec<Option<(Rational, Rational)>>,
}

impl<'a> TableContext<'a> {
    pub(crate) fn new(
        paper: &'a Paper,
        table: &'a Table,
        library: &'a Library<'a>,
        recovered: &BTreeMap<String, Rational>,
    ) -> Result<TableContext<'a>, Diagnostic> {
        let mut given = values(&paper.given)?;
        given.retain(|name, _| !table.given.contains_key(name));
        given.extend(values(&table.given)?);
        let unstated = table.unstated.iter();
        let stated = unstated.filter_map(|(name, value)| Some((name, value.as_ref()?)));
        let mut assumed = values(stated)?;
        assumed.extend(recovered.iter().map(|(name, value)| (name.clone(), value.clone())));
        let header = |name: &String| table.axes().any(|axis| axis.name() == Some(name));
        given.retain(|name, _| !table.unstated.contains_key(name) && !header(name));
        let mut context =
            TableContext { paper, table, library, given, assumed, tolerances: Vec::new() };
        let interval = |entry: &AxisEntry| {
            let text = entry.read.as_ref().unwrap_or(&entry.printed);
            parse_decimal(text).ok().map(|decimal| decimal.interval())
        };
        let tolerances =
            table.axes().find(|axis| context.tolerance(axis)).map(|axis| &axis.entries);
        context.tolerances = tolerances.into_iter().flatten().map(interval).collect();
        Ok(context)
    }

    /// The rounding interval of a header that is a tolerance; `None` of other headers, and where it is no
    /// decimal.
    pub(crate) fn rounding(&self, axis: &Axis, place: usize) -> Option<&(Rational, Rational)> {
        self.tolerances.get(place).filter(|_| self.tolerance(axis))?.as_ref()
    }

    pub(crate) fn scope<'s>(
        &'s self,
        at: CellReading<'s>,
        functions: &'s Quantities<'s>,
        known: &'s DefinitionValues,
    ) -> Scope<'s, RealCyclotomic> {
        let definitions = at.settings.definitions.as_deref().unwrap_or(&self.paper.definitions);
        let mut scope = Scope::new(definitions, functions);
        scope = scope.with_formulas(&self.paper.given).with_formulas(&self.table.given);
        for (name, value) in &self.given {
            let value = at.settings.parameters.get(name).unwrap_or(value);
            scope = scope.with(name, value.clone().into());
        }
        for name in self.table.unstated.keys() {
            let value = at.settings.parameters.get(name).or_else(|| self.assumed.get(name));
            scope = match value.filter(|_| at.assume.contains(name)) {
                Some(value) => scope.with(name, value.clone().into()),
                None => scope.with_unstated(name),
            };
        }
        scope = scope.with_all(known);
        for (name, value) in self.header_values(at) {
            scope = scope.with(name, value.into());
        }
        scope
    }

    /// The parameters that have values in the headers of a cell, with these values. A header that
    /// is a scheme gives none.
    pub(crate) fn header_values(
        &self,
        at: CellReading<'_>,
    ) -> impl Iterator<Item = (&'a str, Rational)> {
        let rows = self.table.rows.as_ref().map(|axis| (axis, at.row));
        let axes = rows.into_iter().chain([(&self.table.columns, at.column)]);
        axes.filter_map(move |(axis, place)| {
            let (name, value) = axis.value(place)?;
            let other = at.settings.parameters.get(name).cloned();
            let own = || self.header(axis, place, value, at.settings);
            Some((name, other.unwrap_or_else(own)))
        })
    }

    pub(crate) fn headers(
        &self,
        row: usize,
        column: usize,
    ) -> impl Iterator<Item = (&'a Axis, &'a AxisEntry)> {
        let rows = self.table.rows.as_ref().map(|axis| (axis, &axis.entries[row]));
        let columns = &self.table.columns;
        rows.into_iter().chain([(columns, &columns.entries[column])])
    }

    /// The value of a header. Under some readings a tolerance is an end of its rounding interval.
    fn header(&self, axis: &Axis, place: usize, value: &Rational, settings: &Settings) -> Rational {
        let Some(word) = settings.word(&HEADER) else { return value.clone() };
        let interval = self.rounding(axis, place);
        let end = interval.map(|(low, high)| if word == "less" { low } else { high });
        end.unwrap_or(value).clone()
    }

    /// Whether the cells are depths.
    pub(crate) fn is_depth(&self) -> bool {
        matches!(self.table.promise, Some(Promise::Depth { .. }))
    }

    /// Whether the headers of the axis are the tolerances of a table of depths.
    pub(crate) fn tolerance(&self, axis: &Axis) -> bool {
        let Some(Promise::Depth { tolerance, .. }) = &self.table.promise else { return false };
        matches!(&tolerance.expr.node, Node::Name(name) if axis.name() == Some(name))
    }

    /// Whether the headers of an axis are tolerances.
    pub(crate) fn has_tolerance_headers(&self) -> bool {
        self.table.axes().any(|axis| self.tolerance(axis))
    }

    /// The printed number of a cell; `None` where there is none.
    pub(crate) fn printed(&self, at: CellReading<'_>) -> Option<Rational> {
        match &self.table.cells[at.row][at.column] {
            Cell::Lost | Cell::Blank => None,
            Cell::Printed(printed) => Some(printed.decimal.value()),
        }
    }

    /// The quantities of this cell's scheme.
    pub(crate) fn quantities<'s>(
        &'s self,
        at: CellReading<'s>,
    ) -> Result<Result<Quantities<'s>, Outcome>, Diagnostic> {
        match self.resolved(at) {
            Ok(quantities) => Ok(Ok(quantities)),
            Err(failure) => {
                let (located, error) = *failure;
                Self::unresolved(located, error).map(Err)
            }
        }
    }

    /// As [`quantities`](Self::quantities), with the error as it is: many readings try schemes that have no value at a
    /// cell, and need no words for it.
    pub(crate) fn resolved<'s>(
        &'s self,
        at: CellReading<'s>,
    ) -> Result<Quantities<'s>, Box<(&'a LocatedReference, Unresolved)>> {
        let mut quantities = Quantities {
            library: self.library,
            scheme: None,
            settings: at.settings,
            noted: None,
            last_levels: std::cell::RefCell::new(None),
        };
        let other = at.settings.scheme.and_then(|place| references(self.paper).get(place).copied());
        let located = other.or_else(|| self.table.scheme_at(at.row, at.column));
        let Some(located) = located else { return Ok(quantities) };
        let known = DefinitionValues::new();
        let scope = self.scope(at, &quantities, &known);
        match self.library.resolve(&located.reference, &scope) {
            Ok(scheme) => {
                quantities.scheme = Some(scheme);
                Ok(quantities)
            }
            Err(error) => Err(Box::new((located, error))),
        }
    }

    /// The ring that a reference means at a cell, with its scheme.
    pub(crate) fn ring(
        &self,
        located: &LocatedReference,
        at: CellReading<'_>,
    ) -> Result<Result<(Instance, LocalRules), Outcome>, Diagnostic> {
        let quantities = match self.quantities(at)? {
            Ok(quantities) => quantities,
            Err(outcome) => return Ok(Err(outcome)),
        };
        let known = DefinitionValues::new();
        let scope = self.scope(at, &quantities, &known);
        match self.library.ring_at(&located.reference, &scope) {
            Ok(ring) => Ok(Ok(ring)),
            Err(error) => Self::unresolved(located, error).map(Err),
        }
    }

    /// What the error of a reference means: an outcome of the cell, or an error of the claim file.
    pub(crate) fn unresolved(
        located: &LocatedReference,
        error: Unresolved,
    ) -> Result<Outcome, Diagnostic> {
        match error {
            Unresolved::Formula(error) => {
                Self::sort(error).map_err(|error| in_parameters(located, &error))
            }
            Unresolved::Scheme(error) => match error.cap() {
                Some(cap) => Ok(Outcome::BeyondCap(cap)),
                None => Err(scheme_error(located, &error)),
            },
        }
    }

    /// Whether the error of a formula is an outcome of the cell.
    pub(crate) fn is_outcome(error: &FormulaError) -> bool {
        use FormulaErrorKind::{DivisionByZero, Undefined, Unstated};
        matches!(error.kind, Unstated(_) | Undefined(_) | DivisionByZero)
            || error.kind.cap().is_some()
    }

    /// What the error of a formula means: an outcome of the cell, or (as `Err`) an error of the
    /// claim file.
    pub(crate) fn sort(error: FormulaError) -> Result<Outcome, FormulaError> {
        match error.kind {
            FormulaErrorKind::Unstated(name) => Ok(Outcome::Unstated(name)),
            FormulaErrorKind::Undefined(why) => Ok(Outcome::Undefined(why)),
            FormulaErrorKind::DivisionByZero => {
                Ok(Outcome::Undefined("the definition divides by zero".to_owned()))
            }
            _ => error.kind.cap().map(Outcome::BeyondCap).ok_or(error),
        }
    }

    /// Evaluates a formula at a cell with these quantities and these known values of definitions.
    pub(crate) fn evaluate_with(
        &self,
        formula: &LocatedFormula,
        at: CellReading<'_>,
        quantities: &Quantities<'_>,
        known: &DefinitionValues,
    ) -> Result<Outcome, Diagnostic> {
        match evaluate(&formula.expr, &self.scope(at, quantities, known)) {
            Ok(value) => Ok(Outcome::Value(value)),
            Err(error) => Self::sort(error).map_err(|error| formula.diagnostic(&error)),
        }
    }
}
