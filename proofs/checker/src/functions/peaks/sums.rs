//! The sums whose greatest values are looked for.

#![warn(clippy::arithmetic_side_effects)]

use super::cell::{Bounds, Cell, Row};
use super::fixed::Fixed;
use num_bigint::BigInt;
use num_traits::{Signed as _, Zero as _};

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
    Cell { level: 0, rows: (0..fixed.size).map(row).collect() }
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
        (from..to).map(|t| Cell { level: 0, rows: vec![row(t)] }).collect()
    }

    /// An upper bound of the sum on a cell.
    pub fn above(self, cell: &Cell, total: &BigInt) -> BigInt {
        let mut rows = cell.rows.iter();
        if self == Sum::Step {
            return rows.next().map(|row| row.bounds(total)).unwrap_or_default()[1].clone();
        }
        // max(0, f) is f + max(0, −f). Those that are about positive are summed first, so that what they lose and gain is
        // balanced.
        let (mut sum, mut rest) = (None::<Row>, BigInt::zero());
        for row in rows {
            let [low, high] = row.bounds(total);
            if (&low + &high).is_positive() {
                rest += (-low).max(BigInt::zero());
                match &mut sum {
                    Some(sum) => sum.add(row),
                    None => sum = Some(row.clone()),
                }
            } else {
                rest += high.max(BigInt::zero());
            }
        }
        rest + sum.map(|sum| sum.bounds(total)).unwrap_or_default()[1].clone()
    }

    /// A lower bound of the sum at the beginning of a cell.
    pub fn at_start(self, cell: &Cell, fixed: &Fixed, total: &BigInt) -> BigInt {
        let low = |row: &Row| {
            let [low, _]: Bounds = row.at_start(fixed, total);
            if self == Sum::Positive { low.max(BigInt::zero()) } else { low }
        };
        cell.rows.iter().map(low).sum()
    }
}
