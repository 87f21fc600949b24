//! Values of definitions that are known already.

use crate::formula::Expr;
use crate::value::Value;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// The most values that are kept of one definition.
const MAX_VALUES: usize = 1_000;

/// What a definition depends on, and its value.
type Known = Vec<(Vec<Option<Value>>, Value)>;

/// Values of definitions in one reading, by definition and scheme.
#[derive(Default)]
pub struct Memo {
    names: RefCell<BTreeMap<String, Rc<BTreeSet<String>>>>,
    known: RefCell<BTreeMap<(String, usize), Known>>,
}

/// All names in a formula and in the definitions that it leads to. What is bound by a sum is
/// among them: to depend on more names than needed does no harm.
pub fn names(expr: &Expr, definitions: &BTreeMap<String, Rc<Expr>>) -> BTreeSet<String> {
    let (mut names, mut waiting) = (BTreeSet::new(), vec![expr]);
    while let Some(expr) = waiting.pop() {
        let mut found: Vec<&String> = Vec::new();
        match expr {
            Expr::Number(_) => {}
            Expr::Name(name) => found.push(name),
            Expr::Member(family, parts) => {
                found.push(family);
                waiting.extend(parts);
            }
            Expr::Minus(operand) => waiting.push(operand),
            Expr::Chain(first, rest) => {
                waiting.push(first);
                waiting.extend(rest.iter().map(|(_, operand)| operand));
            }
            Expr::Power(base, exponent) => waiting.extend([&**base, &**exponent]),
            Expr::Call(_, arguments, options) => {
                waiting.extend(arguments);
                found.extend(options.iter().map(|(_, word)| word));
            }
            Expr::Over(_, _, parts) => waiting.extend(parts.iter()),
        }
        for name in found {
            if names.insert(name.clone()) {
                waiting.extend(definitions.get(name).map(|definition| &**definition));
            }
        }
    }
    names
}

impl Memo {
    /// The names whose meaning a definition depends on.
    pub fn names(
        &self,
        name: &str,
        definition: &Expr,
        definitions: &BTreeMap<String, Rc<Expr>>,
    ) -> Rc<BTreeSet<String>> {
        let mut known = self.names.borrow_mut();
        let found = || Rc::new(names(definition, definitions));
        Rc::clone(known.entry(name.to_owned()).or_insert_with(found))
    }

    /// The value of a definition for a scheme, where its names have these meanings.
    pub fn get(&self, name: &str, scheme: usize, meanings: &[Option<Value>]) -> Option<Value> {
        let known = self.known.borrow();
        let known = known.get(&(name.to_owned(), scheme))?;
        known.iter().find(|(key, _)| key == meanings).map(|(_, value)| value.clone())
    }

    /// Keeps it.
    pub fn keep(&self, name: &str, scheme: usize, meanings: Vec<Option<Value>>, value: &Value) {
        let mut known = self.known.borrow_mut();
        let known = known.entry((name.to_owned(), scheme)).or_default();
        if known.len() < MAX_VALUES {
            known.push((meanings, value.clone()));
        }
    }
}
