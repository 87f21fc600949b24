//! The definitions that have one value in a row of a table, computed once for it.

use crate::evaluation::choices::HEADER;
use crate::evaluation::context::{At, Known, Outcome, TableContext};
use crate::evaluation::quantity::Quantities;
use crate::evaluation::settings::{Restricted, Settings, choices_of};
use crate::exact::Rational;
use crate::formula::FreeNames;
use crate::scheme::Instance;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// The way of headers that the text prints.
const AS_PRINTED: &str = "exact";

/// What the values depend on: the parameter of the row, the scheme, the reading as far as it matters,
/// and the parameters that are assumed.
type Key = (Option<Rational>, Vec<Instance>, Restricted, BTreeSet<String>);

/// The definitions that do not depend on the column, with their values.
#[derive(Default)]
pub(crate) struct RowDefinitions {
    names: Vec<String>,
    /// The choices of readings that the values may depend on.
    depends: BTreeSet<&'static str>,
    /// Those that some row asks for as printed, with their words.
    pub(crate) choices: BTreeMap<&'static str, String>,
    known: RefCell<BTreeMap<Key, Rc<Known>>>,
}

impl RowDefinitions {
    /// Those that the formula of the table uses and that depend on the row's
    /// parameter, stated and assumed ones alone, whichever alternative stands for a
    /// definition.
    pub(crate) fn new(context: &TableContext<'_>) -> RowDefinitions {
        let TableContext { paper, table, given, assumed, .. } = context;
        let fixed = |name: &String| {
            // The headers of the columns go before what is stated or assumed elsewhere.
            table.columns.name() != Some(name)
                && (table.rows.as_ref().is_some_and(|axis| axis.name() == Some(name))
                    || given.contains_key(name)
                    || assumed.contains_key(name))
        };
        let mut varying = BTreeSet::new();
        let mut definitions = paper.definitions.clone();
        let others = paper.alternatives.iter().map(Some);
        for alternative in std::iter::once(None).chain(others) {
            if let Some(other) = alternative {
                definitions.insert(other.of.clone(), other.value.clone());
            }
            let mut free = FreeNames::new(&definitions);
            let varies = |name: &&String| !free.of_name(name).iter().all(fixed);
            varying.extend(definitions.keys().filter(varies).cloned().collect::<Vec<_>>());
        }
        let used = paper.definitions_in(&table.value).into_keys().map(str::to_owned);
        let names = used.filter(|name| !varying.contains(name)).collect();
        let formulas = paper.definitions.values();
        let formulas = formulas.chain(paper.alternatives.iter().map(|other| &other.value));
        let depends = formulas.flat_map(|formula| choices_of(&formula.expr)).collect();
        let mut rows = RowDefinitions { names, depends, ..RowDefinitions::default() };
        rows.find_choices(context);
        rows
    }

    /// The values in the row of a cell, for the scheme that the quantities there are of.
    pub(crate) fn of(
        &self,
        context: &TableContext<'_>,
        at: At<'_>,
        quantities: &Quantities<'_>,
    ) -> Rc<Known> {
        if self.names.is_empty() {
            return Rc::default();
        }
        let scheme = quantities.scheme.as_ref().map(|scheme| scheme.instances.clone());
        let scheme = scheme.unwrap_or_default();
        let row = context.table.rows.as_ref().and_then(|axis| axis.value(at.row));
        let row =
            row.map(|(name, value)| at.settings.parameters.get(name).unwrap_or(value).clone());
        let key = (row, scheme, at.settings.restricted(&self.depends), at.assume.clone());
        if let Some(known) = self.known.borrow().get(&key) {
            return Rc::clone(known);
        }
        let known = Rc::new(self.compute(context, at, quantities));
        self.known.borrow_mut().insert(key, Rc::clone(&known));
        known
    }

    /// Notes which choices the rows ask for, by computing the values of each.
    fn find_choices(&mut self, context: &TableContext<'_>) {
        let (settings, assume) = (Settings::default(), context.assumed.keys().cloned().collect());
        let rows = context.table.cells.len();
        for row in 0..if self.names.is_empty() { 0 } else { rows } {
            // Where the columns are schemes, each has values of its own.
            for column in 0..context.table.columns.schemes().len().max(1) {
                let at = At { row, column, assume: &assume, settings: &settings };
                if let Ok(Ok(quantities)) = &context.quantities(at) {
                    self.compute(context, at, quantities);
                }
            }
        }
        self.choices = settings.consulted();
        if context.table.rows.as_ref().is_some_and(|axis| context.tolerance(axis)) {
            self.choices.insert(HEADER.key, AS_PRINTED.to_owned());
            self.depends.insert(HEADER.key);
        }
    }

    /// A definition without a value here is left to whoever needs it.
    fn compute(
        &self,
        context: &TableContext<'_>,
        at: At<'_>,
        quantities: &Quantities<'_>,
    ) -> Known {
        let definitions = at.settings.definitions.as_deref().unwrap_or(&context.paper.definitions);
        let mut known = Known::new();
        for name in &self.names {
            if let Ok(Outcome::Value(value)) =
                context.evaluate_with(&definitions[name], at, quantities, &known)
            {
                known.insert(name.clone(), value);
            }
        }
        known
    }
}
