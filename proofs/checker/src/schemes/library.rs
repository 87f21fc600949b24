//! The library of the schemes that a claim file may name.

use super::lattice::Lattice;
use super::limits::Limits;
use super::products::Products;
use super::reference::{arguments_of, parameters_of, split};
use super::scheme::{Ring, Scheme};
use crate::formulas::{Definitions, Expr, Indices, Reading, Scope, formula};
use crate::numbers::{Meter, Value};
use crate::text::{Stop, Toml};
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::rc::Rc;

/// The greatest length of a chain of names that stand for names.
pub(super) const MAX_ALIASES: usize = 8;

/// The schemes of a claim file and of the catalogue.
pub struct Library<'a> {
    /// The names of the schemes of the file, which hide those of the catalogue, and their places.
    pub(super) own: BTreeMap<&'a str, usize>,
    tables: BTreeMap<&'a str, &'a Toml>,
    pub(super) schemes: RefCell<BTreeMap<String, Rc<Scheme>>>,
    /// The masks on Z^d.
    pub(super) lattices: RefCell<BTreeMap<String, Rc<Lattice>>>,
    /// How many symbols of other schemes are being multiplied out.
    pub(super) composing: Cell<usize>,
    /// The lengths of the chains of schemes in whose symbols others stand, by the addresses of these schemes.
    pub(super) composed: RefCell<BTreeMap<*const (), usize>>,
    /// The steps of the claim at hand.
    pub meter: &'a Meter,
    /// The products of sequences and the constants that are known.
    pub products: Products<'a>,
    /// What is known of limits.
    pub limits: Limits,
    nothing: Definitions,
    as_printed: Reading,
    /// The constants that formulas asked for, while they are traced.
    asked: RefCell<Option<Vec<Constant>>>,
}

/// A constant T_c or Λ_c that a formula asked for.
#[derive(Clone)]
pub struct Constant {
    /// The scheme.
    pub scheme: Rc<Scheme>,
    /// Whether it is Λ_c.
    pub norm: bool,
    /// Whether the sequence is read forwards.
    pub forward: bool,
    /// c.
    pub level: u32,
}

/// The name of a scheme, its table, and its parameters, which are values of any kind.
pub type Named<'a, T> = (&'a str, &'a Toml, BTreeMap<String, T>);

/// The same with values of formulas.
pub type Entry<'a> = Named<'a, Value>;

/// What evaluates formulas inside of names with values.
pub type Evaluate<'e, T> = &'e dyn Fn(&Expr, &mut Vec<(String, T)>) -> Result<T, Stop>;

pub(super) fn wrong<T>(of: &str, what: &str) -> Result<T, Stop> {
    Err(Stop::Wrong(format!("`{of}`: {what}")))
}

impl<'a> Library<'a> {
    /// The library of a claim file's `[[scheme]]` tables.
    pub fn new(file: &'a [Toml], catalogue: &'a [Toml], meter: &'a Meter) -> Library<'a> {
        let (schemes, lattices, composing, composed) = Default::default();
        let (limits, nothing, as_printed, asked) = Default::default();
        let products = Products::new(meter);
        let named = |table: &'a Toml| table.text("name").map(|name| (name, table));
        let own =
            file.iter().filter_map(named).zip(0..).map(|((name, _), at)| (name, at)).collect();
        let tables = catalogue.iter().chain(file).filter_map(named).collect();
        Library {
            own,
            tables,
            schemes,
            lattices,
            composing,
            composed,
            meter,
            products,
            limits,
            nothing,
            as_printed,
            asked,
        }
    }

    /// What a computation gives, and the constants of schemes that its formulas ask for.
    pub fn trace<T>(&self, computation: impl FnOnce() -> T) -> (T, Vec<Constant>) {
        *self.asked.borrow_mut() = Some(Vec::new());
        let value = computation();
        (value, self.asked.take().unwrap_or_default())
    }

    /// Notes a constant that a formula asks for.
    pub fn note(&self, constant: impl FnOnce() -> Constant) {
        if let Some(asked) = &mut *self.asked.borrow_mut() {
            asked.push(constant());
        }
    }

    /// Forgets everything, so that the cost of a claim does not depend on the claims before it.
    pub fn restart(&self) {
        self.meter.restart();
        self.schemes.borrow_mut().clear();
        self.lattices.borrow_mut().clear();
        self.composed.borrow_mut().clear();
        self.limits.clear();
        self.products.clear();
    }

    /// A scope without names, in which everything is read as printed.
    pub fn closed(&self) -> Scope<'_> {
        self.scope(&self.nothing)
    }

