//! The names that a formula depends on.

use super::angle::PI;
use super::ast::{Expr, Node, OptionWord};
use super::located::LocatedFormula;
use std::collections::{BTreeMap, BTreeSet};

/// The option that names the index of a definition that an option names, and its
/// default.
const INDEX_OPTION: (&str, &str) = ("index", "q");

/// What formulas over some definitions depend on.
///
/// A name is free in a formula when it is a parameter there, and no index of a
/// sum around it. A definition is evaluated where it is used, so what is free in it
/// may be bound by a sum around its use.
pub struct FreeNames<'a> {
    definitions: &'a BTreeMap<String, LocatedFormula>,
    known: BTreeMap<&'a str, BTreeSet<String>>,
}

impl<'a> FreeNames<'a> {
    /// Over these definitions.
    #[must_use]
    pub fn new(definitions: &'a BTreeMap<String, LocatedFormula>) -> FreeNames<'a> {
        FreeNames { definitions, known: BTreeMap::new() }
    }

    /// The names that are free in a formula, those of definitions replaced by what
    /// is free in these, and families by their names.
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
        match &expr.node {
            Node::Number(_) => BTreeSet::new(),
            Node::Name(name) if name == PI => BTreeSet::new(),
            Node::Name(name) => self.of_name(name),
            Node::Indexed { name, indices } => {
                let mut free = self.of_all(indices);
                free.insert(name.clone());
                free
            }
            Node::Negate(operand) => self.of(operand),
            Node::Chain(first, rest) => {
                let mut free = self.of(first);
                for (_, operand) in rest {
                    free.extend(self.of(operand));
                }
                free
            }
            Node::Power(base, exponent) => {
                let mut free = self.of(base);
                free.extend(self.of(exponent));
                free
            }
            Node::Call { arguments, options, .. } => {
                let mut free = self.of_all(arguments);
                let index = options.iter().find(|option| option.name == INDEX_OPTION.0);
                let index = index.map_or(INDEX_OPTION.1, |option| &option.word);
                for name in options.iter().filter_map(OptionWord::definition) {
                    free.extend(self.of_name(name).into_iter().filter(|free| free != index));
                }
                free
            }
            Node::Fold { index, from, to, body, .. } => {
                let mut free = self.of(body);
                free.remove(index);
                free.extend(self.of(from));
                free.extend(self.of(to));
                free
            }
        }
    }

    fn of_all(&mut self, list: &[Expr]) -> BTreeSet<String> {
        let mut free = BTreeSet::new();
        for expr in list {
            free.extend(self.of(expr));
        }
        free
    }

    /// What a name stands for; a definition that refers to itself is free.
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
