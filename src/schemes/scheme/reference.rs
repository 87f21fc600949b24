//! SCHEME as text: a catalogue name or a file, with parameters.

use super::error::ReferenceError;
use crate::exact::Rational;
use crate::formula::{
    Context, Expr, FormulaError, FreeNames, Value, evaluate_with, is_identifier, parse,
};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// The greatest length of SCHEME, in bytes.
const MAX_REFERENCE_LENGTH: usize = 4_096;

/// A scheme reference: one name with parameter formulas, or two for a tensor
/// product.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reference {
    text: String,
    parts: Vec<Part>,
}

impl fmt::Display for Reference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

#[derive(Clone, Debug, PartialEq, Eq)]
struct Part {
    name: String,
    parameters: BTreeMap<String, Expr>,
}

impl Reference {
    /// The formulas of its parameters.
    pub fn formulas(&self) -> impl Iterator<Item = &Expr> {
        self.parts.iter().flat_map(|part| part.parameters.values())
    }

    /// Reads `name`, `name:p=formula,q=formula`, or two of these with ` x `
    /// between them.
    ///
    /// # Errors
    /// When the text has another form, or a parameter's value is not a formula.
    pub fn parse(text: &str) -> Result<Reference, ReferenceError> {
        let form = |reason: &str| ReferenceError::form(text, reason);
        if text.len() > MAX_REFERENCE_LENGTH {
            return Err(form("it is too long"));
        }
        let parts: Vec<&str> = text.split(" x ").collect();
        ReferenceError::check_factors(text, parts.len())?;
        let read = |part: &&str| -> Result<Part, ReferenceError> {
            let (name, arguments) = split_name(part.trim());
            if name.is_empty() {
                return Err(form("the name is missing"));
            }
            let mut parameters = BTreeMap::new();
            for argument in split_top_level(arguments) {
                let Some((parameter, value)) = argument.split_once('=') else {
                    return Err(form("a parameter is given as name=value"));
                };
                let (parameter, value) = (parameter.trim(), value.trim());
                if !is_identifier(parameter) {
                    return Err(form("a parameter's name is a letter, then letters and digits"));
                }
                if value.is_empty() {
                    return Err(form(&format!("the value of `{parameter}` is missing")));
                }
                let expr = parse(value)
                    .map_err(|error| ReferenceError::Formula { text: value.to_owned(), error })?;
                if parameters.insert(parameter.to_owned(), expr).is_some() {
                    return Err(form("a parameter is given twice"));
                }
            }
            Ok(Part { name: name.to_owned(), parameters })
        };
        let parts = parts.iter().map(read).collect::<Result<Vec<Part>, _>>()?;
        Ok(Reference { text: text.trim().to_owned(), parts })
    }

    /// The free names in the formulas of its parameters, without the names of families.
    #[must_use]
    pub fn parameters(&self) -> BTreeSet<String> {
        let none = BTreeMap::new();
        let mut free = FreeNames::new(&none);
        let of = |expr: &Expr| {
            let names = expr.names();
            let free = free.of(expr).into_iter();
            free.filter(|name| names.contains(&name[..])).collect::<BTreeSet<String>>()
        };
        self.formulas().flat_map(of).collect()
    }

    /// The names of the schemes that this refers to, one per factor.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.parts.iter().map(|part| part.name.as_str())
    }

    /// The schemes that this refers to, one per factor, their parameters
    /// evaluated in `context`.
    ///
    /// # Errors
    /// When a parameter's formula has no value.
    pub fn instances<V: Value>(
        &self,
        context: &dyn Context<V>,
    ) -> Result<Vec<Instance<V>>, FormulaError> {
        self.instances_with(context, &[])
    }

    /// As [`instances`](Self::instances), with `values` for further names, which hide the
    /// names of the context. Of several values of one name the first counts.
    ///
    /// # Errors
    /// As [`instances`](Self::instances).
    pub fn instances_with<V: Value>(
        &self,
        context: &dyn Context<V>,
        values: &[(String, V)],
    ) -> Result<Vec<Instance<V>>, FormulaError> {
        let instance = |part: &Part| {
            let value = |(name, expr): (&String, &Expr)| {
                Ok((name.clone(), evaluate_with(expr, context, values)?))
            };
            let parameters = part.parameters.iter().map(value).collect::<Result<_, _>>()?;
            Ok(Instance { name: part.name.clone(), parameters })
        };
        self.parts.iter().map(instance).collect()
    }
}

/// The name of a scheme with values for its parameters.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Instance<V = Rational> {
    /// The scheme's name.
    pub name: String,
    /// Its parameters.
    pub parameters: BTreeMap<String, V>,
}

impl<V: fmt::Display> fmt::Display for Instance<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let values = self.parameters.iter().map(|(name, value)| format!("{name}={value}"));
        let values: Vec<String> = values.collect();
        let colon = if values.is_empty() { "" } else { ":" };
        write!(f, "{}{colon}{}", self.name, values.join(","))
    }
}

/// Splits a factor of SCHEME into the name and the parameters at the first colon, or at the first
/// colon after `.toml` if a path is given. So the colon in `C:` does not count.
#[must_use]
pub fn split_name(part: &str) -> (&str, &str) {
    let path_end = part.find(".toml").map_or(0, |start| start + ".toml".len());
    match part[path_end..].find(':') {
        Some(colon) => (&part[..path_end + colon], &part[path_end + colon + 1..]),
        None => (part, ""),
    }
}

/// Splits `text` at the commas outside all brackets.
fn split_top_level(text: &str) -> Vec<&str> {
    let mut pieces = Vec::new();
    let (mut depth, mut start) = (0_usize, 0);
    for (at, c) in text.char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth = depth.saturating_sub(1),
            ',' if depth == 0 => {
                pieces.push(&text[start..at]);
                start = at + 1;
            }
            _ => {}
        }
    }
    if !text[start..].trim().is_empty() {
        pieces.push(&text[start..]);
    }
    pieces
}