    /// A scope with these definitions, in which everything is read as printed.
    pub fn scope<'s>(&'s self, definitions: &'s Definitions) -> Scope<'s> {
        Scope::new(definitions, self, &self.as_printed)
    }

    /// The schemes of a reference such as `six-point:w=w`, one for each factor of a tensor
    /// product. The parameters are evaluated in the scope.
    pub fn resolve(&self, reference: &str, scope: &Scope<'_>) -> Result<Vec<Rc<Scheme>>, Stop> {
        let schemes = self.resolve_any(reference, scope)?;
        if schemes.iter().any(|scheme| scheme.is_filter()) {
            return wrong(reference, "a filter has no place here");
        }
        Ok(schemes)
    }

    /// The same, which may be one filter.
    pub fn resolve_any(&self, reference: &str, scope: &Scope<'_>) -> Result<Vec<Rc<Scheme>>, Stop> {
        let entries = self.follow(reference, (scope, &mut Indices::new()), 0)?.into_iter();
        let schemes = entries.map(|(name, table, with)| self.scheme(name, table, with));
        let schemes = schemes.collect::<Result<Vec<Rc<Scheme>>, Stop>>()?;
        if schemes.len() > 1 && schemes.iter().any(|scheme| scheme.is_filter()) {
            return wrong(reference, "a filter is no factor of a tensor product");
        }
        Ok(schemes)
    }

    /// The name and the table of the one scheme that a reference names, with its parameters.
    pub fn entry(&self, reference: &str, scope: &Scope<'_>) -> Result<Entry<'a>, Stop> {
        let mut entries = self.follow(reference, (scope, &mut Indices::new()), 0)?;
        match (entries.pop(), entries.is_empty()) {
            (Some(entry), true) => Ok(entry),
            _ => wrong(reference, "it is a tensor product"),
        }
    }

    /// The ring that a reference names, with the values of its parameters in the scope.
    pub fn ring(&self, reference: &str, scope: &Scope<'_>) -> Result<Ring, Stop> {
        let (name, _, parameters) = self.entry(reference, scope)?;
        Ok((name.to_owned(), parameters))
    }

    /// The table of a ring.
    pub fn of_ring(&self, (name, parameters): &Ring) -> Option<Entry<'a>> {
        let table = self.named(name)?;
        Some((table.text("name")?, table, parameters.clone()))
    }

    /// The schemes behind the names of a reference. In the formulas of a `use`, the parameters that
    /// are given with its name have their values.
    pub(super) fn follow(
        &self,
        reference: &str,
        (scope, values): (&Scope<'_>, &mut Indices),
        depth: usize,
    ) -> Result<Vec<Entry<'a>>, Stop> {
        let evaluate = |expr: &Expr, values: &mut Indices| scope.evaluate(expr, values);
        self.follow_as(reference, (scope.definitions, &evaluate), values, depth)
    }

