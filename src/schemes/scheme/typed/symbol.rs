//! Masks by their symbols.

use super::sum::{EVERYWHERE, Sum, lacks_factor, no_arity};
use super::text::{MASK, is_sum};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::formula::{
    FormulaErrorKind, FreeNames, Functions, Laurent, LocatedFormula, SYMBOL_VARIABLE, Scope, Value,
    evaluate,
};
use crate::scheme::Rules;
use crate::scheme::composed::composed_of;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;

/// The longest sum that a message states.
const MAX_WORDS: usize = 200;

/// A symbol a(z) = Σ_k a_k z^k, and the arity n.
///
/// The scheme is x'_m = Σ_j a_{m − nj} x_j. So rule α has a_{α − n(o + j)} at place j, and o is the least number for which
/// some rule has a coefficient at place 0: −⌊K/n⌋ for the highest power K.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::scheme) struct SymbolFormula {
    /// The formula in `z`.
    pub(in crate::scheme) formula: LocatedFormula,
    /// The arity, if it is stated; otherwise it is the value at z = 1.
    pub(in crate::scheme) arity: Option<LocatedFormula>,
}

/// How the arity of a symbol is found.
#[derive(Clone, Copy)]
pub(in crate::scheme) enum Arity {
    /// The coefficients of a scheme add up to it, and it may be stated too.
    OfSum(Option<usize>),
    /// That of a filter.
    OfFilter(usize),
}

impl SymbolFormula {
    /// The symbol of a text that stands at this place, without an arity.
    ///
    /// # Errors
    /// When it is no formula, or has another `z` than its variable.
    pub(in crate::scheme) fn read(
        source: &Arc<SourceText>,
        span: Range<usize>,
        text: &str,
    ) -> Result<SymbolFormula, Diagnostic> {
        let formula = LocatedFormula::read(source, span.clone(), text).map_err(|error| {
            error.with_help("write products with `*` and powers with `^`: z^-2*(1 + 4*z)/5")
        })?;
        if formula.expr.indices().contains(SYMBOL_VARIABLE) {
            let message = "`z` is the variable of the symbol, and no index";
            return Err(Diagnostic::new(source, span, message)
                .with_help("take another name for the index of the sum"));
        }
        Ok(SymbolFormula { formula, arity: None })
    }

    /// The names of its parameters.
    pub(super) fn names(&self, definitions: &BTreeMap<String, LocatedFormula>) -> BTreeSet<String> {
        parameters(&self.formula, definitions, &[SYMBOL_VARIABLE])
    }

    fn error(&self, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(&self.formula.source, self.formula.span.clone(), message)
    }

    /// The arity of the mask with these coefficients in a row: as `stated`, or else their sum.
    ///
    /// # Errors
    /// When the sum is no arity, or a factor is missing, which the error names.
    fn arity<V: Value + PartialEq>(
        &self,
        coefficients: Vec<V>,
        stated: Option<usize>,
    ) -> Result<usize, Diagnostic> {
        let sum = Sum::of(coefficients)
            .map_err(|error| self.error(error.to_string()).with_cap(error.cap()))?;
        let arity = sum.arity();
        let is_right = match stated {
            Some(n) => arity == Some(n),
            None => arity.is_some_and(|n| sum.is_uniform(n)),
        };
        let mut factors = if is_right { Vec::new() } else { sum.factors() };
        factors.retain(|(n, _)| stated.is_none_or(|stated| *n == stated));
        let words = sum.words();
        if let ([_, ..], Some(words)) = (&factors[..], &words) {
            let text = self.formula.text.trim();
            let symbol = if is_sum(&self.formula) { format!("({text})") } else { text.to_owned() };
            return Err(self.error(lacks_factor(words, &factors, &symbol)));
        }
        // Where the sums of the rules are not 1, the mask says which.
        if let Some(arity) = stated.or(arity) {
            return Ok(arity);
        }
        let found: String = words.unwrap_or_else(|| sum.total().to_string());
        let found = if found.len() > MAX_WORDS { "do not" } else { &format!("add up to {found}") };
        let help = if sum.total().as_rational().is_some() { MASK } else { EVERYWHERE };
        Err(self.error(no_arity(found)).with_help(help))
    }

    /// The rules at these values of the parameters, and the offset.
    ///
    /// # Errors
    /// When the formula has no value, or the sum of the coefficients is no arity.
    pub(in crate::scheme) fn rules<V: Value + PartialEq>(
        &self,
        definitions: &BTreeMap<String, LocatedFormula>,
        parameters: &BTreeMap<String, V>,
        arity: Arity,
        functions: &dyn Functions<Laurent<V>>,
    ) -> Result<(Vec<Vec<V>>, i64), Diagnostic> {
        let constant =
            |(name, value): (&String, &V)| (name.clone(), Laurent::constant(value.clone()));
        let constants: BTreeMap<String, Laurent<V>> = parameters.iter().map(constant).collect();
        let scope = Scope::new(definitions, functions)
            .with_all(&constants)
            .with(SYMBOL_VARIABLE, Laurent::variable());
        let value = evaluate(&self.formula.expr, &scope).map_err(|error| {
            let diagnostic = self.formula.diagnostic(&error);
            match &error.kind {
                FormulaErrorKind::UnknownName { name, .. } if error.definition.is_none() => {
                    diagnostic.with_help(states(name))
                }
                _ => diagnostic,
            }
        })?;
        let Some((low, high)) = value.powers() else {
            return Err(self.error("this symbol is 0").with_help(MASK));
        };
        let coefficients = (low..=high).map(|power| value.coefficient(power)).collect();
        let arity = match arity {
            Arity::OfSum(stated) => self.arity(coefficients, stated)?,
            Arity::OfFilter(arity) => arity,
        };
        let n = i64::try_from(arity).expect("a small arity");
        Ok(Rules::rows_of_symbol(n, (low, high), |power| value.coefficient(power)))
    }
}

/// The free names of a symbol but for its variables.
pub(super) fn parameters(
    formula: &LocatedFormula,
    definitions: &BTreeMap<String, LocatedFormula>,
    variables: &[&str],
) -> BTreeSet<String> {
    let mut names = FreeNames::new(definitions).of(&formula.expr);
    // The parts of names such as `four-point` are no parameters.
    let others = composed_of(&formula.expr);
    let is_part = |name: &str| others.iter().any(|other| other.split('-').any(|part| part == name));
    names.retain(|name| !variables.contains(&&name[..]) && !is_part(name));
    names
}

/// What helps where a formula of a file has a name that is no parameter.
pub(in crate::scheme) fn states(name: &str) -> String {
    format!("the file states its parameters: parameters.{name} = {{}}, or {{ default = '1/16' }}")
}
