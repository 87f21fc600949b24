//! The sums whose greatest values are looked for.

#![warn(clippy::arithmetic_side_effects)]

use super::cell::{Cell, Row};
use super::fixed::Fixed;

/// A sum of shifts of φ.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Sum {
    /// Σ_k max(0, φ(x − k)).
    Positive,
    /// Σ_{k≥0} φ(x − k).
    Step,
}

/// The cell from 0 to 1, with the rows of the φ(x − k) that are not 0 there.
pub fn unit(fixed: &Fixed) -> Cell {
    let row = |k: usize| Row::of((0..fixed.size).map(|q| q == k));
    let parts = (0..fixed.size).map(row).collect();
    Cell { level: 0, whole: Row::of((0..fixed.size).map(|_| false)), parts }
}

impl Sum {
    /// Cells that cover all x at which the sum is not 0 or 1, or of which the others are translates.
    pub fn cells(self, fixed: &Fixed) -> Vec<Cell> {
        if self == Sum::Positive {
            return vec![unit(fixed)];
        }
        // For x = t + y, φ(x − k) = φ(y − q) with q = k − t.
        let from = fixed.last().saturating_neg();
        let to = fixed.first.saturating_neg();
        let window = fixed.first..=fixed.last();
        let row = |t: i64| Row::of(window.clone().map(|q| q >= t.saturating_neg()));
        let cell = |t| Cell { level: 0, whole: row(t), parts: Vec::new() };
        (from..to).map(cell).collect()
    }
}
