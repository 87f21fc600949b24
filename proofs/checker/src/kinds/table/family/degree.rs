//! Degrees of formulas in a parameter.

use crate::formulas::{Definitions, Expr, Head};
use crate::kinds::table::claim::{Read, Table};
use crate::numbers::Q;
use num_traits::ToPrimitive;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

/// How deep definitions and parts of a formula may be nested.
const MAX_DEPTH: usize = 200;

/// The functions that are not about schemes.
pub const OF_NUMBERS: [&str; 10] =
    ["abs", "binomial", "ceil", "cos", "factorial", "floor", "kronecker", "max", "min", "mod"];

/// Whether the value of a table has the degree 1 in a parameter under a reading.
pub fn is_linear(table: &Table<'_>, name: &str, read: &Read) -> bool {
    let definitions = read.definitions.as_ref().unwrap_or(&table.paper.definitions);
    let mut form = Form { definitions, name, schemes: false, known: RefCell::default() };
    form.schemes = form.in_references(table);
    form.degree(&table.value, 0) == Some(1)
}

/// Whether the form of a formula of a table's cells depends on a parameter.
pub fn depends(table: &Table<'_>, expr: &Expr, name: &str) -> bool {
    let definitions = &table.paper.definitions;
    let mut form = Form { definitions, name, schemes: false, known: RefCell::default() };
    form.schemes = form.in_references(table);
    form.meets(expr)
}

struct Form<'f> {
    definitions: &'f Definitions,
    name: &'f str,
    /// Whether the parameter occurs in a reference to a scheme.
    schemes: bool,
    /// The degrees of definitions that are known.
    known: RefCell<BTreeMap<String, Option<i64>>>,
}

impl Form<'_> {
    /// Whether the parameter occurs in a reference to a scheme: one of the table, or a `use`.
    fn in_references(&self, table: &Table<'_>) -> bool {
        let named = table.paper.file.list("scheme").iter();
        let uses = named.filter_map(|scheme| scheme.text("use"));
        table.schemes().into_iter().chain(uses).any(|reference| {
            let mut words = reference.split(|c: char| !c.is_alphanumeric() && c != '_');
            words.any(|word| self.meets(&Expr::Name(word.to_owned())))
        })
    }

    /// Whether the parameter occurs in a formula, or in the definitions and schemes that it uses.
    fn meets(&self, expr: &Expr) -> bool {
        let (mut met, mut waiting) = (BTreeSet::new(), vec![expr]);
        while let Some(expr) = waiting.pop() {
            let mut names: Vec<&str> = Vec::new();
            match expr {
                Expr::Name(name) => names.push(name),
                Expr::Of(Head::Call(function, options), _) => {
                    if self.schemes && !OF_NUMBERS.contains(&&function[..]) {
                        return true;
                    }
                    let named = |option: &str| ["sequence", "with"].contains(&option);
                    let of = options.iter().filter(|(option, _)| named(option));
                    names.extend(of.map(|(_, word)| &word[..]));
                }
                Expr::Number(_) | Expr::Of(..) => {}
            }
            if let Expr::Of(_, parts) = expr {
                waiting.extend(parts);
            }
            for name in names {
                if name == self.name {
                    return true;
                }
                if met.insert(name) {
                    waiting.extend(self.definitions.get(name).map(|definition| &**definition));
                }
            }
        }
        false
    }

    /// The degree of a formula; `None` if it has none.
    fn degree(&self, expr: &Expr, depth: usize) -> Option<i64> {
        if !self.meets(expr) {
            return Some(0);
        }
        if depth > MAX_DEPTH {
            return None;
        }
        let of = |part: &Expr| self.degree(part, depth + 1);
        let common = |parts: &[Expr]| {
            let degrees: Option<BTreeSet<i64>> = parts.iter().map(of).collect();
            degrees.filter(|degrees| degrees.len() == 1)?.pop_first()
        };
        let Expr::Of(head, parts) = expr else {
            return match expr {
                Expr::Name(name) if name == self.name => Some(1),
                Expr::Name(name) => {
                    if let Some(known) = self.known.borrow().get(name) {
                        return *known;
                    }
                    let degree = of(self.definitions.get(name)?);
                    self.known.borrow_mut().insert(name.clone(), degree);
                    degree
                }
                _ => None,
            };
        };
        match head {
            Head::Minus => of(&parts[0]),
            Head::Chain(operators) if operators.iter().all(|c| ['+', '-'].contains(c)) => {
                common(parts)
            }
            Head::Chain(operators) => {
                let mut degree = of(&parts[0])?;
                for (operator, part) in operators.iter().zip(&parts[1..]) {
                    let other = of(part)?;
                    degree = degree.checked_add(if *operator == '/' { -other } else { other })?;
                }
                Some(degree)
            }
            Head::Power => of(&parts[0])?.checked_mul(written(&parts[1])?),
            Head::Call(function, _) => match &function[..] {
                "abs" | "max" | "min" => common(parts),
                "surface_displacement" if !self.schemes => common(parts),
                _ => None,
            },
            // A product has as many factors as its range has numbers.
            Head::Over(fold, _) if fold == "product" => None,
            Head::Over(_, index) => {
                let free = index != self.name && parts[..2].iter().all(|end| !self.meets(end));
                if free { of(&parts[2]) } else { None }
            }
            Head::Member(_) => None,
        }
    }
}

/// The value of an integer literal, with a sign or without.
fn written(exponent: &Expr) -> Option<i64> {
    match exponent {
        Expr::Number(value) => value.rational().filter(Q::is_integer)?.to_integer().to_i64(),
        Expr::Of(Head::Minus, parts) => written(&parts[0])?.checked_neg(),
        _ => None,
    }
}
