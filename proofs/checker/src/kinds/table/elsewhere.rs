//! The values of cells under readings that take a quantity from another place of the paper.

use super::claim::{Asked, Instead, Place, Scoped, Table};
use super::copied::Copied;
use crate::claims::{Headers, Paper, printed};
use crate::formulas::{Expr, Head, Scope};
use crate::functions::depth::depth;
use crate::numbers::{Decimal, Value, interval};
use crate::text::Stop;
use num_traits::Pow;
use std::collections::BTreeMap;

/// The schemes of all tables of a paper: each text once, in their order.
pub fn references<'a>(paper: &Paper<'a>) -> Result<Vec<&'a str>, Stop> {
    let mut found = Vec::new();
    for claim in paper.file.list("table") {
        let axes = Headers::of(claim)?;
        let headers = axes.iter().flat_map(|axis| axis.schemes().iter().copied());
        for reference in claim.text("scheme").into_iter().chain(headers) {
            if !found.contains(&reference) {
                found.push(reference);
            }
        }
    }
    Ok(found)
}

/// Follows a formula that is only the name of a definition to the formula of this definition.
pub fn behind_names<'f>(table: &'f Table<'_>, mut formula: &'f Expr) -> &'f Expr {
    while let Expr::Name(name) = formula
        && let Some(definition) = table.paper.definitions.get(name)
    {
        formula = definition;
    }
    formula
}

impl Table<'_> {
    /// The scope of a cell under a reading that takes this quantity from another place.
    pub fn scope_with<'s>(
        &'s self,
        copied: &Copied<'_>,
        asked: Asked<'s, '_>,
    ) -> Result<Scoped<'s>, Stop> {
        let own = || self.own_scope(asked, &Instead::default());
        let (of, value) = match copied {
            Copied::Tolerance(line) => {
                let mut instead = Instead::default();
                instead.values.extend(self.tolerance_at(*line, asked)?);
                return self.own_scope(asked, &instead);
            }
            Copied::Numbers(first) => {
                let mut scoped = own()?;
                scoped.0.first = *first;
                return Ok(scoped);
            }
            Copied::Printed(of, table) => (of, self.printed_in(table, asked.at, &own()?.0)?),
            Copied::Parameter(of, name, value) => {
                let value = Value::from(value.clone());
                let values = BTreeMap::from([((*name).to_owned(), value)]);
                let instead = Instead { values, scheme: None };
                (of, self.definition(of, asked, &instead)?)
            }
            Copied::Scheme(of, number) => {
                let scheme = references(self.paper)?.get(*number).copied();
                let instead = Instead { values: BTreeMap::new(), scheme };
                (of, self.definition(of, asked, &instead)?)
            }
        };
        let mut scoped = own()?;
        scoped.0.values.insert((*of).to_owned(), value);
        Ok(scoped)
    }

    /// The value of a definition with some quantities of a cell replaced. A formula that is wrong
    /// with these has no value.
    fn definition(
        &self,
        name: &str,
        asked: Asked<'_, '_>,
        instead: &Instead<'_>,
    ) -> Result<Value, Stop> {
        let scope = self.own_scope(asked, instead);
        let value = scope.and_then(|(scope, _)| scope.value(&Expr::Name(name.to_owned())));
        value.map_err(none_if_wrong)
    }

    /// The number that a table prints at the headers of a cell with this scope.
    fn printed_in(&self, id: &str, at: Place, scope: &Scope<'_>) -> Result<Value, Stop> {
        let claims = self.paper.file.list("table").iter();
        let claim = claims.into_iter().find(|claim| claim.text("id") == Some(id));
        let number = claim.and_then(|claim| {
            let place = |axis: &str| match claim.get(axis) {
                None => Some(0),
                Some(axis) => match Headers::read(axis).ok()? {
                    Headers::Values(axis) => {
                        let own = scope.values.get(axis.name)?.rational()?;
                        axis.entries.iter().position(|(_, value)| *value == own)
                    }
                    Headers::Schemes(schemes) => {
                        let own = self.scheme(at)?;
                        schemes.iter().position(|scheme| *scheme == own)
                    }
                },
            };
            let row = claim.list("cells").get(place("rows")?)?;
            let (_, read) = printed(row.as_list().get(place("columns")?)?)?;
            Some(Decimal::printed(read)?.value)
        });
        number.map(Value::from).ok_or(NONE)
    }

    /// The tolerance of a cell before it was rounded, if the depth of the cell in this row or
    /// column is a whole number. Let ε be the printed tolerance and that depth the logarithm of x
    /// to the base r, with k the nearest integer. Then the tolerance is ε·r^k/x. `None` if this
    /// does not round to the printed number, or if the depth is not k with it.
    fn tolerance_at(
        &self,
        line: usize,
        asked: Asked<'_, '_>,
    ) -> Result<Option<(String, Value)>, Stop> {
        let at = asked.at;
        let [rows, columns] =
            self.axes.each_ref().map(|axis| axis.as_ref().and_then(Headers::axis));
        let (axis, place, there) = match rows.filter(|own| self.tolerance == Some(own.name)) {
            Some(rows) => (Some(rows), at.0, (at.0, line)),
            None => (columns, at.1, (line, at.1)),
        };
        let Some(axis) = axis else { return Ok(None) };
        let (text, printed) = &axis.entries[place];
        let decimal = Decimal::read(text).filter(|_| self.places().any(|other| other == there));
        let Some(decimal) = decimal else { return Ok(None) };
        let call = |instead: &Instead<'_>| {
            let there = Asked { at: there, ..asked };
            let scope = self.own_scope(there, instead).map_err(none_if_wrong)?.0;
            let Expr::Of(Head::Call(_, _), parts) = behind_names(self, &self.value) else {
                return Err(NONE);
            };
            let [ratio, of, ..] = &parts[..] else { return Err(NONE) };
            let values = (scope.value(ratio), scope.value(of));
            let (ratio, of) = (values.0.map_err(none_if_wrong)?, values.1.map_err(none_if_wrong)?);
            Ok((ratio.rational().ok_or(NONE)?, of.rational().ok_or(NONE)?))
        };
        let found = call(&Instead::default()).and_then(|(ratio, x)| {
            let (r, of) = (Value::from(ratio.clone()), Value::from(x.clone()));
            let level = depth(self.paper.library.meter, &r, &of, 1)?;
            let power = Pow::pow(&ratio, i32::try_from(level).map_err(|_| NONE)?);
            let value = printed * &power / x;
            let (low, high) = interval(&decimal, "nearest");
            if value < low || value > high {
                return Err(NONE);
            }
            let entry = (axis.name.to_owned(), Value::from(value));
            let values = BTreeMap::from([entry.clone()]);
            let then = call(&Instead { values, scheme: None })?;
            if then == (ratio, power) { Ok(entry) } else { Err(NONE) }
        });
        match found {
            Ok(entry) => Ok(Some(entry)),
            Err(Stop::Undefined(_) | Stop::Unstated(_)) => Ok(None),
            Err(stop) => Err(stop),
        }
    }
}

/// The error where the other place has no such quantity.
const NONE: Stop = Stop::Undefined("there is no such quantity at that place");

/// A formula that is wrong at another place has no value there.
fn none_if_wrong(stop: Stop) -> Stop {
    match stop {
        Stop::Wrong(_) | Stop::OtherRoot => NONE,
        stop => stop,
    }
}
