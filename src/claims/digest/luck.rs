//! Readings that explain a cell by luck.

use crate::claim::Promise;
use crate::exact::{Integer, Rational};
use crate::finding::{Explanation, TableFinding};
use crate::judge::reading::chance::one_in;

impl TableFinding<'_> {
    /// Whether a reading explains the cell at a row and a column, counted from 0, by luck. It does
    /// if it explains at most Σ p_i of the other cells of this kind, where p_i is the likelihood
    /// that an unrelated value becomes the i-th printed number (`proofs/THEOREMS.md`, 51). It does
    /// not if there are no other cells of this kind, or if it was found to be the reading of the
    /// table, or of the row or column of the cell.
    ///
    /// # Panics
    /// When there is no such cell, or the reading is one of another table.
    #[must_use]
    pub fn is_by_luck(&self, reading: &Explanation, (row, column): (usize, usize)) -> bool {
        let found = self.searches().flat_map(|search| {
            search.best.iter().chain(search.lines.iter().map(|line| &line.best))
        });
        let mut found = found.filter(|found| found.explained[row][column]);
        let is = |found: &Explanation| {
            found.differences == reading.differences && found.solved == reading.solved
        };
        if !reading.explained[row][column] || found.any(is) {
            return false;
        }
        let depths = matches!(self.table.promise, Some(Promise::Depth { .. }));
        let kind = self.cells[row][column].kind();
        let (mut others, mut explained, mut by_luck) = (false, 0, Rational::zero());
        for (i, cells) in self.cells.iter().enumerate() {
            for (j, cell) in cells.iter().enumerate().filter(|(j, _)| (i, *j) != (row, column)) {
                let printed = self.table.cells[i][j].printed().filter(|_| kind.holds(cell));
                let Some(printed) = printed else { continue };
                others = true;
                explained += usize::from(reading.explained[i][j]);
                by_luck += &Rational::new(1, Integer::from(one_in(printed, depths)));
            }
        }
        others && Rational::from(explained) <= by_luck
    }
}
