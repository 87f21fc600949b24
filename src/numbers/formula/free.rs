//! The free names of formulas.

use super::angle::PI;
use super::ast::{Expr, INDEX_OPTION, Node, OptionWord, SEQUENCE_INDEX};
use super::located::LocatedFormula;
use std::collections::{BTreeMap, BTreeSet};

/// Finds the free names of formulas over some definitions.
///
/// A name is free in a formula when it is a parameter there, and not the index of a sum
/// around it. A definition is evaluated where it is used, so a sum around this place may
/// bind names that are free in the definition.
pub struct FreeNames<'a> {
    definitions: &'a BTreeMap<String, LocatedFormula>,
    known: BTreeMap<&'a str, BTreeSet<String>>,
}

impl<'a> FreeNames<'a> {
    /// The search over these definitions.
    #[must_use]
    pub fn new(definitions: &'a BTreeMap<String, LocatedFormula>) -> FreeNames<'a> {
        FreeNames { definitions, known: BTreeMap::new() }
    }

    /// The free names of a formula. The name of a definition is replaced by the free
    /// names of the definition. A member of a family counts as the family's name.
    ///
    /// ```
    /// use subcert::formula::{FreeNames, parse};
    /// use std::collections::BTreeMap;
    ///
    /// let none = BTreeMap::new();
    /// let free = FreeNames::new(&none).of(&parse("sum(h = 1..m, a[h]*w)")?);
    /// assert_eq!(free.into_iter().collect::<Vec<_>>(), ["a", "m", "w"]);
    /// # Ok::<(), subcert::formula::FormulaError>(())
    /// ```
    pub fn of(&mut self, expr: &Expr) -> BTreeSet<String> {
        let mut free = BTreeSet::new();
        match &expr.node {
            Node::Name(name) if name != PI => free.extend(self.of_name(name)),
            Node::Indexed { name, .. } => {
                free.insert(name.clone());
            }
            Node::Call { options, .. } => {
                let index = options.iter().find(|option| option.name == INDEX_OPTION);
                let index = index.map_or(SEQUENCE_INDEX, |option| &option.word);
                for name in options.iter().filter_map(OptionWord::definition) {
                    free.extend(self.of_name(name).into_iter().filter(|free| free != index));
                }
            }
            Node::Fold { index, from, to, body, .. } => {
                // The ends of the range cannot use its index.
                free.extend(self.of(body));
                free.remove(index);
                free.extend(self.of(from));
                free.extend(self.of(to));
                return free;
            }
            _ => {}
        }
        for part in expr.parts() {
            free.extend(self.of(part));
        }
        free
    }

    /// The free names of the definition `name`, or `name` itself if it has no definition.
    /// In a definition that refers to itself, its own name counts as free.
    pub fn of_name(&mut self, name: &str) -> BTreeSet<String> {
        if let Some(free) = self.known.get(name) {
            return free.clone();
        }
        let itself = BTreeSet::from([name.to_owned()]);
        let Some((name, definition)) = self.definitions.get_key_value(name) else { return itself };
        self.known.insert(name, itself);
        let free = self.of(&definition.expr);
        self.known.insert(name, free.clone());
        free
    }
}
