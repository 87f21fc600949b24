//! Printed tables of orders of smoothness and of Hölder exponents.

use std::sync::Arc;

/// A printed table of orders of smoothness and of Hölder exponents. Each cell is a claim of its own
/// ([`super::SmoothnessClaim`]).
#[derive(Clone, Debug, PartialEq)]
pub struct RegularityTable {
    /// Its id within the paper.
    pub id: String,
    /// Where it stands: `Table 2`.
    pub locus: String,
    /// Its title, in words.
    pub title: String,
    /// What the rows are: `scheme`, or the label of a parameter.
    pub label: String,
    /// The header of each row, as printed.
    pub rows: Vec<String>,
    /// What each column states: `order`, `exponent`, ….
    pub columns: Vec<String>,
    /// A note for the reader.
    pub note: Option<String>,
}

/// A cell of such a table.
#[derive(Clone, Debug, PartialEq)]
pub struct RegularityCell {
    /// The table.
    pub table: Arc<RegularityTable>,
    /// The row, counted from 0.
    pub row: usize,
    /// The column, counted from 0.
    pub column: usize,
    /// The cell as printed.
    pub printed: String,
    /// The header of the row, with the name of the parameter if it is a value: `w = 1/16`.
    pub header: String,
}

impl RegularityCell {
    /// Where the cell stands: `Table 2 (w = 1/16, exponent)`.
    #[must_use]
    pub fn locus(&self) -> String {
        let RegularityCell { table, column, header, .. } = self;
        format!("{} ({header}, {})", table.locus, table.columns[*column])
    }
}
