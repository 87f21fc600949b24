//! The tree of a search, as data that another program can follow.

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
