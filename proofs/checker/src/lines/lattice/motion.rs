//! Motions x ↦ Gx + t with integers.

#![warn(clippy::arithmetic_side_effects)]

use crate::numbers::Q;
use crate::schemes::{Dilation, Vector};
use crate::text::{Block, Checked, Reason, Stop, require};

/// The most parts.
const MAX_PARTS: usize = 64;

/// The greatest absolute value of an integer of a part.
const MAX_ENTRY: u64 = 1 << 20;

/// A point of R^d. The third coordinate of two is 0.
pub type Point = [Q; 3];

/// The rows of the unit matrix.
pub const UNIT: [Vector; 3] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

/// A motion.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Motion {
    /// The rows of G; for d = 2 with the last row and column of the unit matrix.
    pub turn: [Vector; 3],
    /// t.
    pub by: Vector,
}

impl Motion {
    /// The point to which a point is moved.
    pub fn at(&self, point: &Point) -> Point {
        let mut moved = product(&self.turn, point);
        for (x, by) in moved.iter_mut().zip(self.by) {
            *x += Q::from_integer(by.into());
        }
        moved
    }
}

/// The product of a matrix and a point.
fn product(rows: &[Vector; 3], point: &Point) -> Point {
    rows.map(|row| row.into_iter().zip(point).map(|(c, x)| x * Q::from_integer(c.into())).sum())
}

/// M^{−1}x.
pub fn divided(dilation: &Dilation, point: &Point) -> Point {
    let (adjugate, determinant) = dilation.adjugate();
    product(adjugate, point).map(|x| x / Q::from_integer(determinant.into()))
}

/// An integer in decimal digits.
fn integer(word: &str) -> Checked<i64> {
    let digits = word.strip_prefix('-').unwrap_or(word);
    let proper = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
    require(proper, Reason::Malformed("the integers of a part"))?;
    let number = word.parse().ok().filter(|x: &i64| x.unsigned_abs() <= MAX_ENTRY);
    Ok(number.ok_or(Stop::Capped("the integers of a part"))?)
}

/// The motions of the lines `part`.
pub fn parts(block: &mut Block<'_>, d: usize) -> Checked<Vec<Motion>> {
    let mut parts = Vec::new();
    while let Some(said) = block.maybe("part") {
        require(parts.len() < MAX_PARTS, Reason::Lattice("there are as many parts as classes"))?;
        let entries = said.split_whitespace().map(integer).collect::<Checked<Vec<i64>>>()?;
        let rows: Vec<&[i64]> = entries.chunks(d).collect();
        let complete = rows.len() == d.saturating_add(1) && rows.iter().all(|row| row.len() == d);
        require(complete, Reason::Malformed("d rows of a matrix, and a vector"))?;
        let (mut turn, mut by) = (UNIT, [0; 3]);
        for (to, row) in turn.iter_mut().take(d).chain([&mut by]).zip(rows) {
            *to = [0; 3];
            to.iter_mut().zip(row).for_each(|(to, x)| *to = *x);
        }
        parts.push(Motion { turn, by });
    }
    Ok(parts)
}
