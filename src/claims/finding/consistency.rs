//! Tables of one paper that contradict each other.

use crate::claim::{Paper, Table};
use crate::exact::Rational;
use crate::finding::reading::{Difference, Line};
use std::fmt;

/// A choice or a parameter of which tables, rows or columns need different values.
#[derive(Clone, Debug, PartialEq)]
pub struct Contradiction {
    /// The choice, or the parameter.
    pub about: String,
    /// The sides: what is needed, and where.
    pub sides: Vec<Side>,
}

/// One side of a contradiction.
#[derive(Clone, Debug, PartialEq)]
pub struct Side {
    /// What is needed.
    pub needs: Needed,
    /// Where.
    pub places: Vec<TablePart>,
}

/// What places of tables need.
#[derive(Clone, Debug, PartialEq)]
pub enum Needed {
    /// A definition or a tolerance as printed.
    AsPrinted,
    /// A way of a choice, or an alternative of a definition.
    Difference(Difference),
    /// A value of a parameter.
    Value(String, Rational),
}

impl fmt::Display for Needed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Needed::AsPrinted => f.write_str("as printed"),
            Needed::Difference(difference) => difference.fmt(f),
            Needed::Value(name, value) => write!(f, "{name} = {value}"),
        }
    }
}

/// A table, or a row or column of one, that needs something.
#[derive(Clone, Debug, PartialEq)]
pub struct TablePart {
    /// The table's id within the paper.
    pub table: String,
    /// The row or column, where it is not the whole table.
    pub line: Option<Line>,
    /// How many of its cells are explained with what this side needs.
    pub explained: usize,
    /// How many of its cells at most are explained with what another side needs.
    pub otherwise: usize,
}

impl TablePart {
    /// The table of the paper to which it belongs.
    #[must_use]
    pub fn table_of<'p>(&self, paper: &'p Paper) -> Option<&'p Table> {
        paper.tables.iter().find(|table| table.id == self.table)
    }
}
