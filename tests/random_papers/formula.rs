//! Formulas as trees: their text for claim files, and their values by the letter of FORMAT.md.

use crate::random_papers::naive::{Curve, Q, int};
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::collections::BTreeMap;
use std::fmt;

#[derive(Clone, Debug, PartialEq)]
pub enum Tree {
    Number(Q),
    Name(String),
    Minus(Box<Tree>),
    /// One of `+ - * / ^`.
    Of(char, Box<[Tree; 2]>),
    Call(&'static str, Vec<Tree>),
    /// Index, from, to, term.
    Sum(String, Box<[Tree; 3]>),
    Member(String, Vec<Tree>),
}

pub fn number(p: i64, q: i64) -> Tree {
    Tree::Number(Q::new(p.into(), q.into()))
}

pub fn name(name: &str) -> Tree {
    Tree::Name(name.to_owned())
}

pub fn of(operator: char, left: Tree, right: Tree) -> Tree {
    Tree::Of(operator, Box::new([left, right]))
}

pub fn times(left: Tree, right: Tree) -> Tree {
    of('*', left, right)
}

pub fn call(function: &'static str, arguments: &[Tree]) -> Tree {
    Tree::Call(function, arguments.to_vec())
}

impl Tree {
    /// How tightly it binds: sums 1, products 2, signs 3, powers 4, all others 5.
    fn strength(&self) -> u8 {
        match self {
            Tree::Number(value) if value.is_negative() => 0,
            Tree::Number(value) if !value.is_integer() => 2,
            Tree::Of('+' | '-', _) => 1,
            Tree::Of('*' | '/', _) => 2,
            Tree::Minus(_) => 3,
            Tree::Of(..) => 4,
            _ => 5,
        }
    }

    fn within(&self, least: u8, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.strength() < least { write!(f, "({self})") } else { write!(f, "{self}") }
    }
}

fn list(items: &[Tree]) -> String {
    items.iter().map(ToString::to_string).collect::<Vec<String>>().join(", ")
}

impl fmt::Display for Tree {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Tree::Number(value) => write!(f, "{value}"),
            Tree::Name(name) => f.write_str(name),
            Tree::Minus(part) => {
                f.write_str("-")?;
                part.within(3, f)
            }
            Tree::Of(operator, parts) => {
                let (left, right) = match operator {
                    '+' | '-' => (1, 2),
                    '*' | '/' => (2, 3),
                    _ => (5, 4),
                };
                parts[0].within(left, f)?;
                f.write_str(&operator.to_string())?;
                parts[1].within(right, f)
            }
            Tree::Call(name, arguments) => write!(f, "{name}({})", list(arguments)),
            Tree::Sum(index, parts) => {
                let [from, to, term] = &**parts;
                write!(f, "sum({index} = {from}..{to}, {term})")
            }
            Tree::Member(family, positions) => write!(f, "{family}[{}]", list(positions)),
        }
    }
}

/// What names mean, in the order of FORMAT.md: indices of folds, values, definitions.
#[derive(Clone, Default)]
pub struct Env<'a> {
    pub values: BTreeMap<String, Q>,
    pub definitions: Option<&'a BTreeMap<String, Tree>>,
    /// The scheme that functions are about.
    pub scheme: Option<&'a Curve>,
}

/// How deep definitions may lead.
const MAX_DEPTH: usize = 40;

/// The greatest exponent.
const MAX_EXPONENT: i64 = 80;

impl Env<'_> {
    /// The value of a formula; none where it has none, or is beyond what is looked at here.
    pub fn value(&self, tree: &Tree) -> Option<Q> {
        self.within(tree, &mut Vec::new(), 0)
    }

    fn within(&self, tree: &Tree, indices: &mut Vec<(String, Q)>, depth: usize) -> Option<Q> {
        if depth > MAX_DEPTH {
            return None;
        }
        match tree {
            Tree::Number(value) => Some(value.clone()),
            Tree::Name(name) => self.named(name, indices, depth),
            Tree::Minus(part) => Some(-self.within(part, indices, depth + 1)?),
            Tree::Of(operator, parts) => {
                let left = self.within(&parts[0], indices, depth + 1)?;
                let right = self.within(&parts[1], indices, depth + 1)?;
                combined(*operator, &left, &right)
            }
            Tree::Call(function, arguments) => {
                let arguments: Option<Vec<Q>> =
                    arguments.iter().map(|part| self.within(part, indices, depth + 1)).collect();
                self.called(function, &arguments?)
            }
            Tree::Sum(index, parts) => {
                let from = integer(&self.within(&parts[0], indices, depth + 1)?)?;
                let to = integer(&self.within(&parts[1], indices, depth + 1)?)?;
                let mut total = Q::zero();
                for i in from..=to {
                    indices.push((index.clone(), int(i)));
                    let term = self.within(&parts[2], indices, depth + 1);
                    indices.pop();
                    total += term?;
                }
                Some(total)
            }
            Tree::Member(family, positions) => {
                let position = |part: &Tree| {
                    let position = self.within(part, &mut indices.clone(), depth + 1)?;
                    Some(integer(&position)?.to_string())
                };
                let positions: Option<Vec<String>> = positions.iter().map(position).collect();
                self.values.get(&format!("{family}[{}]", positions?.join(","))).cloned()
            }
        }
    }

    fn named(&self, name: &str, indices: &mut Vec<(String, Q)>, depth: usize) -> Option<Q> {
        let index = indices.iter().rev().find(|(index, _)| index == name);
        if let Some(value) = index.map(|(_, value)| value).or_else(|| self.values.get(name)) {
            return Some(value.clone());
        }
        self.within(self.definitions?.get(name)?, indices, depth + 1)
    }

    fn called(&self, function: &str, arguments: &[Q]) -> Option<Q> {
        let level = || u32::try_from(integer(arguments.first()?)?).ok().filter(|c| *c <= 4);
        Some(match (function, arguments) {
            ("contraction", [_]) => self.scheme?.greatest_difference(level()?),
            ("norm", [_]) => self.scheme?.norm(level()?),
            ("displacement", []) => self.scheme?.greatest_step(0),
            ("abs", [x]) => x.abs(),
            ("floor", [x]) => x.floor(),
            ("max", [x, y]) => x.max(y).clone(),
            ("min", [x, y]) => x.min(y).clone(),
            ("kronecker", [x, y]) => int(i64::from(x == y)),
            _ => return None,
        })
    }
}

fn integer(value: &Q) -> Option<i64> {
    value.is_integer().then(|| value.to_integer().to_i64()).flatten()
}

fn combined(operator: char, left: &Q, right: &Q) -> Option<Q> {
    Some(match operator {
        '+' => left + right,
        '-' => left - right,
        '*' => left * right,
        '/' if right.is_zero() => return None,
        '/' => left / right,
        _ => {
            let exponent = integer(right).filter(|exponent| exponent.abs() <= MAX_EXPONENT)?;
            let positive =
                num_traits::pow(left.clone(), usize::try_from(exponent.unsigned_abs()).ok()?);
            match (exponent < 0, positive.is_zero()) {
                (true, true) => return None,
                (true, false) => Q::one() / positive,
                _ => positive,
            }
        }
    })
}
