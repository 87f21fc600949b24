//! How a formula depends on two indices.

use super::ast::{Expr, Node, Operator};
use super::located::LocatedFormula;
use std::collections::BTreeMap;
use std::ops::BitOr;

/// The function whose value depends only on the difference of its two arguments.
const KRONECKER: &str = "kronecker";

/// The greatest depth to which definitions are followed.
const MAX_DEPTH: u32 = 32;

/// What the value of a formula depends on, at most, of two indices i and j.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dependence {
    /// On neither index.
    Neither,
    /// On i only.
    First,
    /// On j only.
    Second,
    /// On j − i only.
    Difference,
    /// On i and j, with no known restriction.
    Both,
}

impl BitOr for Dependence {
    type Output = Dependence;
    fn bitor(self, other: Dependence) -> Dependence {
        match (self, other) {
            (Dependence::Neither, one) | (one, Dependence::Neither) => one,
            _ if self == other => self,
            _ => Dependence::Both,
        }
    }
}

/// Finds, from the text alone, how formulas over some definitions depend on two indices i
/// and j: on i, on j, or on j − i. Dependence on j − i is recognised where i and j stand
/// in one sum with coefficients of sum 0, such as j − i, or are compared by `kronecker`.
#[derive(Clone, Debug)]
pub struct IndexPair<'a> {
    names: [&'a str; 2],
    definitions: &'a BTreeMap<String, LocatedFormula>,
    known: BTreeMap<&'a str, Dependence>,
}

impl<'a> IndexPair<'a> {
    /// The analysis for the indices `names` = \[i, j\] in formulas over `definitions`.
    #[must_use]
    pub fn new(
        names: [&'a str; 2],
        definitions: &'a BTreeMap<String, LocatedFormula>,
    ) -> IndexPair<'a> {
        IndexPair { names, definitions, known: BTreeMap::new() }
    }

    /// What `formula` depends on.
    ///
    /// ```
    /// use subcert::formula::{Dependence, IndexPair, parse};
    ///
    /// let definitions = [].into();
    /// let mut pair = IndexPair::new(["i", "j"], &definitions);
    /// let mut of = |text| parse(text).map(|formula| pair.dependence(&formula));
    /// assert_eq!(of("mod(j - i, N)/4 + kronecker(i + 1, j)")?, Dependence::Difference);
    /// assert_eq!(of("(j - 2*i)^2")?, Dependence::Both);
    /// assert_eq!(of("cos(2*pi*j/N)")?, Dependence::Second);
    /// # Ok::<(), subcert::formula::FormulaError>(())
    /// ```
    pub fn dependence(&mut self, formula: &Expr) -> Dependence {
        self.of(formula, MAX_DEPTH)
    }

    /// The dependence of a name. A definition that refers to itself has no value, and
    /// counts as depending on both indices.
    fn of_name(&mut self, name: &str, depth: u32) -> Dependence {
        if let Some(known) = self.known.get(name) {
            return *known;
        }
        let definitions = self.definitions;
        match definitions.get_key_value(name) {
            None => Dependence::Neither,
            Some(_) if depth == 0 => Dependence::Both,
            Some((name, definition)) => {
                self.known.insert(name, Dependence::Both);
                let dependence = self.of(&definition.expr, depth - 1);
                self.known.insert(name, dependence);
                dependence
            }
        }
    }

    fn of(&mut self, expr: &Expr, depth: u32) -> Dependence {
        match &expr.node {
            Node::Name(name) if !self.names.contains(&name.as_str()) => self.of_name(name, depth),
            Node::Name(_) | Node::Negate(_) => self.of_sum(&[(expr, 1)], depth),
            Node::Chain(_, rest) if rest.iter().all(|(operator, _)| additive(*operator)) => {
                self.of_sum(&[(expr, 1)], depth)
            }
            Node::Call { function, arguments, options }
                if function == KRONECKER && options.is_empty() && arguments.len() == 2 =>
            {
                self.of_sum(&[(&arguments[0], 1), (&arguments[1], -1)], depth)
            }
            // An inner index hides i or j; and which member of a family is meant depends
            // on the values of the formula's indices. Neither is analysed further.
            Node::Fold { index, .. } if self.names.contains(&index.as_str()) => Dependence::Both,
            Node::Indexed { .. } => Dependence::Both,
            _ => self.of_all(&expr.parts(), depth),
        }
    }

    fn of_all(&mut self, parts: &[&Expr], depth: u32) -> Dependence {
        parts.iter().fold(Dependence::Neither, |all, part| all | self.of(part, depth))
    }

    /// The dependence of a sum of expressions with signs. Let a·i + b·j be the sum of the
    /// terms that are i or j themselves. It is a multiple of j − i exactly if a + b = 0.
    fn of_sum(&mut self, sum: &[(&Expr, i64)], depth: u32) -> Dependence {
        let (mut factors, mut others) = ([0_i64; 2], Vec::new());
        let mut waiting = sum.to_vec();
        while let Some((expr, sign)) = waiting.pop() {
            match &expr.node {
                Node::Name(name) if self.names.contains(&name.as_str()) => {
                    factors[usize::from(*name == self.names[1])] += sign;
                }
                Node::Negate(operand) => waiting.push((operand, -sign)),
                Node::Chain(first, rest)
                    if rest.iter().all(|(operator, _)| additive(*operator)) =>
                {
                    waiting.push((first, sign));
                    let signed = |operator| if operator == Operator::Add { sign } else { -sign };
                    waiting.extend(rest.iter().map(|(operator, part)| (part, signed(*operator))));
                }
                _ => others.push(expr),
            }
        }
        let own = match factors {
            [0, 0] => Dependence::Neither,
            [_, 0] => Dependence::First,
            [0, _] => Dependence::Second,
            [a, b] if a + b == 0 => Dependence::Difference,
            _ => Dependence::Both,
        };
        own | self.of_all(&others, depth)
    }
}

fn additive(operator: Operator) -> bool {
    matches!(operator, Operator::Add | Operator::Subtract)
}
