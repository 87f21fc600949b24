//! A table and its cells as printed.

use crate::diagnostic::SourceText;
use crate::exact::{Decimal, Rational};
use crate::formula::LocatedFormula;
use crate::scheme::Reference;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

/// A table: its printed cells, and the formula they are said to equal.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Its id within the paper.
    pub id: String,
    /// Where it stands, as the paper calls it: `Table 13`.
    pub locus: String,
    /// Its content, in words.
    pub title: String,
    /// The scheme of the cells, where no headers are schemes; its parameters may depend on the
    /// cell.
    pub scheme: Option<LocatedReference>,
    /// The formula that each cell is said to equal.
    pub value: LocatedFormula,
    /// What a cell promises beyond its value.
    pub promise: Option<Promise>,
    /// The row headers, when there are any.
    pub rows: Option<Axis>,
    /// The column headers.
    pub columns: Axis,
    /// The cells, row by row.
    pub cells: Vec<Vec<Cell>>,
    /// Values that the paper states for parameters of this table.
    pub given: BTreeMap<String, LocatedFormula>,
    /// Parameters that the paper does not state. The program recovers them from the printed
    /// numbers where it can. With a value to assume, it shows what the formula gives there, and
    /// the cells stay not checkable.
    pub unstated: BTreeMap<String, Option<LocatedFormula>>,
    /// The figures of the paper that plot numbers of this table.
    pub figures: Vec<Figure>,
    /// A note for the reader.
    pub note: Option<String>,
}

/// A figure that plots numbers of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Figure {
    /// What the paper calls it: `Figure 1(a)`.
    pub locus: String,
    /// The rows that it plots, or else the columns, by their headers as printed; none where it plots all numbers.
    pub lines: Vec<String>,
}

impl Table {
    /// The number of cells.
    #[must_use]
    pub fn cell_count(&self) -> usize {
        self.cells.iter().map(Vec::len).sum()
    }

    /// The axes: that of the rows, if there is one, and that of the columns.
    pub fn axes(&self) -> impl Iterator<Item = &Axis> {
        self.rows.iter().chain([&self.columns])
    }

    /// The scheme of a cell: the header of its row or of its column, or the table's scheme.
    #[must_use]
    pub fn scheme_at(&self, row: usize, column: usize) -> Option<&LocatedReference> {
        let of_row = self.rows.as_ref().and_then(|axis| axis.schemes().get(row));
        of_row.or_else(|| self.columns.schemes().get(column)).or(self.scheme.as_ref())
    }

    /// Every scheme that a cell may have.
    pub fn schemes(&self) -> impl Iterator<Item = &LocatedReference> {
        self.scheme.iter().chain(self.axes().flat_map(Axis::schemes))
    }
}

/// A scheme reference and its place in the claim file.
#[derive(Clone, Debug, PartialEq)]
pub struct LocatedReference {
    /// The reference.
    pub reference: Reference,
    /// The file.
    pub source: Arc<SourceText>,
    /// The bytes that it takes, quotes included.
    pub span: Range<usize>,
}

/// What a cell promises: a distance that is small enough, or a level that is
/// high enough, for every control polygon of the given spread.
#[derive(Clone, Debug, PartialEq)]
pub enum Promise {
    /// The cell is a depth: from that level on, the distance is at most the
    /// tolerance.
    Depth {
        /// ε.
        tolerance: LocatedFormula,
        /// β = max|Δ^0|.
        spread: LocatedFormula,
        /// The index offset at which the paper compares polygon and limit.
        offset: Option<LocatedFormula>,
        /// The ring whose points are compared with their limit, if the promise is about a ring.
        ring: Option<LocatedReference>,
    },
    /// The cell is an upper bound of the distance at a level.
    Bound {
        /// k.
        level: LocatedFormula,
        /// β = max|Δ^0|.
        spread: LocatedFormula,
        /// The index offset at which the paper compares polygon and limit.
        offset: Option<LocatedFormula>,
        /// The ring whose points are compared with their limit, if the promise is about a ring.
        ring: Option<LocatedReference>,
    },
}

impl Promise {
    /// The ring whose points are compared with their limit, if the promise is about a ring.
    #[must_use]
    pub fn ring(&self) -> Option<&LocatedReference> {
        match self {
            Promise::Depth { ring, .. } | Promise::Bound { ring, .. } => ring.as_ref(),
        }
    }
}

/// The headers of the rows or of the columns.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What the paper prints above, or beside, all headers.
    pub label: String,
    /// The headers.
    pub entries: Vec<AxisEntry>,
    /// Their meanings, in the same order.
    pub headers: Headers,
}

/// One header.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisEntry {
    /// As printed.
    pub printed: String,
    /// The number that is read in place of the printed one, where the print at hand is damaged.
    pub read: Option<String>,
    /// A note for the reader; for a number, why its value is not the printed one.
    pub note: Option<String>,
}

/// What headers mean, in their order.
#[derive(Clone, Debug, PartialEq)]
pub enum Headers {
    /// The values of one parameter.
    Values {
        /// Its name in formulas.
        name: String,
        /// The values.
        values: Vec<Rational>,
    },
    /// The schemes that the cells are about; parameters may depend on the cell.
    Schemes(Vec<LocatedReference>),
}

impl Axis {
    /// The parameter's name in formulas; schemes have none.
    #[must_use]
    pub fn name(&self) -> Option<&str> {
        match &self.headers {
            Headers::Values { name, .. } => Some(name),
            Headers::Schemes(_) => None,
        }
    }

    /// The parameter's name, and its value at a header; schemes have none.
    #[must_use]
    pub fn value(&self, place: usize) -> Option<(&str, &Rational)> {
        match &self.headers {
            Headers::Values { name, values } => Some((name, values.get(place)?)),
            Headers::Schemes(_) => None,
        }
    }

    /// The schemes; none where the headers are numbers.
    #[must_use]
    pub fn schemes(&self) -> &[LocatedReference] {
        match &self.headers {
            Headers::Values { .. } => &[],
            Headers::Schemes(schemes) => schemes,
        }
    }
}

/// A cell.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// The source at hand has lost it.
    Lost,
    /// Nothing is printed there.
    Blank,
    /// It is printed.
    Printed(Printed),
}

impl Cell {
    /// The number, when it is printed.
    #[must_use]
    pub fn printed(&self) -> Option<&Printed> {
        match self {
            Cell::Printed(printed) => Some(printed),
            Cell::Lost | Cell::Blank => None,
        }
    }
}

/// A number as printed.
#[derive(Clone, Debug, PartialEq)]
pub struct Printed {
    /// The text as transcribed.
    pub text: String,
    /// The number that is read from it; a fraction is exact.
    pub decimal: Decimal,
    /// Why that number is not the text, where they differ.
    pub note: Option<String>,
    /// Its place in the claim file.
    pub span: Range<usize>,
}
