//! Degrees of formulas in a parameter.
//!
//! Values at some parameters do not show that a formula is proportional to the parameter:
//! w + (w − 1)(w − 2)(w − 3) is 1, 2 and 3 at w = 1, 2 and 3. The form of the formula shows it.

use crate::claim::{Paper, SchemeSource, Table};
use crate::formula::{Expr, Fold, LocatedFormula, Node, Operator, OptionWord};
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

/// The greatest depth to which definitions and parts of a formula are followed.
const MAX_DEPTH: usize = 200;

/// The functions of the language; all others are of schemes.
pub(super) const LANGUAGE: [&str; 10] =
    ["abs", "min", "max", "floor", "ceil", "mod", "kronecker", "binomial", "factorial", "cos"];

/// The degrees of formulas in a parameter p > 0: a formula of degree d is c·p^d, where c does not
/// depend on p.
///
/// The rules are those of `proofs/format/table.md`.
pub(crate) struct Degrees<'a> {
    definitions: &'a BTreeMap<String, LocatedFormula>,
    name: &'a str,
    /// Whether the schemes may depend on the parameter.
    schemes_vary: bool,
    known: RefCell<BTreeMap<&'a str, Option<i64>>>,
}

impl<'a> Degrees<'a> {
    pub(super) fn new(
        paper: &'a Paper,
        definitions: &'a BTreeMap<String, LocatedFormula>,
        table: &Table,
        name: &'a str,
    ) -> Degrees<'a> {
        let known = RefCell::default();
        let mut degrees = Degrees { definitions, name, schemes_vary: false, known };
        let aliases = paper.schemes.values().filter_map(|source| match source {
            SchemeSource::Alias(other) => Some(other),
            SchemeSource::Own(_) => None,
        });
        degrees.schemes_vary =
            table.schemes().map(|own| &own.reference).chain(aliases).any(|reference| {
                let text = reference.to_string();
                let mut words = text.split(|c: char| !c.is_alphanumeric() && c != '_');
                words.any(|word| !degrees.is_free_name(word))
            });
        degrees
    }

    fn is_free_name(&self, name: &str) -> bool {
        name != self.name
            && self.definitions.get(name).is_none_or(|definition| self.is_free(&definition.expr))
    }

    /// Whether the parameter occurs neither in a formula nor in the definitions and schemes that it
    /// uses.
    pub(super) fn is_free(&self, expr: &Expr) -> bool {
        let (mut met, mut waiting) = (BTreeSet::new(), vec![expr]);
        while let Some(expr) = waiting.pop() {
            if self.schemes_vary && expr.functions().iter().any(|name| !LANGUAGE.contains(name)) {
                return false;
            }
            for name in expr.names() {
                if name == self.name {
                    return false;
                }
                if let Some((name, definition)) = self.definitions.get_key_value(name)
                    && met.insert(name)
                {
                    waiting.push(&definition.expr);
                }
            }
        }
        true
    }

    /// The degree of a formula; `None` if these rules give none.
    pub(crate) fn of(&self, expr: &'a Expr) -> Option<i64> {
        self.within(expr, 0)
    }

    fn within(&self, expr: &'a Expr, depth: usize) -> Option<i64> {
        if self.is_free(expr) {
            return Some(0);
        }
        let of = |part: &'a Expr| self.within(part, depth + 1);
        let common = |parts: &'a [Expr]| {
            let first = of(parts.first()?)?;
            parts.iter().all(|part| of(part) == Some(first)).then_some(first)
        };
        if depth > MAX_DEPTH {
            return None;
        }
        match &expr.node {
            Node::Name(name) if name == self.name => Some(1),
            Node::Name(name) => {
                let (name, definition) = self.definitions.get_key_value(name)?;
                if let Some(known) = self.known.borrow().get(&name[..]) {
                    return *known;
                }
                let degree = of(&definition.expr);
                self.known.borrow_mut().insert(name, degree);
                degree
            }
            Node::Negate(operand) => of(operand),
            Node::Chain(first, rest) => {
                rest.iter().try_fold(of(first)?, |degree, (operator, operand)| match operator {
                    Operator::Multiply => degree.checked_add(of(operand)?),
                    Operator::Divide => degree.checked_sub(of(operand)?),
                    Operator::Add | Operator::Subtract => {
                        (of(operand)? == degree).then_some(degree)
                    }
                })
            }
            Node::Power(base, exponent) => of(base)?.checked_mul(written(exponent)?),
            Node::Call { function, arguments, .. } => match &function[..] {
                "abs" | "min" | "max" => common(arguments),
                "surface_displacement" if !self.schemes_vary => common(arguments),
                _ => None,
            },
            // A product of several values has another degree.
            Node::Fold { fold, index, from, to, body } if *fold != Fold::Product => {
                let free = index != self.name && self.is_free(from) && self.is_free(to);
                if free { of(body) } else { None }
            }
            Node::Number(_) | Node::Indexed { .. } | Node::Fold { .. } => None,
        }
    }

    /// The arguments of all calls of `levels` in a formula and in the definitions that it uses.
    pub(super) fn levels(&self, expr: &'a Expr) -> Vec<&'a [Expr]> {
        let (mut found, mut met, mut waiting) = (Vec::new(), BTreeSet::new(), vec![expr]);
        while let Some(expr) = waiting.pop() {
            let mut names: Vec<&'a str> = Vec::new();
            match &expr.node {
                Node::Name(name) => names.push(name),
                Node::Call { function, arguments, options } => {
                    if function == "levels" {
                        found.push(&arguments[..]);
                    }
                    names.extend(options.iter().filter_map(OptionWord::definition));
                }
                _ => {}
            }
            waiting.extend(expr.parts());
            for name in names {
                if let Some(definition) = self.definitions.get(name)
                    && met.insert(name)
                {
                    waiting.push(&definition.expr);
                }
            }
        }
        found
    }
}

/// The value of an integer literal, with a sign or without.
fn written(exponent: &Expr) -> Option<i64> {
    match &exponent.node {
        Node::Number(value) => value.numerator().to_i64().filter(|_| value.is_integer()),
        Node::Negate(operand) => written(operand)?.checked_neg(),
        _ => None,
    }
}