    /// The same with parameters of any kind, which this evaluates where names have these values.
    pub fn follow_as<T: Clone>(
        &self,
        reference: &str,
        (definitions, evaluate): (&Definitions, Evaluate<'_, T>),
        values: &mut Vec<(String, T)>,
        depth: usize,
    ) -> Result<Vec<Named<'a, T>>, Stop> {
        let mut entries = Vec::new();
        if depth > MAX_ALIASES {
            return Err(Stop::Capped("the names that stand for names"));
        }
        for factor in reference.split(" x ") {
            let (name, table, parameters) = self.named_with(factor, evaluate, values)?;
            if let Some(other) = table.text("use") {
                let known = parameters_of(other)?;
                let place = |name: &String| known.contains(name) && !definitions.contains_key(name);
                if !parameters.keys().all(place) {
                    return wrong(reference, "its `use` has no such parameter");
                }
                let outer = values.len();
                values.extend(parameters);
                let with = (definitions, evaluate);
                entries.extend(self.follow_as(other, with, values, depth + 1)?);
                values.truncate(outer);
            } else {
                entries.push((name, table, parameters));
            }
            if entries.len() > 2 {
                return wrong(reference, "it has more than two factors");
            }
        }
        Ok(entries)
    }

    fn named(&self, name: &str) -> Option<&'a Toml> {
        self.tables.get(name).copied()
    }

    /// Whether the claim file or the catalogue has a scheme of this name.
    pub fn has(&self, name: &str) -> bool {
        self.tables.contains_key(name)
    }

    /// Whether the claim file has a scheme of this name, which hides that of the catalogue.
    pub fn redefines(&self, name: &str) -> bool {
        self.own.contains_key(name)
    }

    /// Whether a reference names a ring.
    pub fn is_ring(&self, reference: &str) -> bool {
        self.behind(reference).is_some_and(|table| table.get("orbits").is_some())
    }

    /// The table behind the names that stand for the one of a reference.
    pub(super) fn behind(&self, reference: &str) -> Option<&'a Toml> {
        let table = |reference: &str| self.named(split(reference).0);
        let mut found = table(reference);
        for _ in 0..MAX_ALIASES {
            let Some(other) = found.and_then(|table| table.text("use")) else { break };
            found = table(other);
        }
        found
    }

    /// The table that a reference names, with the parameters that are given there.
    fn named_with<T>(
        &self,
        reference: &str,
        evaluate: Evaluate<'_, T>,
        values: &mut Vec<(String, T)>,
    ) -> Result<Named<'a, T>, Stop> {
        let (name, arguments) = split(reference);
        let mut parameters = BTreeMap::new();
        for argument in arguments_of(arguments) {
            let Some((parameter, value)) = argument.split_once('=') else {
                return wrong(reference, "a parameter has the form name=value");
            };
            let value = evaluate(&formula(value.trim())?, values)?;
            if parameters.insert(parameter.trim().to_owned(), value).is_some() {
                return wrong(reference, "a parameter is given twice");
            }
        }
        match self.named(name).and_then(|table| Some((table.text("name")?, table))) {
            Some((name, table)) => {
                is_filter(name, table)?;
                Ok((name, table, parameters))
            }
            None => wrong(reference, "there is no such scheme"),
        }
    }

    /// The parameters of a scheme. Missing ones have their defaults, which may use those that are given.
    pub fn complete(
        &self,
        name: &str,
        table: &Toml,
        mut parameters: BTreeMap<String, Value>,
    ) -> Result<BTreeMap<String, Value>, Stop> {
        let known = table.entries("parameters");
        if parameters.keys().any(|given| known.iter().all(|(known, _)| known != given)) {
            return wrong(name, "it has no such parameter");
        }
        let mut scope = self.closed();
        scope.values = parameters.clone();
        for (parameter, about) in known {
            if !parameters.contains_key(parameter) {
                let Some(default) = about.text("default") else {
                    return wrong(name, "a parameter is missing");
                };
                parameters.insert(parameter.clone(), scope.value(&formula(default)?)?);
            }
        }
        Ok(parameters)
    }
}

/// What no filter has.
const NOT_OF_FILTERS: [&str; 4] = ["mask", "entry", "orbits", "use"];

/// Whether a table gives a filter.
pub fn is_filter(name: &str, table: &Toml) -> Result<bool, Stop> {
    let filter = table.is_set("filter");
    let has = |key: &&str| table.get(key).is_some();
    if filter && (!has(&"symbol") || NOT_OF_FILTERS.iter().any(has)) {
        return wrong(name, "a filter has a symbol, and is given by nothing else");
    }
    Ok(filter)
}
