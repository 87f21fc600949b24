//! The values of cells under readings that take a quantity from another place of the paper.

use crate::bound::Rounded;
use crate::claim::{Axis, Cell};
use crate::evaluation::Copied;
use crate::evaluation::context::{CellReading, DefinitionValues, Outcome, TableContext};
use crate::evaluation::quantity::Quantities;
use crate::evaluation::reference::Unresolved;
use crate::evaluation::settings::{RowValues, Settings};
use crate::evaluation::table::Evaluator;
use crate::exact::{Rational, RealCyclotomic};
use std::collections::BTreeSet;
use std::rc::Rc;

impl Evaluator<'_> {
    /// The known values of definitions for a cell whose reading takes a quantity from another place,
    /// or the outcome of the cell if there is no such quantity.
    pub(crate) fn copied(
        &self,
        copied: &Copied,
        at: CellReading<'_>,
        quantities: &Quantities<'_>,
    ) -> Result<Rc<DefinitionValues>, Outcome> {
        let of = match copied {
            // These give no definition another value.
            Copied::Tolerance { .. } | Copied::Numbers { .. } => {
                return Ok(self.of_row(at, quantities));
            }
            Copied::Printed { of, table, .. } => {
                let printed = self.printed_elsewhere(table, at);
                let value = printed.map(RealCyclotomic::from).ok_or_else(|| missing(of))?;
                return Ok(self.with_copied(of, value, at, quantities));
            }
            Copied::Parameter { of, .. } | Copied::Scheme { of, .. } => of,
        };
        let compute = || {
            let settings = at.settings.without_copied();
            let settings = match copied {
                Copied::Parameter { name, value, .. } => settings.with_parameter(name, value),
                Copied::Scheme { number, .. } => settings.with_scheme(*number),
                Copied::Printed { .. } | Copied::Tolerance { .. } | Copied::Numbers { .. } => {
                    settings
                }
            };
            let value = self.definition(of, CellReading { settings: &settings, ..at })?;
            Ok(self.with_copied(of, value, at, quantities))
        };
        if self.rows.fixes(self, of) {
            Self::once_in_row(at, quantities, compute)
        } else {
            compute()
        }
    }

    /// The values of the row's definitions that do not depend on `of`, and this value for `of`.
    fn with_copied(
        &self,
        of: &str,
        value: RealCyclotomic,
        at: CellReading<'_>,
        quantities: &Quantities<'_>,
    ) -> Rc<DefinitionValues> {
        let mut known = self.rows.of(self, at, quantities);
        known.retain(|name, _| !self.leads_to(name, of, at.settings));
        known.insert(of.to_owned(), value);
        Rc::new(known)
    }

    /// The reading of a cell with the tolerance before it was rounded.
    pub(crate) fn at_computed_tolerance(&self, line: usize, at: CellReading<'_>) -> Settings {
        let mut settings = at.settings.without_copied();
        let found = self.computed_tolerance(line, CellReading { settings: &settings, ..at });
        if let Some((name, value)) = found {
            settings.parameters.insert(name.to_owned(), value);
            settings.rows = RowValues::default();
        }
        settings
    }

    /// The value of a definition; a formula that is wrong under these settings has none.
    fn definition(&self, name: &str, at: CellReading<'_>) -> Result<RealCyclotomic, Outcome> {
        match &self.resolved(at) {
            Ok(quantities) => {
                if let Some(value) = self.rows.one(self, at, quantities, name) {
                    return Ok(value);
                }
            }
            Err(failure) => {
                if let Unresolved::Formula(error) = &failure.1
                    && !TableContext::is_outcome(error)
                {
                    return Err(missing(name));
                }
            }
        }
        let definitions = at.settings.definitions.as_deref().unwrap_or(&self.paper.definitions);
        match self.evaluate(&definitions[name], at) {
            Ok(Outcome::Value(value)) => Ok(value),
            Ok(outcome) => Err(outcome),
            Err(_) => Err(missing(name)),
        }
    }

    /// Whether the definition `name` is `of`, or uses it, directly or through others.
    fn leads_to(&self, name: &str, of: &str, settings: &Settings) -> bool {
        let definitions = settings.definitions.as_deref().unwrap_or(&self.paper.definitions);
        let (mut met, mut waiting) = (BTreeSet::new(), vec![name]);
        while let Some(name) = waiting.pop() {
            if name == of {
                return true;
            }
            if let Some(definition) = definitions.get(name)
                && met.insert(name)
            {
                waiting.extend(definition.expr.names());
            }
        }
        false
    }

    /// The number that another table prints for the headers and the scheme of a cell.
    fn printed_elsewhere(&self, table: &str, at: CellReading<'_>) -> Option<Rational> {
        let other = self.paper.tables.iter().find(|other| other.id == table)?;
        let scheme = self.table.scheme_at(at.row, at.column);
        let scheme = scheme.map(|located| located.reference.to_string());
        let place = |axis: &Axis| {
            let Some(name) = axis.name() else {
                let scheme = scheme.as_ref()?;
                let mut schemes = axis.schemes().iter();
                return schemes.position(|other| other.reference.to_string() == *scheme);
            };
            let value = self.parameter(name, at)?;
            (0..axis.entries.len()).find(|&i| axis.value(i).is_some_and(|(_, v)| *v == value))
        };
        let row = other.rows.as_ref().map_or(Some(0), place)?;
        match other.cells.get(row)?.get(place(&other.columns)?)? {
            Cell::Printed(printed) => Some(printed.decimal.value()),
            Cell::Lost | Cell::Blank => None,
        }
    }

    /// The value that a parameter has at a cell.
    fn parameter(&self, name: &str, at: CellReading<'_>) -> Option<Rational> {
        let header = self.header_values(at).find(|(other, _)| *other == name);
        let assumed = || self.assumed.get(name).filter(|_| at.assume.contains(name)).cloned();
        header.map(|(_, value)| value).or_else(|| self.given.get(name).cloned()).or_else(assumed)
    }

    /// The tolerance of a cell before it was rounded, if the depth of the cell in this row or
    /// column is a whole number of levels. Let ε be the printed tolerance, and let that depth be
    /// the logarithm of x to the base r, rounded; k is the integer nearest to the logarithm. As x
    /// is proportional to the tolerance, the tolerance was ε·r^k/x. `None` if this does not round
    /// to the printed number, or if the depth is not k with it.
    fn computed_tolerance(&self, line: usize, at: CellReading<'_>) -> Option<(&str, Rational)> {
        let (axis, place) = match &self.table.rows {
            Some(rows) if self.tolerance(rows) => (rows, at.row),
            _ => (&self.table.columns, at.column),
        };
        let in_rows = std::ptr::eq(axis, &raw const self.table.columns);
        let there = if in_rows {
            CellReading { row: line, ..at }
        } else {
            CellReading { column: line, ..at }
        };
        let (name, printed) = axis.value(place)?;
        let (low, high) = self.rounding(axis, place)?;
        let call = self.logarithm(there)?;
        let (ratio, x) = (call.ratio.as_rational()?, call.x.as_rational()?);
        let level = self.library.log_level(&call.ratio, &call.x, Rounded::Nearest).ok()?;
        let power = ratio.pow(i32::try_from(level).ok()?);
        let value = &(printed * &power) / x;
        if !(low..=high).contains(&&value) {
            return None;
        }
        let settings = at.settings.with_parameter(name, &value);
        let then = self.logarithm(CellReading { settings: &settings, ..there })?;
        let whole = then.ratio == call.ratio && then.x == RealCyclotomic::from(power);
        whole.then_some((name, value))
    }
}

fn missing(name: &str) -> Outcome {
    Outcome::Undefined(format!("`{name}` has no value there"))
}
