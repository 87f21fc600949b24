//! The exact values of the numbers of a table.

use super::claim::{ExactValues, Project, ShippedClaim};
use super::finding::Early;
use super::number::{Settled as _, nearest_single};
use crate::diagnostic::Diagnostic;
use crate::exact::{Rational, RealExpression};
use crate::formula::{FreeNames, LocatedFormula, Scope, evaluate};
use std::collections::{BTreeMap, BTreeSet};

/// Computes the exact values of a table.
pub(super) struct Values<'a> {
    claim: &'a ShippedClaim,
    definitions: &'a BTreeMap<String, LocatedFormula>,
    /// Those that do not depend on an index, computed once.
    constants: BTreeMap<&'a str, RealExpression>,
    early: Option<(&'a str, Early)>,
}

impl<'a> Values<'a> {
    /// The values as the formulas say; with `early`, where the definition of this name is rounded before it is used.
    pub(super) fn new(
        project: &'a Project,
        claim: &'a ShippedClaim,
        early: Option<(&'a str, Early)>,
    ) -> Values<'a> {
        let definitions = &project.definitions;
        let mut values = Values { claim, definitions, constants: BTreeMap::new(), early };
        let mut free = FreeNames::new(definitions);
        for (name, definition) in definitions {
            let depends = !free.of_name(name).is_empty();
            if depends || early.is_some_and(|(rounded, _)| rounded == name) {
                continue;
            }
            // A definition without a value is an error only where it is used.
            if let Ok(value) = values.value(definition, &[]) {
                values.constants.insert(name, value);
            }
        }
        values
    }

    /// The exact value of number `place`, under these formulas.
    pub(super) fn at(
        &self,
        exact: &ExactValues,
        place: usize,
    ) -> Result<RealExpression, Diagnostic> {
        self.value(exact.of(place), &self.claim.at(place))
    }

    fn value(
        &self,
        formula: &LocatedFormula,
        indices: &[(&str, i64)],
    ) -> Result<RealExpression, Diagnostic> {
        let mut scope = Scope::new(self.definitions, &());
        for (name, value) in &self.constants {
            scope = scope.with(*name, value.clone());
        }
        for &(name, value) in indices {
            scope = scope.with(name, RealExpression::from(Rational::from(value)));
        }
        if let Some((name, early)) = self.early {
            // What the definition itself needs is not rounded.
            let definition = &self.definitions[name];
            let value = evaluate(&definition.expr, &scope);
            let value = value.map_err(|error| definition.diagnostic(&error))?;
            if let Some(rounded) = early.of(&value) {
                scope = scope.with(name, RealExpression::from(rounded));
            }
        }
        evaluate(&formula.expr, &scope).map_err(|error| formula.diagnostic(&error))
    }
}

impl Project {
    /// The names of the definitions that formulas use, directly or not, in the order of the alphabet.
    #[must_use]
    pub fn used_by(&self, exact: &ExactValues) -> Vec<&str> {
        let mut used = BTreeSet::new();
        let mut waiting: Vec<&LocatedFormula> = exact.formulas().iter().collect();
        while let Some(formula) = waiting.pop() {
            for name in formula.expr.names() {
                if let Some((name, definition)) = self.definitions.get_key_value(name)
                    && used.insert(name.as_str())
                {
                    waiting.push(definition);
                }
            }
        }
        used.into_iter().collect()
    }
}

impl Early {
    /// The number, rounded in this way, if it is decided which number this is.
    fn of(self, value: &RealExpression) -> Option<Rational> {
        match self {
            Early::Places(digits) => value.settled(|value| {
                let scale = Rational::power_of_ten(i32::try_from(digits).unwrap_or(0));
                Rational::from((value * &scale).round_half_even()) / scale
            }),
            Early::Cut(digits) => value.settled(|value| {
                let scale = Rational::power_of_ten(i32::try_from(digits).unwrap_or(0));
                let size = Rational::from((value.abs() * &scale).floor()) / scale;
                if value.sign() < 0 { -size } else { size }
            }),
            Early::Single => value.settled(nearest_single).flatten(),
        }
    }
}
