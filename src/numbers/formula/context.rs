//! The context of an evaluation: names, functions, and the work that nested evaluations
//! share.

use super::ast::OptionWord;
use super::error::CallError;
use super::values::value::Value;
use crate::exact::Rational;
use std::cell::Cell;
use std::collections::BTreeMap;

/// The work that an evaluation has spent. A context whose names or functions evaluate
/// formulas keeps one `Work`, so that all these evaluations share one cap.
#[derive(Clone, Debug, Default)]
pub struct Work {
    pub(super) spent: Cell<u64>,
    pub(super) depth: Cell<u32>,
}

impl Work {
    /// The work of the last evaluation: 1 + ⌊s/512⌋² for every computed value of s bits. The values
    /// are those of all visited nodes, with sums unrolled and named formulas entered, and the
    /// intermediate results of sums and products.
    #[must_use]
    pub fn spent(&self) -> u64 {
        self.spent.get()
    }
}

/// The meaning of a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Lookup<V> {
    /// The name has this value.
    Found(V),
    /// The name exists, but no value is stated.
    Unstated,
    /// There is no such name.
    Unknown,
}

/// A call of a function that is not built in.
pub struct Call<'a, V> {
    /// The function's name.
    pub function: &'a str,
    /// Its arguments, evaluated.
    pub arguments: &'a [V],
    /// Its options, as written.
    pub options: &'a [OptionWord],
    /// The indices of the sums around the call with their values, innermost first.
    pub indices: &'a [(String, V)],
}

/// The names and functions that formulas can use besides the built-in ones.
pub trait Context<V> {
    /// The meaning of a name.
    ///
    /// # Errors
    /// When the name stands for a formula that has no value.
    fn name(&self, name: &str, indices: &[(String, V)]) -> Result<Lookup<V>, CallError>;

    /// The names that [`Context::name`] knows, for error messages.
    fn names(&self) -> Vec<String>;

    /// The work shared by all evaluations in this context, if the context evaluates
    /// formulas itself.
    fn work(&self) -> Option<&Work> {
        None
    }

    /// Whether `name` has no value here, and is that of a scheme which `function` may be about: then it is no argument of a
    /// call that begins with it, but its option `scheme`.
    fn is_scheme(&self, function: &str, name: &str) -> bool {
        let _ = (function, name);
        false
    }

    /// The value of a function.
    ///
    /// # Errors
    /// When there is no such function, or it has no value at these arguments.
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
