//! The definitions that have one value in each row of a table, computed once for each row.

use crate::claim::{SchemeSource, Table};
use crate::evaluation::choices::HEADER;
use crate::evaluation::context::{CellReading, DefinitionValues, Outcome, TableContext};
use crate::evaluation::quantity::Quantities;
use crate::evaluation::settings::{Depends, Restricted, Settings};
use crate::exact::{Rational, RealCyclotomic};
use crate::formula::{FreeNames, LocatedFormula};
use crate::scheme::{Instance, Reference};
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

/// The word of the choice [`HEADER`] for headers as printed.
const AS_PRINTED: &str = "exact";

/// The most definitions of a table whose values are kept: what they lead to takes the square of their number. The values
/// of more are computed where they are used.
const MAX_DEFINITIONS: usize = 500;

/// What a value depends on: the place of its definition, the parameter of the row, the scheme, the
/// part of the reading that matters, and the parameters that are assumed.
type Key = (usize, Option<Rational>, Vec<Instance>, Restricted, BTreeSet<String>);

/// A definition that has one value in each row.
struct RowDefinition {
    name: String,
    /// What its value may depend on.
    depends: Depends,
    /// The places of the others that it leads to.
    led: Vec<usize>,
}

/// The definitions that do not depend on the column, with their values.
#[derive(Default)]
pub(crate) struct RowDefinitions {
    definitions: Vec<RowDefinition>,
    /// Whether the parameters of some scheme may depend on the column.
    schemes_vary: bool,
    /// The choices that the definitions consult in some row, each with its printed word.
    pub(crate) choices: BTreeMap<&'static str, String>,
    /// The values so far; `None` where there is none.
    known: RefCell<BTreeMap<Key, Option<RealCyclotomic>>>,
}

impl RowDefinitions {
    /// The definitions that the formula of the table uses and that depend only on the row's
    /// parameter and on stated and assumed parameters, whichever alternative stands for a
    /// definition.
    pub(crate) fn new(context: &TableContext<'_>) -> RowDefinitions {
        let TableContext { paper, table, given, assumed, .. } = context;
        let fixed = |name: &String| {
            // A column header hides a stated or assumed value of the same name.
            table.columns.name() != Some(name)
                && (table.rows.as_ref().is_some_and(|axis| axis.name() == Some(name))
                    || given.contains_key(name)
                    || assumed.contains_key(name))
        };
        let aliases = paper.schemes.values().filter_map(|source| match source {
            SchemeSource::Alias(other) => Some(other),
            SchemeSource::Own(_) => None,
        });
        let named = paper.tables.iter().flat_map(Table::schemes).map(|own| &own.reference);
        let parameters: BTreeSet<String> =
            named.chain(aliases).flat_map(Reference::parameters).collect();
        // What the value and these parameters lead to, whichever alternative stands for a definition.
        let mut reached: BTreeSet<&str> = BTreeSet::new();
        let mut waiting = table.value.expr.names();
        waiting.extend(parameters.iter().map(String::as_str));
        while let Some(name) = waiting.pop_first() {
            if reached.insert(name) {
                let others = paper.alternatives.iter().filter(|other| other.of == name);
                let formulas = others.map(|other| &other.value).chain(paper.definitions.get(name));
                waiting.extend(formulas.flat_map(|formula| formula.expr.names()));
            }
        }
        let mut varying = BTreeSet::new();
        let own = reached.iter().filter_map(|name| paper.definitions.get_key_value(*name));
        let mut definitions: BTreeMap<String, LocatedFormula> =
            own.map(|(name, formula)| (name.clone(), formula.clone())).collect();
        let others = paper.alternatives.iter().filter(|other| reached.contains(&other.of[..]));
        let others = others.map(Some);
        for alternative in std::iter::once(None).chain(others) {
            if let Some(other) = alternative {
                definitions.insert(other.of.clone(), other.value.clone());
            }
            let mut free = FreeNames::new(&definitions);
            let varies = |name: &&String| !free.of_name(name).iter().all(fixed);
            varying.extend(definitions.keys().filter(varies).cloned().collect::<Vec<_>>());
        }
        let column = table.columns.name();
        let schemes_vary =
            parameters.iter().any(|name| varying.contains(name) || column == Some(&name[..]));
        let used = paper.definitions_in(&table.value).into_keys().map(str::to_owned);
        let names: Vec<String> = used.filter(|name| !varying.contains(name)).collect();
        if names.len() > MAX_DEFINITIONS {
            return RowDefinitions::default();
        }
        let header = table.rows.as_ref().is_some_and(|axis| context.tolerance(axis));
        let depends: Vec<_> = names.iter().map(|name| Depends::of(paper, name, header)).collect();
        // Two definitions lead to each other if different alternatives stand for them.
        let leads = |from: usize, to: usize| depends[from].1.contains(&names[to][..]);
        let led = (0..names.len()).map(|from| {
            let others = (0..names.len()).filter(|&to| leads(from, to) && !leads(to, from));
            others.collect::<Vec<usize>>()
        });
        let led: Vec<Vec<usize>> = led.collect();
        let definitions = names.iter().zip(depends).zip(led);
        let definitions = definitions.map(|((name, (depends, _)), led)| RowDefinition {
            name: name.clone(),
            depends,
            led,
        });
        let definitions = definitions.collect();
        let mut rows = RowDefinitions { definitions, schemes_vary, ..RowDefinitions::default() };
        rows.find_choices(context);
        rows
    }

