//! SCHEME as text: a catalogue name or a file, with parameters.

use super::error::ReferenceError;
use super::lattice::dilation::MAX_DIMENSION;
use super::lattice::read::STATED;
use crate::exact::Rational;
use crate::formula::{
    Context, Expr, FormulaError, FreeNames, Value, evaluate_with, is_identifier, parse,
};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// The greatest length of SCHEME, in bytes.
const MAX_REFERENCE_LENGTH: usize = 4_096;

/// A scheme reference: one name with parameter formulas, or two or three for a tensor
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
pub(super) struct Part {
    /// All of it.
    pub(super) text: String,
    pub(super) name: String,
    pub(super) parameters: BTreeMap<String, Expr>,
    /// What is stated of a mask on Z^d, as it is typed.
    pub(super) vectors: BTreeMap<String, String>,
}

impl Reference {
    /// The formulas of its parameters.
    pub fn formulas(&self) -> impl Iterator<Item = &Expr> {
        self.parts.iter().flat_map(|part| part.parameters.values())
    }

    /// Reads `name`, `name:p=formula,q=formula`, or two or three of these with ` x `
    /// between them. Behind a mask on Z^d, `dilation`, `edges` and `origin` are lists.
    ///
    /// # Errors
    /// When the text has another form, or a parameter's value is not a formula.
    pub fn parse(text: &str) -> Result<Reference, ReferenceError> {
        let form = |reason: &str| ReferenceError::form(text, reason);
        if text.len() > MAX_REFERENCE_LENGTH {
            return Err(form("it is too long"));
        }
        let parts = factors(text);
        if parts.len() > MAX_DIMENSION {
            return Err(form("a tensor product has two or three factors"));
        }
        let read = |part: &&str| -> Result<Part, ReferenceError> {
            let (name, arguments) = split_name(part.trim());
            if name.is_empty() {
                return Err(form("the name is missing"));
            }
            let (mut parameters, mut vectors) = (BTreeMap::new(), BTreeMap::new());
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
                if STATED.contains(&parameter) && value.starts_with('[') {
                    if vectors.insert(parameter.to_owned(), value.to_owned()).is_some() {
                        return Err(form("a list is given twice"));
                    }
                    continue;
                }
                let expr = parse(value)
                    .map_err(|error| ReferenceError::Formula { text: value.to_owned(), error })?;
                if parameters.insert(parameter.to_owned(), expr).is_some() {
                    return Err(form("a parameter is given twice"));
                }
            }
            let (text, name) = (part.trim().to_owned(), name.to_owned());
            Ok(Part { text, name, parameters, vectors })
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

    /// The factors.
    pub(super) fn parts(&self) -> &[Part] {
        &self.parts
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
/// colon after `.toml` if a path is given. So the colon in `C:` does not count. To the name `mine.toml:own` belongs which of
/// the schemes of a file it is.
///
/// ```
/// use subcert::scheme::split_name;
///
/// assert_eq!(split_name("four-point:w=1/16"), ("four-point", "w=1/16"));
/// assert_eq!(split_name("mine.toml:w=1/16"), ("mine.toml", "w=1/16"));
/// assert_eq!(split_name("mine.toml:own:w=1/16"), ("mine.toml:own", "w=1/16"));
/// ```
#[must_use]
pub fn split_name(part: &str) -> (&str, &str) {
    let path_end = part.find(TOML).map_or(0, |start| start + TOML.len());
    let colon = |from: usize| part[from..].find(':').map(|at| from + at);
    let Some(first) = colon(path_end) else { return (part, "") };
    let next = colon(first + 1).unwrap_or(part.len());
    let is_name = path_end > 0
        && !part[first + 1..next].trim().is_empty()
        && !part[first + 1..next].contains('=');
    match if is_name { next } else { first } {
        end if end == part.len() => (part, ""),
        end => (&part[..end], &part[end + 1..]),
    }
}

/// The path of the file, and the scheme in it, if the name of a scheme is one.
pub(super) fn in_file(name: &str) -> Option<(&str, Option<&str>)> {
    let end = name.find(TOML)? + TOML.len();
    match name[end..].strip_prefix(':') {
        Some(own) => Some((&name[..end], Some(own.trim()))),
        None => name.ends_with(TOML).then_some((name, None)),
    }
}

/// How the path of a file of schemes ends.
const TOML: &str = ".toml";

/// The factors of a tensor product, between ` x ` outside all brackets. Behind a sign, x is the variable of a symbol.
fn factors(text: &str) -> Vec<&str> {
    const TIMES: &str = " x ";
    let ends_open = |text: &str| text.trim_end().ends_with(['+', '-', '*', '/', '^', ',', '=']);
    let depth = |text: &str| {
        let count = |c: [char; 2]| text.matches(c).count();
        count(['(', '[']) - count([')', ']']).min(count(['(', '[']))
    };
    let (mut pieces, mut start) = (Vec::new(), 0);
    for (at, _) in text.match_indices(TIMES) {
        let before = &text[..at];
        if depth(before) == 0 && !ends_open(before) && at >= start {
            pieces.push(&text[start..at]);
            start = at + TIMES.len();
        }
    }
    pieces.push(&text[start..]);
    pieces
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
