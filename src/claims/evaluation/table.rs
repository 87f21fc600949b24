//! The formulas of a table, evaluated cell by cell.

use crate::claim::{Paper, Table};
use crate::diagnostic::Diagnostic;
use crate::evaluation::context::{At, Known, Outcome, TableContext};
use crate::evaluation::library::Library;
use crate::evaluation::quantity::Quantities;
use crate::evaluation::row::RowDefinitions;
use crate::evaluation::settings::Settings;
use crate::evaluation::trace::{LevelCall, Noted};
use crate::exact::{Rational, RealCyclotomic};
use crate::formula::LocatedFormula;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Deref;

/// The context of a table, and the values of definitions that are the same in a whole row.
pub(crate) struct Evaluator<'a> {
    context: TableContext<'a>,
    pub(crate) rows: RowDefinitions,
}

impl<'a> Deref for Evaluator<'a> {
    type Target = TableContext<'a>;
    fn deref(&self) -> &TableContext<'a> {
        &self.context
    }
}

impl<'a> Evaluator<'a> {
    /// The evaluator of a table, with recovered values of parameters that the claim file leaves
    /// open.
    pub(crate) fn new(
        paper: &'a Paper,
        table: &'a Table,
        library: &'a Library<'a>,
        recovered: &BTreeMap<String, Rational>,
    ) -> Result<Evaluator<'a>, Diagnostic> {
        let context = TableContext::new(paper, table, library, recovered)?;
        let rows = RowDefinitions::new(&context);
        Ok(Evaluator { context, rows })
    }

    /// The value of a formula at a cell.
    pub(crate) fn evaluate(
        &self,
        formula: &LocatedFormula,
        at: At<'_>,
    ) -> Result<Outcome, Diagnostic> {
        let evaluated = self
            .within(at, |at, quantities, known| self.evaluate_with(formula, at, quantities, known));
        Ok(evaluated?.unwrap_or_else(|outcome| outcome))
    }

    /// Calls `evaluate` for a cell under its reading, with the quantities of its scheme and the
    /// known values of definitions.
    fn within<T>(
        &self,
        at: At<'_>,
        evaluate: impl FnOnce(At<'_>, &Quantities<'_>, &Known) -> Result<T, Diagnostic>,
    ) -> Result<Result<T, Outcome>, Diagnostic> {
        let (settings, known) = match &at.settings.copied {
            None => (None, None),
            Some(copied) => match self.copied(copied, at)? {
                Ok((settings, known)) => (Some(settings), Some(known)),
                Err(outcome) => return Ok(Err(outcome)),
            },
        };
        let at = At { settings: settings.as_ref().unwrap_or(at.settings), ..at };
        let quantities = match self.quantities(at)? {
            Ok(quantities) => quantities,
            Err(outcome) => return Ok(Err(outcome)),
        };
        self.evaluate_in(at, &quantities, known, evaluate).map(Ok)
    }

    /// As `within`, with these quantities; the values of the row's definitions take the place of
    /// `known` where that is empty.
    fn evaluate_in<T>(
        &self,
        at: At<'_>,
        quantities: &Quantities<'_>,
        known: Option<Known>,
        evaluate: impl FnOnce(At<'_>, &Quantities<'_>, &Known) -> Result<T, Diagnostic>,
    ) -> Result<T, Diagnostic> {
        match known.filter(|known| !known.is_empty()) {
            Some(known) => evaluate(at, quantities, &known),
            None => evaluate(at, quantities, &self.rows.of(&self.context, at, quantities)),
        }
    }

    /// The constants that the value of a cell as printed uses. Those of a definition with one value
    /// in each row are given only where this value is computed, at the first cell of the row.
    pub(crate) fn constants(&self, at: At<'_>) -> Result<Noted, Diagnostic> {
        let Ok(mut quantities) = self.quantities(at)? else { return Ok(Noted::default()) };
        quantities.noted = Some(RefCell::default());
        self.evaluate_in(at, &quantities, None, |at, quantities, known| {
            self.evaluate_with(&self.table.value, at, quantities, known)
        })?;
        Ok(quantities.noted.take().unwrap_or_default().into_inner())
    }

    /// The unstated parameters that the value of a cell as printed needs, and this value.
    /// Parameters are assumed one by one, as the evaluation meets them, up to one that has no known
    /// value.
    pub(crate) fn needed(
        &self,
        row: usize,
        column: usize,
    ) -> Result<(BTreeSet<String>, Outcome), Diagnostic> {
        let (mut needed, settings) = (BTreeSet::new(), Settings::default());
        loop {
            let at = At { row, column, assume: &needed, settings: &settings };
            match self.evaluate(&self.table.value, at)? {
                Outcome::Unstated(name) if needed.insert(name.clone()) => {}
                outcome => return Ok((needed, outcome)),
            }
        }
    }

    /// The call of `levels` whose result is the value of a cell; `None` where the value is no such
    /// result.
    pub(crate) fn level_call(&self, at: At<'_>) -> Option<LevelCall> {
        self.value_and_levels(at)?.1
    }

    /// The last call of `levels` in the evaluation of a cell's value.
    pub(crate) fn logarithm(&self, at: At<'_>) -> Option<LevelCall> {
        let evaluated = self.within(at, |at, quantities, known| {
            quantities.last_levels.take();
            self.evaluate_with(&self.table.value, at, quantities, known)?;
            Ok(quantities.last_levels.take())
        });
        evaluated.ok()?.ok()?
    }

    /// A cell's value, and the call of `levels` whose result it is, if there is one.
    pub(crate) fn value_and_levels(
        &self,
        at: At<'_>,
    ) -> Option<(RealCyclotomic, Option<LevelCall>)> {
        let evaluated = self.within(at, |at, quantities, known| {
            quantities.last_levels.take();
            let value = self.evaluate_with(&self.table.value, at, quantities, known)?;
            Ok((value, quantities.last_levels.take()))
        });
        let Ok(Ok((Outcome::Value(value), call))) = evaluated else { return None };
        let is_value =
            |call: &LevelCall| call.level.is_some_and(|level| value == RealCyclotomic::from(level));
        let call = call.filter(is_value);
        Some((value, call))
    }
}
