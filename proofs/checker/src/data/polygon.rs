//! Control polygons.

#![warn(clippy::arithmetic_side_effects)]

use crate::numbers::{Q, capped, read_rational};
use crate::text::{Checked, Reason};
use num_bigint::BigInt;
use num_traits::Signed;

/// The greatest index that a certificate names.
const MAX_INDEX: i64 = 1_000_000;

/// The points x_i, i = first, first + 1, …, which are constant beyond both ends.
#[derive(Clone)]
pub struct Polygon {
    /// The index of the first point.
    pub first: i64,
    /// The points.
    pub points: Vec<BigInt>,
}

impl Polygon {
    /// Reads `FIRST INTEGER…`.
    pub fn read(said: &str) -> Checked<Polygon> {
        let numbers = integers(said).unwrap_or_default();
        match &numbers[..] {
            [first, points @ ..] if !points.is_empty() => {
                let first = index(first).ok_or(Reason::Malformed("an index"))?;
                Ok(Polygon { first, points: points.to_vec() })
            }
            _ => Err(Reason::Malformed("polygon FIRST INTEGER…").into()),
        }
    }

    /// x_i.
    pub fn at(&self, i: i64) -> &BigInt {
        &self.points[place(i, self.first, self.points.len())]
    }

    /// The largest difference of neighbouring points.
    pub fn spread(&self) -> BigInt {
        spread(self.points.windows(2).map(|pair| [&pair[0], &pair[1]]))
    }
}

/// The position of an index, or of the nearest one, in a list that begins with the index `first`.
pub fn place(i: i64, first: i64, count: usize) -> usize {
    usize::try_from(i.saturating_sub(first)).unwrap_or(0).min(count.saturating_sub(1))
}

/// The largest difference of the pairs.
pub fn spread<'x>(pairs: impl Iterator<Item = [&'x BigInt; 2]>) -> BigInt {
    pairs.map(|[a, b]| (b - a).abs()).max().unwrap_or_default()
}

/// Reads integers.
pub fn integers(text: &str) -> Option<Vec<BigInt>> {
    let integer = |word| read_rational(word).filter(Q::is_integer).map(|value| value.to_integer());
    text.split_whitespace().map(integer).collect()
}

/// An index. It has a cap.
pub fn index(value: &BigInt) -> Option<i64> {
    capped(value, MAX_INDEX)
}
