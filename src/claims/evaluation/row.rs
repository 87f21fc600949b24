//! The definitions that have one value in each row of a table, computed once for each row.

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

/// The word of the choice [`HEADER`] for headers as printed.
const AS_PRINTED: &str = "exact";

/// What the values depend on: the parameter of the row, the scheme, the part of the reading that
/// matters, and the parameters that are assumed.
type Key = (Option<Rational>, Vec<Instance>, Restricted, BTreeSet<String>);

/// The definitions that do not depend on the column, with their values.
#[derive(Default)]
pub(crate) struct RowDefinitions {
    names: Vec<String>,
    /// The choices that the values may depend on.
    depends: BTreeSet<&'static str>,
    /// The choices that the definitions consult in some row, each with its printed word.
    pub(crate) choices: BTreeMap<&'static str, String>,
    known: RefCell<BTreeMap<Key, Rc<Known>>>,
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

    /// The values of the definitions in the row of a cell, for the scheme of these quantities.
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

    /// Finds the choices that the rows consult, by computing the values of each row as printed.
    fn find_choices(&mut self, context: &TableContext<'_>) {
        let (settings, assume) = (Settings::default(), context.assumed.keys().cloned().collect());
        let rows = context.table.cells.len();
        for row in 0..if self.names.is_empty() { 0 } else { rows } {
            // Where the columns are schemes, each column has values of its own.
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

    /// The values of the definitions; one that has no value here is evaluated where it is used.
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
