//! Rows and columns of refuted cells: no reading of one of them alone gives these, other than by luck.

use super::luck::{BothEvidence, Evidence};
use super::members::explained;
use crate::kinds::table::claim::{Cells, Place, Table};
use crate::numbers::{Q, Value, count};
use crate::text::Stop;
use std::collections::{BTreeMap, BTreeSet};

/// How many rows down and columns to the right the value of a cell may stand.
pub const SHIFTS: [(isize, isize); 5] = [(0, 0), (0, 1), (0, -1), (1, 0), (-1, 0)];

/// The most cells of a table whose rows and columns have readings of their own.
const MAX_CELLS: usize = 400;

/// The most rows and columns that have readings of their own.
pub const MAX_LINES: usize = 8;

/// A row or column with a refuted cell.
pub struct Line {
    /// Its cells that no reading explains.
    pub cells: Cells,
    /// The most of them that a reading explains by luck: one that brings no constant, another first member, and a copied one.
    pub by_luck: [usize; 3],
}

/// The number of readings of rows and columns for each reading of the table.
pub fn readings(table: &Table<'_>) -> Q {
    let (rows, columns) = table.size();
    count(SHIFTS.len()) * count(rows + columns)
}

/// Whether m cells of a row or column are luck for so many readings of the table.
pub fn is_luck(table: &Table<'_>, cells: &Evidence, m: usize, size: &Q) -> Result<bool, Stop> {
    Ok(!cells.are_several(m) || cells.is_luck(table, m, &(size * readings(table)))?)
}

/// The rows and columns with refuted cells, where `left` are the cells that no reading explains. Empty for large tables,
/// and for those that are one row or column.
pub fn lines(
    table: &Table<'_>,
    left: &Cells,
    refuted: &[Place],
    sizes: &[Q; 2],
    evidence: impl Fn(&Cells) -> Result<BothEvidence, Stop>,
) -> Result<Vec<Line>, Stop> {
    let (rows, columns) = table.size();
    if rows.min(columns) < 2 || rows * columns > MAX_CELLS {
        return Ok(Vec::new());
    }
    let of_rows: BTreeSet<_> = refuted.iter().map(|(row, _)| (0, *row)).collect();
    let of_columns = refuted.iter().map(|(_, column)| (1, *column)).collect();
    let mut lines = Vec::new();
    for (axis, number) in of_rows.union(&of_columns) {
        let inside = |(place, _): &&(Place, _)| [place.0, place.1][*axis] == *number;
        let cells: Cells = left.iter().filter(inside).cloned().collect();
        let evidence = evidence(&cells)?;
        let mut by_luck = [cells.len(); 3];
        let [first, both] = sizes;
        let kinds = [(false, first), (true, first), (true, both)];
        for (most, (constants, size)) in by_luck.iter_mut().zip(kinds) {
            // More cells are less likely.
            while *most > 0 && !is_luck(table, evidence.of(constants), *most, size)? {
                *most -= 1;
            }
        }
        // No reading explains more than all of them.
        if by_luck.iter().any(|most| *most < cells.len()) {
            lines.push(Line { cells, by_luck });
        }
    }
    Ok(lines)
}

impl Line {
    /// The values that these cells have if they stand in the cells so far away; `values` are those of the printed cells.
    pub fn shifted(
        &self,
        table: &Table<'_>,
        values: &BTreeMap<Place, Option<&Value>>,
        shift: (isize, isize),
    ) -> Vec<Option<Value>> {
        let value = |place| values.get(&table.moved(place, shift)?).copied().flatten().cloned();
        self.cells.iter().map(|(place, _)| value(*place)).collect()
    }

    /// Whether these values explain so many cells that it is no luck for a reading of this kind, counted as above.
    pub fn is_explained(
        &self,
        values: &[Option<Value>],
        decimals: &str,
        kind: usize,
    ) -> Result<bool, Stop> {
        Ok(explained(&self.cells, values, decimals)?.len() > self.by_luck[kind])
    }
}
