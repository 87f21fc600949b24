//! Quantities that a reading takes from another place of the paper.

use crate::claim::{LocatedReference, Paper, Table};
use crate::exact::Rational;
use crate::formula::Node;
use std::collections::BTreeSet;

/// Errors that are made when tables are copied: a constant is that of another row, column, table or
/// scheme, or a tolerance was itself computed and then rounded. And the same scheme with other
/// numbers of its points, on which masks that are read forwards depend.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Copied {
    /// A definition has the numbers that another table prints for it, at the same headers.
    Printed {
        /// The definition.
        of: String,
        /// The id of the table, whose value is this definition.
        table: String,
        /// Where the table stands.
        locus: String,
    },
    /// A definition has its value for another value of a parameter: that of another row, column or
    /// table.
    Parameter {
        /// The definition.
        of: String,
        /// The parameter.
        name: String,
        /// Its value.
        value: Rational,
    },
    /// A definition has its value for another scheme of the paper.
    Scheme {
        /// The definition.
        of: String,
        /// The place of the scheme among those of the paper's tables, from 0.
        number: usize,
        /// The scheme.
        scheme: String,
    },
    /// The tolerances were computed, and then rounded: before the rounding, the depth in one row is
    /// a whole number of levels; in one column, where the tolerances are the headers of the rows.
    Tolerance {
        /// The place of the row or column, from 0.
        line: usize,
        /// Its header, if it has one.
        header: String,
    },
    /// The points of all schemes are numbered from another one on
    /// ([`Rules::numbered_from`](crate::scheme::Rules::numbered_from)), and their masks are read
    /// forwards.
    Numbers {
        /// The number of the point that becomes number 0, from 1.
        first: usize,
    },
}

/// The schemes of the paper's tables, in their order, each text once.
pub(crate) fn references(paper: &Paper) -> Vec<&LocatedReference> {
    let mut met = BTreeSet::new();
    let all = paper.tables.iter().flat_map(Table::schemes);
    all.filter(|located| met.insert(located.reference.to_string())).collect()
}

/// Whether the value of a table is this definition alone, and the table prints a cell.
pub(crate) fn prints(table: &Table, definition: &str) -> bool {
    let lost = || table.cells.iter().flatten().all(|cell| cell.printed().is_none());
    matches!(&table.value.expr.node, Node::Name(name) if name == definition) && !lost()
}
