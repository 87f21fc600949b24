//! What a formula is evaluated in: its names and functions, and the work they share.

use super::ast::OptionWord;
use super::error::CallError;
use super::value::Value;
use crate::exact::Rational;
use std::cell::Cell;
use std::collections::BTreeMap;

/// What an evaluation has spent. A context that evaluates formulas itself, for
/// its names or functions, keeps one, so that all of them share the cap.
#[derive(Clone, Debug, Default)]
pub struct Work {
    pub(super) spent: Cell<u64>,
    pub(super) depth: Cell<u32>,
}

impl Work {
    /// The steps of the last evaluation: nodes visited, sums unrolled and named formulas entered, and
    /// the squares of the sizes of their values in 512 bits.
    #[must_use]
    pub fn spent(&self) -> u64 {
        self.spent.get()
    }
}

/// What a name means.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Lookup<V> {
    /// It has this value.
    Found(V),
    /// It exists, but nobody has said its value.
    Unstated,
    /// There is no such name.
    Unknown,
}

/// A call of a function that is not the language's own.
pub struct Call<'a, V> {
    /// The function's name.
    pub function: &'a str,
    /// Its arguments, evaluated.
    pub arguments: &'a [V],
    /// Its options, as written.
    pub options: &'a [OptionWord],
    /// The sum indices in force where it is called, innermost first.
    pub indices: &'a [(String, V)],
}

/// Names and functions beyond the language's own.
pub trait Context<V> {
    /// The meaning of a name.
    ///
    /// # Errors
    /// When the name stands for a formula, and that has no value.
    fn name(&self, name: &str, indices: &[(String, V)]) -> Result<Lookup<V>, CallError>;

    /// The names that [`Context::name`] knows, for error messages.
    fn names(&self) -> Vec<String>;

    /// The work that the evaluations in this context share, if it evaluates
    /// formulas itself.
    fn work(&self) -> Option<&Work> {
        None
    }

    /// The value of a function.
    ///
    /// # Errors
    /// When there is no such function, or no such value.
    fn call(&self, call: &Call<'_, V>) -> Result<V, CallError> {
        let _ = call;
        Err(CallError::UnknownFunction(Vec::new()))
    }
}

/// The plain context: parameters with values, and no functions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameters<V = Rational>(pub BTreeMap<String, V>);

impl<V> Default for Parameters<V> {
    fn default() -> Parameters<V> {
        Parameters(BTreeMap::new())
    }
}

impl<V, const N: usize> From<[(&str, V); N]> for Parameters<V> {
    fn from(pairs: [(&str, V); N]) -> Parameters<V> {
        Parameters(pairs.into_iter().map(|(name, value)| (name.to_owned(), value)).collect())
    }
}

impl<V: Value> Context<V> for Parameters<V> {
    fn name(&self, name: &str, _: &[(String, V)]) -> Result<Lookup<V>, CallError> {
        Ok(self.0.get(name).map_or(Lookup::Unknown, |value| Lookup::Found(value.clone())))
    }
    fn names(&self) -> Vec<String> {
        self.0.keys().cloned().collect()
    }
}
