//! Dilations: integer matrices M with eigenvalues beyond the unit circle, and the classes of Z^d/MZ^d.

#![warn(clippy::arithmetic_side_effects)]

use super::vectors::{Vector, determinant, plus, times, within};
use crate::text::Stop;
use std::collections::BTreeSet;

/// The greatest entry, and the greatest number of classes.
const MAX: u64 = 64;

/// A dilation of Z^d.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Dilation {
    /// d.
    pub d: usize,
    /// The rows of M, with the last row and column of the unit matrix for d = 2.
    rows: [Vector; 3],
    /// The rows of det M · M^{−1}.
    adjugate: [Vector; 3],
    /// det M.
    determinant: i64,
}

fn wrong<T>(what: &str) -> Result<T, Stop> {
    Err(Stop::Wrong(format!("`dilation`: {what}")))
}

impl Dilation {
    /// The dilation of d rows.
    pub fn new(rows: &[Vector]) -> Result<Dilation, Stop> {
        let d = rows.len();
        let full = match *rows {
            [a, b] => [a, b, [0, 0, 1]],
            [a, b, c] => [a, b, c],
            _ => return wrong("it has two or three rows"),
        };
        if !within(rows, MAX) {
            return wrong("its entries are integers from -64 to 64");
        }
        // The entries are at most 64, and so all these numbers are below 2^21.
        let small = |x: i128| i64::try_from(x).unwrap_or(i64::MAX);
        let (mut adjugate, mut minors) = ([[0; 3]; 3], 0_i128);
        for (i, row) in full.iter().enumerate() {
            for (j, _) in row.iter().enumerate() {
                // The row i is replaced by the unit vector j.
                let mut other = full;
                other[i] = [0; 3];
                other[i][j] = 1;
                let minor = determinant(other);
                adjugate[j][i] = small(minor);
                // The determinant of a 3×3 matrix without the row and the column of a number on its diagonal.
                minors = minors.saturating_add(if i == j { minor } else { 0 });
            }
        }
        let determinant = determinant(full);
        let trace = rows.iter().zip(0..).map(|(row, i): (&Vector, usize)| i128::from(row[i]));
        let trace = trace.fold(0, i128::saturating_add);
        // det(λ − M), from the constant coefficient on.
        let characteristic = match d {
            2 => vec![determinant, trace.saturating_neg(), 1],
            _ => vec![determinant.saturating_neg(), minors, trace.saturating_neg(), 1],
        };
        if !is_expanding(characteristic) {
            return wrong("an eigenvalue has no modulus above 1");
        }
        if !(2..=u128::from(MAX)).contains(&determinant.unsigned_abs()) {
            return wrong("its determinant has an absolute value from 2 to 64");
        }
        Ok(Dilation { d, rows: full, adjugate, determinant: small(determinant) })
    }

    /// m.
    pub fn arity(&self) -> u64 {
        self.determinant.unsigned_abs()
    }

    /// The rows of M, with the last row and column of the unit matrix for d = 2.
    pub fn rows(&self) -> &[Vector; 3] {
        &self.rows
    }

    /// The rows of det M · M^{−1}, and det M.
    pub fn adjugate(&self) -> (&[Vector; 3], i64) {
        (&self.adjugate, self.determinant)
    }

    /// Mξ.
    pub fn times(&self, vector: Vector) -> Result<Vector, Stop> {
        times(&self.rows, vector)
    }

    /// M^{−1}ξ, if that is a vector of integers.
    pub fn divided(&self, vector: Vector) -> Result<Option<Vector>, Stop> {
        let scaled = times(&self.adjugate, vector)?;
        let divides = scaled.iter().all(|x| x.checked_rem(self.determinant) == Some(0));
        Ok(divides.then(|| scaled.map(|x| x.checked_div(self.determinant).unwrap_or(0))))
    }

    /// What all vectors of a class, and no others, have in common: α − β is in MZ^d if and only if det M divides the entries
    /// of det M · M^{−1}(α − β).
    pub fn class(&self, vector: Vector) -> Result<Vector, Stop> {
        let scaled = times(&self.adjugate, vector)?;
        Ok(scaled.map(|x| x.checked_rem_euclid(self.determinant).unwrap_or(0)))
    }

    /// A vector of each class. Unit vectors lead from any class to all others.
    pub fn representatives(&self) -> Result<Vec<Vector>, Stop> {
        let (mut found, mut known) = (vec![[0; 3]], BTreeSet::from([self.class([0; 3])?]));
        let mut next = 0_usize;
        while let Some(at) = found.get(next).copied() {
            for unit in units(self.d) {
                let other = plus(at, 1, unit)?;
                if known.insert(self.class(other)?) {
                    found.push(other);
                }
            }
            next = next.saturating_add(1);
        }
        Ok(found)
    }
}

/// The unit vectors of Z^d.
pub(super) fn units(d: usize) -> Vec<Vector> {
    [[1, 0, 0], [0, 1, 0], [0, 0, 1]].into_iter().take(d).collect()
}

/// Whether all roots of a polynomial are beyond the unit circle (Schur and Cohn).
///
/// Let p* be p with its coefficients in reverse order: |p*| = |p| on the unit circle. If |p_n| ≥ |p_0|, the product of the roots is at
/// most 1. Otherwise p_0 p and r = p_0 p − p_n p* have equally many zeros inside, as |p_0 p| > |p_n p*| on the circle but at the
/// zeros of p, which are zeros of r too. The degree of r is less than n.
fn is_expanding(mut p: Vec<i128>) -> bool {
    while let ([low, .., high], length) = (&p[..], p.len()) {
        if high.unsigned_abs() >= low.unsigned_abs() {
            return false;
        }
        // The coefficients are below 2^16, in the next step below 2^34, and in the last one below 2^70.
        let terms = p.iter().zip(p.iter().rev());
        let next =
            terms.map(|(a, b)| low.saturating_mul(*a).saturating_sub(high.saturating_mul(*b)));
        p = next.take(length.saturating_sub(1)).collect();
    }
    true
}
