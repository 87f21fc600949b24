//! The values of the parameters of a scheme, and of its formulas.

use super::definition::{ParameterSpec, SchemeDefinition};
use super::error::SchemeError;
use super::typed::symbol::states;
use crate::cap::Cap;
use crate::diagnostic::Diagnostic;
use crate::exact::Rational;
use crate::formula::{FormulaErrorKind, FreeNames, LocatedFormula, Scope, Value, evaluate};
use std::collections::BTreeMap;
use std::ops::Range;

impl SchemeDefinition {
    /// The given values, completed by defaults.
    pub(super) fn complete<V: Value>(
        &self,
        values: &BTreeMap<String, V>,
    ) -> Result<BTreeMap<String, V>, SchemeError> {
        if let Some(name) = values.keys().find(|name| !self.parameters.contains_key(*name)) {
            return Err(SchemeError::UnknownParameter {
                scheme: self.name.clone(),
                parameter: name.clone(),
                known: self.parameters.keys().cloned().collect(),
            });
        }
        let mut complete = values.clone();
        for (name, spec) in &self.parameters {
            self.check_least(name, spec, values)?;
            if complete.contains_key(name) {
                continue;
            }
            complete.insert(name.clone(), self.default_value(name, values)?);
        }
        Ok(complete)
    }

    /// The default of a parameter, in whose formula the parameters that are given have their values.
    ///
    /// # Errors
    /// When it has no default, or the formula has no value.
    pub(super) fn default_value<V: Value>(
        &self,
        name: &str,
        given: &BTreeMap<String, V>,
    ) -> Result<V, SchemeError> {
        let missing = |parameter: &str| SchemeError::MissingParameter {
            scheme: self.name.clone(),
            parameter: parameter.to_owned(),
        };
        let default = self.parameters.get(name).and_then(|spec| spec.default.as_ref());
        let default = default.ok_or_else(|| missing(name))?;
        let none = BTreeMap::new();
        let open = |name: &String| self.parameters.contains_key(name) && !given.contains_key(name);
        if let Some(other) = FreeNames::new(&none).of(&default.expr).into_iter().find(open) {
            return Err(missing(&other));
        }
        evaluate(&default.expr, &Scope::new(&none, &()).with_all(given))
            .map_err(|error| SchemeError::File(Box::new(default.diagnostic(&error))))
    }

    /// An error if a parameter is below its least value. Only rational values are
    /// compared.
    fn check_least<V: Value>(
        &self,
        name: &str,
        spec: &ParameterSpec,
        values: &BTreeMap<String, V>,
    ) -> Result<(), SchemeError> {
        let (Some(formula), Some(value)) = (&spec.least, values.get(name)) else { return Ok(()) };
        let least: V = self.value(formula, &BTreeMap::new(), &[])?;
        match (least.as_rational(), value.as_rational()) {
            (Some(least), Some(rational)) if rational < least => Err(SchemeError::TooSmall {
                scheme: self.name.clone(),
                parameter: name.to_owned(),
                least: least.to_string(),
                value: value.to_string(),
                about: spec.about.clone(),
            }),
            _ => Ok(()),
        }
    }

    pub(super) fn value<V: Value>(
        &self,
        formula: &LocatedFormula,
        parameters: &BTreeMap<String, V>,
        indices: &[(&str, i64)],
    ) -> Result<V, SchemeError> {
        let mut scope = Scope::new(&self.definitions, &()).with_all(parameters);
        for (name, index) in indices {
            scope = scope.with(*name, V::from_rational(&Rational::from(*index)));
        }
        evaluate(&formula.expr, &scope).map_err(|error| {
            let diagnostic = formula.diagnostic(&error);
            SchemeError::File(Box::new(match &error.kind {
                FormulaErrorKind::UnknownName { name, .. } if error.definition.is_none() => {
                    diagnostic.with_help(states(name))
                }
                _ => diagnostic,
            }))
        })
    }

    pub(super) fn integer<V: Value>(
        &self,
        formula: &LocatedFormula,
        parameters: &BTreeMap<String, V>,
        indices: &[(&str, i64)],
        what: &str,
        range: Range<i64>,
    ) -> Result<i64, SchemeError> {
        let value = self.value(formula, parameters, indices)?;
        let integer = value.as_rational().filter(Rational::is_integer);
        let found = integer.as_ref().and_then(|value| value.numerator().to_i64());
        found.filter(|value| range.contains(value)).ok_or_else(|| {
            let (low, high) = (range.start, range.end - 1);
            let message = format!("{what} is {value}; it must be an integer from {low} to {high}");
            // A number below the range is a cap only where the range has two signs.
            let size = |value: Rational| if low < 0 { value.abs() } else { value };
            let beyond = integer.is_some_and(|value| size(value) > Rational::from(high));
            let cap = beyond.then(|| Cap::new(what.to_owned(), high.unsigned_abs()));
            let diagnostic = Diagnostic::new(&formula.source, formula.span.clone(), message);
            SchemeError::File(Box::new(diagnostic.with_cap(cap)))
        })
    }
}
