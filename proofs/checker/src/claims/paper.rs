//! A claim file and the scopes of its formulas.

#![warn(clippy::arithmetic_side_effects)]

use crate::formulas::{Definitions, Scope, formulas, parse};
use crate::numbers::{Value, read_rational};
use crate::schemes::Library;
use crate::text::{Checked, MAX_LINE, Reason, Stop, Toml};
use std::collections::BTreeMap;

/// A claim file with the schemes that it may use.
pub struct Paper<'a> {
    /// The file.
    pub file: &'a Toml,
    /// The definitions in `[define]`.
    pub definitions: Definitions,
    /// The values in `[given]`.
    pub given: BTreeMap<String, Value>,
    /// Of the other names in `[given]`, the caps that their values are beyond.
    pub beyond: BTreeMap<String, Stop>,
    /// The schemes.
    pub library: &'a Library<'a>,
}

impl<'a> Paper<'a> {
    /// Reads what the claims of a file have in common.
    pub fn new(file: &'a Toml, library: &'a Library<'a>) -> Result<Paper<'a>, Stop> {
        let definitions = formulas(file.entries("define"))?;
        let (given, beyond) = Default::default();
        let mut paper = Paper { file, definitions, given, beyond, library };
        for (name, expr) in formulas(file.entries("given"))? {
            match library.closed().value(&expr) {
                Err(stop @ Stop::Capped(_)) => drop(paper.beyond.insert(name, stop)),
                value => drop(paper.given.insert(name, value?)),
            }
        }
        Ok(paper)
    }

    /// The values of named formulas without parameters.
    pub fn constants(&self, entries: &[(String, Toml)]) -> Result<BTreeMap<String, Value>, Stop> {
        let named = formulas(entries)?.into_iter();
        named.map(|(name, expr)| Ok((name, self.library.closed().value(&expr)?))).collect()
    }

    /// A scope with the definitions of the paper.
    pub fn scope(&'a self) -> Scope<'a> {
        self.library.scope(&self.definitions)
    }

    /// The same scope with the values of `[given]`.
    pub fn stated(&'a self) -> Scope<'a> {
        let mut scope = self.scope();
        scope.values.clone_from(&self.given);
        scope.beyond.clone_from(&self.beyond);
        scope
    }

    /// The value of a closed formula of a certificate.
    pub fn number(&self, text: &str) -> Checked<Value> {
        // Most numbers are fractions.
        let fraction = text.bytes().all(|b| b.is_ascii_digit() || b == b'-' || b == b'/');
        if let Some(known) = read_rational(text).filter(|_| fraction) {
            return Ok(known.into());
        }
        value(text, &self.library.closed())
    }

    /// The values of such formulas, which blanks separate.
    pub fn numbers(&self, text: &str) -> Checked<Vec<Value>> {
        text.split_whitespace().map(|word| self.number(word)).collect()
    }
}

/// The value of a formula of a certificate.
pub fn value(text: &str, scope: &Scope<'_>) -> Checked<Value> {
    Ok(scope.value(&parse(text, MAX_LINE).map_err(Reason::NoValue)?)?)
}

/// A number of the claim file as printed and as read. It is `'0.5'`, or a table that says both.
pub fn printed(field: &Toml) -> Option<(&str, &str)> {
    let text = field.as_text().or_else(|| field.text("printed"))?;
    Some((text, field.text("read").unwrap_or(text)))
}
