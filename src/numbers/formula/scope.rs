//! A context with parameters, definitions and functions.

use super::context::{Call, Context, Lookup, Work};
use super::error::CallError;
use super::evaluate::evaluate_with;
use super::located::LocatedFormula;
use super::values::value::Value;
use std::borrow::Cow;
use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet};

/// The greatest depth of definitions that refer to definitions.
const MAX_DEFINITION_DEPTH: usize = 32;

/// The functions that a scope offers besides the built-in ones.
pub trait Functions<V> {
    /// The value of a function. `context` is the scope of the call, for functions that
    /// evaluate named formulas themselves.
    ///
    /// # Errors
    /// When there is no such function, or it has no value at these arguments.
    fn call(&self, call: &Call<'_, V>, context: &dyn Context<V>) -> Result<V, CallError>;

    /// Whether `function` may be about a scheme, and `name` is the name of one.
    fn is_scheme(&self, function: &str, name: &str) -> bool {
        let _ = (function, name);
        false
    }
}

/// No functions.
impl<V> Functions<V> for () {
    fn call(&self, _: &Call<'_, V>, _: &dyn Context<V>) -> Result<V, CallError> {
        Err(CallError::UnknownFunction(Vec::new()))
    }
}

/// Parameters with and without values, named formulas over them, and functions. A named
/// formula is evaluated where it is used, so it sees the indices of the sums around its
/// use.
pub struct Scope<'a, V> {
    /// Of equal names the last one counts.
    values: Vec<ScopeValues<'a, V>>,
    unstated: Vec<&'a str>,
    families: BTreeMap<&'a str, &'a dyn Fn(&str) -> V>,
    definitions: &'a BTreeMap<String, LocatedFormula>,
    /// Of equal names the last one counts.
    stated: Vec<&'a BTreeMap<String, LocatedFormula>>,
    functions: &'a dyn Functions<V>,
    depth: Cell<usize>,
    work: Work,
}

/// Names with values. A scope is built for every cell and every reading of a table, so it copies
/// neither names nor tables of values.
enum ScopeValues<'a, V> {
    One(Cow<'a, str>, V),
    All(&'a BTreeMap<String, V>),
}

impl<'a, V: Value> Scope<'a, V> {
    /// A scope without parameters.
    #[must_use]
    pub fn new(
        definitions: &'a BTreeMap<String, LocatedFormula>,
        functions: &'a dyn Functions<V>,
    ) -> Scope<'a, V> {
        Scope {
            values: Vec::new(),
            unstated: Vec::new(),
            families: BTreeMap::new(),
            definitions,
            stated: Vec::new(),
            functions,
            depth: Cell::new(0),
            work: Work::default(),
        }
    }

    /// Gives `name` a value; it hides a definition of that name.
    #[must_use]
    pub fn with(mut self, name: impl Into<Cow<'a, str>>, value: V) -> Scope<'a, V> {
        self.values.push(ScopeValues::One(name.into(), value));
        self
    }

    /// Gives each of these names its value, as [`Scope::with`] does.
    #[must_use]
    pub fn with_all(mut self, values: &'a BTreeMap<String, V>) -> Scope<'a, V> {
        self.values.push(ScopeValues::All(values));
        self
    }

    /// Names formulas that have no other value here: those whose value is beyond a cap, which an evaluation meets only where
    /// it needs them.
    #[must_use]
    pub fn with_formulas(mut self, stated: &'a BTreeMap<String, LocatedFormula>) -> Scope<'a, V> {
        self.stated.push(stated);
        self
    }

    /// Gives every member `name[i]`, `name[i,j]`, … the value that `member` has for the
    /// member's full name. A value given to a single member by [`Scope::with`] takes
    /// precedence.
    #[must_use]
    pub fn with_family(mut self, name: &'a str, member: &'a dyn Fn(&str) -> V) -> Scope<'a, V> {
        self.families.insert(name, member);
        self
    }

    /// Adds the parameter `name` without a value.
    #[must_use]
    pub fn with_unstated(mut self, name: &'a str) -> Scope<'a, V> {
        self.unstated.push(name);
        self
    }

    /// The formula that this name stands for where it has no value.
    fn formula(&self, name: &str) -> Option<&LocatedFormula> {
        let stated = self.stated.iter().rev().find_map(|stated| stated.get(name));
        stated.or_else(|| self.definitions.get(name))
    }

    fn given(&self, name: &str) -> Option<&V> {
        self.values.iter().rev().find_map(|given| match given {
            ScopeValues::One(own, value) => (own == name).then_some(value),
            ScopeValues::All(values) => values.get(name),
        })
    }
}

impl<V: Value> Context<V> for Scope<'_, V> {
    fn name(&self, name: &str, indices: &[(String, V)]) -> Result<Lookup<V>, CallError> {
        if let Some(value) = self.given(name) {
            return Ok(Lookup::Found(value.clone()));
        }
        if self.unstated.contains(&name) {
            return Ok(Lookup::Unstated);
        }
        if let Some((family, _)) = name.split_once('[')
            && let Some(member) = self.families.get(family)
        {
            return Ok(Lookup::Found(member(name)));
        }
        let Some(definition) = self.formula(name) else { return Ok(Lookup::Unknown) };
        if self.depth.get() >= MAX_DEFINITION_DEPTH {
            return Err(CallError::Misuse(format!(
                "the definition of `{name}` refers to itself, or definitions are nested more \
                 than {MAX_DEFINITION_DEPTH} deep"
            )));
        }
        self.depth.set(self.depth.get() + 1);
        let value = evaluate_with(&definition.expr, self, indices);
        self.depth.set(self.depth.get() - 1);
        value.map(Lookup::Found).map_err(|error| {
            let place = definition.diagnostic(&error);
            CallError::Definition(error.kind, Box::new(place))
        })
    }

    fn names(&self) -> Vec<String> {
        let mut names: BTreeSet<&str> = self.definitions.keys().map(String::as_str).collect();
        names.extend(self.unstated.iter().chain(self.families.keys()));
        for given in &self.values {
            match given {
                ScopeValues::One(name, _) => names.extend([&**name]),
                ScopeValues::All(values) => names.extend(values.keys().map(String::as_str)),
            }
        }
        names.into_iter().map(str::to_owned).collect()
    }

    fn work(&self) -> Option<&Work> {
        Some(&self.work)
    }

    fn is_scheme(&self, function: &str, name: &str) -> bool {
        let known = self.given(name).is_some() || self.unstated.contains(&name);
        !known && self.formula(name).is_none() && self.functions.is_scheme(function, name)
    }

    fn call(&self, call: &Call<'_, V>) -> Result<V, CallError> {
        self.functions.call(call, self)
    }
}
