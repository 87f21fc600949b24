//! The tree of a search, as data that another program can follow.

use super::descent::{Descent, Space, product};
use super::growth::Growth;
use super::number::Number;
use super::search::Greatest;
use super::sweep::Search;
use super::uniform::UniformBound;
use crate::exact::{Integer, Rational};

/// Why the rows below a node are not greater than the greatest row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Closed {
    /// It is a row of R^c itself.
    Row,
    /// By the line through two of its rows: `proofs/THEOREMS.md`, 62; a product by both
    /// lines: 65.
    Line,
    /// By ‖E^m‖ times the largest of its rows: `proofs/THEOREMS.md`, 60; a product by the least
    /// bound of 60 and 62 of each operator.
    Largest,
}

/// A node that is not split: the rows index·n^m, …, (index + 1)·n^m − 1 of E^c are below it,
/// m = c − level.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Leaf {
    /// Its level.
    pub level: u32,
    /// From 0 to n^level − 1.
    pub index: Integer,
    /// What bounds its rows.
    pub closed: Closed,
}

/// Leaves that cover all rows of E^c = R^c/s^c, of one operator or of two, and what their bounds
/// rest on.
#[derive(Clone, Debug, PartialEq)]
pub struct SearchTree {
    /// The index offset o that the leaves are counted at.
    pub offset: i64,
    /// ‖E^c‖; of two operators, the greatest product of the norms of their rows of one index.
    pub norm: Rational,
    /// One or two.
    pub operators: Vec<SearchedOperator>,
    /// In the order of their indices.
    pub leaves: Vec<Leaf>,
}

/// What the bounds of a tree rest on, for one operator.
#[derive(Clone, Debug, PartialEq)]
pub struct SearchedOperator {
    /// s.
    pub factor: Rational,
    /// Upper bounds of ‖E^m‖ for m = 0, …, c − 1.
    pub totals: Vec<Rational>,
    /// A bound of all ‖E^m‖, if one was used; totals that differ from it are norms.
    pub uniform: Option<UniformBound>,
}

impl SearchTree {
    pub(super) fn new<const K: usize>(
        growths: [&Growth; K],
        levels: u32,
        greatest: Greatest,
        leaves: Vec<Leaf>,
    ) -> SearchTree {
        let operators = growths.map(Growth::operator);
        let denominators = operators.iter().map(|operator| &operator.denominator);
        let scale = denominators.fold(Integer::one(), |product, q| product * q);
        SearchTree {
            // Of R with all its columns.
            offset: operators[0].offset - i64::try_from(operators[0].skipped).expect("few columns"),
            norm: Rational::new(greatest.value, scale.pow(levels)),
            operators: growths.map(|growth| growth.operand(levels)).into(),
            leaves,
        }
    }
}

impl<T: Number, const K: usize> Search<'_, T, K> {
    /// A cover of all rows that shows the greatest one: each leaf is a row, or bounded by its
    /// own rows.
    pub(super) fn leaves(self, greatest: &Integer) -> Option<Vec<Leaf>> {
        let Search { descent, mut spaces, work, .. } = self;
        let arity = descent.problem.operators[0].arity;
        let limit = descent.limit(&T::from_integer(greatest));
        let mut leaves = Vec::new();
        let mut stack = vec![(0, Integer::zero(), descent.root().rows)];
        while let Some((level, index, rows)) = stack.pop() {
            let left = descent.problem.levels - level;
            let closed = match (level, left) {
                (_, 0) => Some(Closed::Row),
                (0, _) => None,
                _ => descent.closed(&mut spaces[0], &rows, left as usize, &limit),
            };
            if let Some(closed) = closed {
                leaves.push(Leaf { level, index, closed });
                continue;
            }
            for digit in (0..arity).rev() {
                *work = work.checked_sub(descent.cost)?;
                let mut part = descent.root().rows;
                descent.part(digit, &rows, &mut part);
                stack.push((level + 1, &index * Integer::from(arity) + Integer::from(digit), part));
            }
        }
        Some(leaves)
    }
}

impl<T: Number, const K: usize> Descent<'_, T, K> {
    /// What shows that the rows below a node are not above the limit.
    fn closed(
        &self,
        space: &mut Space<T, K>,
        rows: &[Vec<T>; K],
        left: usize,
        limit: &T,
    ) -> Option<Closed> {
        let mut bounds = self.largest(rows, left);
        let lines = self.lines(space, rows, left, &mut bounds);
        if lines.is_some_and(|lines| lines.bound <= *limit) {
            return Some(Closed::Line);
        }
        (product(&bounds) <= *limit).then_some(Closed::Largest)
    }
}
