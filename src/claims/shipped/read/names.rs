//! Checks of names: each has one meaning.

use super::reader::Reader;
use crate::diagnostic::Diagnostic;
use crate::formula::LocatedFormula;
use crate::shipped::claim::ShippedClaim;
use std::collections::BTreeMap;

impl Reader<'_> {
    /// Checks that no index of a table has the name of a definition.
    pub(super) fn index_names(
        &self,
        claim: &ShippedClaim,
        definitions: &BTreeMap<String, LocatedFormula>,
    ) -> Result<(), Diagnostic> {
        for index in &claim.indices {
            if let Some(definition) = definitions.get(&index.name) {
                let message =
                    format!("`{}` is an index here, and the name of a definition", index.name);
                return Err(self
                    .error(claim.span.clone(), message)
                    .with_place(definition.span.clone(), "the definition")
                    .with_help("give one of them another name"));
            }
        }
        let others = claim.conventions.iter().flat_map(|other| other.exact.formulas());
        for formula in claim.exact.formulas().iter().chain(others) {
            self.fold_names(formula, claim, definitions)?;
        }
        for definition in definitions.values() {
            self.fold_names(definition, claim, definitions)?;
        }
        Ok(())
    }

    /// Checks that no index of a sum hides another name.
    fn fold_names(
        &self,
        formula: &LocatedFormula,
        claim: &ShippedClaim,
        definitions: &BTreeMap<String, LocatedFormula>,
    ) -> Result<(), Diagnostic> {
        let is_used = |name: &str| {
            definitions.contains_key(name) || claim.indices.iter().any(|index| index.name == name)
        };
        match formula.expr.indices().into_iter().find(|name| is_used(name)) {
            None => Ok(()),
            Some(name) => {
                let message = format!("the index `{name}` hides another meaning of this name");
                Err(self
                    .error(formula.span.clone(), message)
                    .with_help("give the index of the sum another name"))
            }
        }
    }
}
