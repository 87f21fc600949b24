//! The tree of a search, as data that another program can check.

use super::uniform::UniformBound;
use crate::exact::{Integer, Rational};

/// Why no row below a node has a norm above the greatest one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Closed {
    /// The node is itself a row of E^c.
    Row,
    /// The bound by the line through two rows of the node (`proofs/THEOREMS.md`, 62); for
    /// a product, the bound by both lines (65).
    Line,
    /// ‖E^m‖ times the largest norm of the rows of the node (`proofs/THEOREMS.md`, 60); for a
    /// product, the product of the lesser of the bounds 60 and 62 of each operator.
    Largest,
}

/// A node that is not split. The rows index·n^m, …, (index + 1)·n^m − 1 of E^c are below it,
/// where m = c − level.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Leaf {
    /// The level of the node.
    pub level: u32,
    /// The index of the node, from 0 to n^level − 1.
    pub index: Integer,
    /// The reason why the node is not split.
    pub closed: Closed,
}

/// Leaves that cover all rows of E^c = R^c/s^c, for one operator or for two, and the bounds of
/// lower powers on which their bounds rest.
#[derive(Clone, Debug, PartialEq)]
pub struct SearchTree {
    /// The index offset o of the rows that the leaves count.
    pub offset: i64,
    /// ‖E^c‖; for two operators, the greatest product of the norms of two rows of the same
    /// index.
    pub norm: Rational,
    /// One operator or two.
    pub operators: Vec<SearchedOperator>,
    /// The leaves, in the order of the rows below them.
    pub leaves: Vec<Leaf>,
}

/// The bounds of lower powers on which a tree rests, for one operator.
#[derive(Clone, Debug, PartialEq)]
pub struct SearchedOperator {
    /// s.
    pub factor: Rational,
    /// Upper bounds of ‖E^m‖ for m = 0, …, c − 1.
    pub totals: Vec<Rational>,
    /// A bound of all ‖E^m‖, if one was found. Totals that differ from it are norms.
    pub uniform: Option<UniformBound>,
}
