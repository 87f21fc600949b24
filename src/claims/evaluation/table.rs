//! The formulas of a table, evaluated cell by cell.

use crate::claim::{Paper, Table};
use crate::diagnostic::Diagnostic;
use crate::evaluation::Copied;
use crate::evaluation::context::{CellReading, DefinitionValues, Outcome, TableContext};
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
use std::rc::Rc;

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
        at: CellReading<'_>,
    ) -> Result<Outcome, Diagnostic> {
        let evaluated = self
            .within(at, |at, quantities, known| self.evaluate_with(formula, at, quantities, known));
        Ok(evaluated?.unwrap_or_else(|outcome| outcome))
    }

    /// Calls `evaluate` for a cell under its reading, with the quantities of its scheme and the
    /// known values of definitions.
    fn within<T>(
        &self,
        at: CellReading<'_>,
        evaluate: impl FnOnce(
            CellReading<'_>,
            &Quantities<'_>,
            &DefinitionValues,
        ) -> Result<T, Diagnostic>,
    ) -> Result<Result<T, Outcome>, Diagnostic> {
        let computed = match &at.settings.copied {
            Some(Copied::Tolerance { line, .. }) => Some(self.at_computed_tolerance(*line, at)),
            _ => None,
        };
        let at = CellReading { settings: computed.as_ref().unwrap_or(at.settings), ..at };
        let quantities = match self.quantities(at)? {
            Ok(quantities) => quantities,
            Err(outcome) => return Ok(Err(outcome)),
        };
        let known = match &at.settings.copied {
            None => self.of_row(at, &quantities),
            Some(copied) => match self.copied(copied, at, &quantities) {
                Ok(known) => known,
                Err(outcome) => return Ok(Err(outcome)),
            },
        };
        evaluate(at, &quantities, &known).map(Ok)
    }

    /// The values of the row's definitions.
    pub(crate) fn of_row(
        &self,
        at: CellReading<'_>,
        quantities: &Quantities<'_>,
    ) -> Rc<DefinitionValues> {
        Self::once_in_row(at, quantities, || {
            Ok(Rc::new(self.rows.of(&self.context, at, quantities)))
        })
        .unwrap_or_default()
    }

    /// The values of definitions under the reading of a cell, which are the same in its row. They are
    /// computed once for each scheme, and each set of assumed parameters.
    pub(crate) fn once_in_row(
        at: CellReading<'_>,
        quantities: &Quantities<'_>,
        compute: impl FnOnce() -> Result<Rc<DefinitionValues>, Outcome>,
    ) -> Result<Rc<DefinitionValues>, Outcome> {
        let scheme = quantities.scheme.as_ref().map_or(&[][..], |scheme| &scheme.instances);
        if let Some(known) = at.settings.rows.get(at.row, scheme, at.assume) {
            return Ok(known);
        }
        let values = compute()?;
        at.settings.rows.keep(at.row, scheme, at.assume, &values);
        Ok(values)
    }

    /// The constants that the value of a cell as printed uses. Those of a definition with one value
    /// in each row are given only where this value is computed, at the first cell of the row.
    pub(crate) fn constants(&self, at: CellReading<'_>) -> Result<Noted, Diagnostic> {
        let Ok(mut quantities) = self.quantities(at)? else { return Ok(Noted::default()) };
        quantities.noted = Some(RefCell::default());
        let known = self.of_row(at, &quantities);
        self.evaluate_with(&self.table.value, at, &quantities, &known)?;
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
            let at = CellReading { row, column, assume: &needed, settings: &settings };
            match self.evaluate(&self.table.value, at)? {
                Outcome::Unstated(name) if needed.insert(name.clone()) => {}
                outcome => return Ok((needed, outcome)),
            }
        }
    }

    /// The call of `levels` whose result is the value of a cell; `None` where the value is no such
    /// result.
    pub(crate) fn level_call(&self, at: CellReading<'_>) -> Option<LevelCall> {
        self.value_and_levels(at).ok()?.1
    }

    /// The last call of `levels` in the evaluation of a cell's value.
    pub(crate) fn logarithm(&self, at: CellReading<'_>) -> Option<LevelCall> {
        let evaluated = self.within(at, |at, quantities, known| {
            quantities.last_levels.take();
            self.evaluate_with(&self.table.value, at, quantities, known)?;
            Ok(quantities.last_levels.take())
        });
        evaluated.ok()?.ok()?
    }

    /// The outcome of a cell, and the call of `levels` whose result its value is, if there is one.
    pub(crate) fn value_and_levels(
        &self,
        at: CellReading<'_>,
    ) -> Result<(Outcome, Option<LevelCall>), Diagnostic> {
        let evaluated = self.within(at, |at, quantities, known| {
            quantities.last_levels.take();
            let value = self.evaluate_with(&self.table.value, at, quantities, known)?;
            Ok((value, quantities.last_levels.take()))
        });
        let (outcome, call) = evaluated?.unwrap_or_else(|outcome| (outcome, None));
        let is_value = |call: &LevelCall| {
            let level = call.level.map(RealCyclotomic::from);
            matches!((&outcome, level), (Outcome::Value(value), Some(level)) if *value == level)
        };
        let call = call.filter(is_value);
        Ok((outcome, call))
    }
}