    /// Whether a definition has one value in each row, also with other parameters and schemes of the
    /// paper's tables.
    pub(crate) fn fixes(&self, context: &TableContext<'_>, name: &str) -> bool {
        !self.schemes_vary
            && context.table.columns.schemes().is_empty()
            && self.place(name).is_some()
    }

    fn place(&self, name: &str) -> Option<usize> {
        self.definitions.iter().position(|own| own.name == name)
    }

    /// The values of the definitions in the row of a cell, for the scheme of these quantities.
    pub(crate) fn of(
        &self,
        context: &TableContext<'_>,
        at: CellReading<'_>,
        quantities: &Quantities<'_>,
    ) -> DefinitionValues {
        let value = |place: usize| {
            let value = self.value(context, at, quantities, place)?;
            Some((self.definitions[place].name.clone(), value))
        };
        (0..self.definitions.len()).filter_map(value).collect()
    }

    /// The value of one of the definitions; `None` if it has none, or if it is not one of these.
    pub(crate) fn one(
        &self,
        context: &TableContext<'_>,
        at: CellReading<'_>,
        quantities: &Quantities<'_>,
        name: &str,
    ) -> Option<RealCyclotomic> {
        self.value(context, at, quantities, self.place(name)?)
    }

    /// As `one`, of the definition at this place. One that has no value here is evaluated where it is
    /// used.
    fn value(
        &self,
        context: &TableContext<'_>,
        at: CellReading<'_>,
        quantities: &Quantities<'_>,
        place: usize,
    ) -> Option<RealCyclotomic> {
        let RowDefinition { name, depends, led } = &self.definitions[place];
        let scheme = quantities.scheme.as_ref().map(|scheme| scheme.instances.clone());
        let row = context.table.rows.as_ref().and_then(|axis| axis.value(at.row));
        let row =
            row.map(|(name, value)| at.settings.parameters.get(name).unwrap_or(value).clone());
        let restricted = at.settings.restricted(depends);
        let key = (place, row, scheme.unwrap_or_default(), restricted, at.assume.clone());
        if let Some(known) = self.known.borrow().get(&key) {
            return known.clone();
        }
        let led = led.iter().filter_map(|&place| {
            let value = self.value(context, at, quantities, place)?;
            Some((self.definitions[place].name.clone(), value))
        });
        let led = led.collect();
        let definitions = at.settings.definitions.as_deref().unwrap_or(&context.paper.definitions);
        let value = match context.evaluate_with(&definitions[name], at, quantities, &led) {
            Ok(Outcome::Value(value)) => Some(value),
            _ => None,
        };
        self.known.borrow_mut().insert(key, value.clone());
        value
    }

    /// Finds the choices that the rows consult, by computing the values of each row as printed.
    fn find_choices(&mut self, context: &TableContext<'_>) {
        let (settings, assume) = (Settings::default(), context.assumed.keys().cloned().collect());
        let rows = context.table.cells.len();
        for row in 0..if self.definitions.is_empty() { 0 } else { rows } {
            // Where the columns are schemes, each column has values of its own.
            for column in 0..context.table.columns.schemes().len().max(1) {
                let at = CellReading { row, column, assume: &assume, settings: &settings };
                if let Ok(Ok(quantities)) = &context.quantities(at) {
                    let mut known = DefinitionValues::new();
                    for RowDefinition { name, .. } in &self.definitions {
                        // A value from another row would consult nothing.
                        let formula = &context.paper.definitions[name];
                        let value = context.evaluate_with(formula, at, quantities, &known);
                        if let Ok(Outcome::Value(value)) = value {
                            known.insert(name.clone(), value);
                        }
                    }
                }
            }
        }
        self.choices = settings.consulted();
        if context.table.rows.as_ref().is_some_and(|axis| context.tolerance(axis)) {
            self.choices.insert(HEADER.key, AS_PRINTED.to_owned());
        }
    }
}
