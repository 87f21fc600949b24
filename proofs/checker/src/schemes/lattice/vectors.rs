//! Vectors of integers, and how they stand in tables.

#![warn(clippy::arithmetic_side_effects)]

use crate::text::{Stop, Toml};

/// A vector of two or three integers. The third of two is 0.
pub type Vector = [i64; 3];

/// one + factor·other.
pub fn plus(one: Vector, factor: i64, other: Vector) -> Result<Vector, Stop> {
    let mut sum = one;
    for (x, y) in sum.iter_mut().zip(other) {
        let next = y.checked_mul(factor).and_then(|y| x.checked_add(y));
        *x = next.ok_or(Stop::Capped("the places of the coefficients of a mask"))?;
    }
    Ok(sum)
}

/// The product of a matrix with these rows and a vector.
pub fn times(rows: &[Vector; 3], vector: Vector) -> Result<Vector, Stop> {
    let columns = [0, 1, 2].map(|j: usize| rows.map(|row| row[j]));
    let mut sum = [0; 3];
    for (factor, column) in vector.into_iter().zip(columns) {
        sum = plus(sum, factor, column)?;
    }
    Ok(sum)
}

/// The determinant of three vectors, whose entries are at most 2^20 in absolute value.
pub(super) fn determinant([a, b, c]: [Vector; 3]) -> i128 {
    let [a, b, c] = [a, b, c].map(|row| row.map(i128::from));
    let minor = |i: usize, j: usize| {
        let product = |x: i128, y: i128| x.saturating_mul(y);
        product(b[i], c[j]).saturating_sub(product(b[j], c[i]))
    };
    let terms = [a[0].saturating_mul(minor(1, 2)), a[1].saturating_mul(minor(2, 0))];
    let last = a[2].saturating_mul(minor(0, 1));
    terms.into_iter().fold(last, i128::saturating_add)
}

/// Checks that all entries are at most this in absolute value.
pub(super) fn within(vectors: &[Vector], most: u64) -> bool {
    vectors.iter().flatten().all(|x| x.unsigned_abs() <= most)
}

/// A vector of d integers. What is beyond 64 binary digits is beyond all limits, as the last integers of 64 digits are.
pub(super) fn vector(list: &[Toml], d: usize) -> Option<Vector> {
    let mut vector = [0; 3];
    if list.len() != d {
        return None;
    }
    for (place, entry) in vector.iter_mut().zip(list) {
        let text = entry.as_text()?;
        let digits = text.strip_prefix('-').unwrap_or(text);
        if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
            return None;
        }
        *place = match text.parse::<i64>() {
            Ok(number) => number,
            Err(_) if digits == text => i64::MAX,
            Err(_) => i64::MIN,
        };
    }
    Some(vector)
}

/// A list of vectors of d integers.
pub(super) fn vectors(list: &[Toml], d: usize) -> Option<Vec<Vector>> {
    list.iter().map(|entry| vector(entry.as_list(), d)).collect()
}
