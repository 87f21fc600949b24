//! Cells (i/n^j, (i + 1)/n^j), and what sums Σ_q d_q φ(y − q) are on them.

#![warn(clippy::arithmetic_side_effects)]

use super::fixed::{DIGITS, Fixed, one};
use crate::numbers::Meter;
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{Signed as _, Zero as _};

/// The d_q of a sum, times 2^DIGITS, each wrong by at most `error`.
#[derive(Clone)]
pub struct Row {
    pub values: Vec<BigInt>,
    pub error: BigInt,
}

/// Two bounds, times 2^DIGITS.
pub type Bounds = [BigInt; 2];

/// x·y, rounded up.
fn above(x: &BigInt, y: &BigInt) -> BigInt {
    -((-(x * y)) >> DIGITS)
}

impl Row {
    /// The row of such a sum of integers.
    pub fn of(whole: impl IntoIterator<Item = bool>) -> Row {
        let value = |is| if is { one() } else { BigInt::zero() };
        Row { values: whole.into_iter().map(value).collect(), error: BigInt::zero() }
    }

    fn greatest_size(&self) -> BigInt {
        self.values.iter().map(BigInt::abs).max().unwrap_or_default()
    }

    /// The row on the part with a digit.
    fn part(&self, fixed: &Fixed, digit: usize) -> Row {
        let terms = fixed.terms.get(digit).map_or(&[][..], |terms| &terms[..]);
        let value = |sum: &Vec<(usize, BigInt)>| {
            let terms = sum.iter().filter_map(|(q, a)| Some(a * self.values.get(*q)?));
            terms.sum::<BigInt>() >> DIGITS
        };
        let values = terms.iter().map(value).collect();
        // The errors of the row, those of the coefficients, and that of the last shift.
        let coefficients = (self.greatest_size() * fixed.most) >> DIGITS;
        let error = above(&self.error, &fixed.norm) + coefficients + 2_u8;
        Row { values, error }
    }

    /// Bounds of the sum on the cell, where Σ_q |φ(y − q)| ≤ `total`: about the middle of the d_q, the sum of the φ(y − q) being 1.
    pub fn bounds(&self, total: &BigInt) -> Bounds {
        let (low, high) = (self.values.iter().min(), self.values.iter().max());
        let (Some(low), Some(high)) = (low, high) else { return Bounds::default() };
        let radius: BigInt = (above(&(high - low), total) >> 1_u8) + 1_u8;
        let radius = radius + above(&self.error, total) + 1_u8;
        let middle: BigInt = (high + low) >> 1_u8;
        [&middle - &radius, middle + radius + 1_u8]
    }

    /// Half of the difference of the greatest and the least d_q, and the absolute value of their middle, rounded up.
    pub fn spread(&self) -> [BigInt; 2] {
        let (low, high) = (self.values.iter().min(), self.values.iter().max());
        let (Some(low), Some(high)) = (low, high) else { return Bounds::default() };
        let radius: BigInt = (high - low) >> 1_u8;
        let middle: BigInt = (high + low) >> 1_u8;
        [radius + &self.error + 2_u8, middle.abs() + 2_u8]
    }

    /// Bounds of the sum at y = 0.
    pub fn at_start(&self, fixed: &Fixed, total: &BigInt) -> Bounds {
        let terms = self.values.iter().zip(&fixed.values);
        let value = terms.map(|(d, phi)| d * phi).sum::<BigInt>() >> DIGITS;
        let of_values = (self.greatest_size() * fixed.size) >> DIGITS;
        let error = above(&self.error, total) + of_values + 2_u8;
        [&value - &error, value + error]
    }

    /// Adds another sum.
    pub fn add(&mut self, other: &Row) {
        self.values.iter_mut().zip(&other.values).for_each(|(sum, d)| *sum += d);
        self.error += &other.error;
    }
}

/// A cell with the rows of some sums.
#[derive(Clone)]
pub struct Cell {
    pub level: u32,
    pub rows: Vec<Row>,
}

impl Cell {
    /// The parts of a cell.
    pub fn parts(&self, fixed: &Fixed, meter: &Meter) -> Result<Vec<Cell>, Stop> {
        // A product of numbers of 256 binary digits, and what belongs to it.
        let rows = self.rows.len() as u64;
        meter.spend(fixed.count.saturating_mul(rows).saturating_mul(2))?;
        let part = |digit| Cell {
            level: self.level.saturating_add(1),
            rows: self.rows.iter().map(|row| row.part(fixed, digit)).collect(),
        };
        Ok((0..fixed.terms.len()).map(part).collect())
    }
}
