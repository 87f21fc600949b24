//! Characteristic polynomials of matrices over any ring that contains the rational numbers.

#![warn(clippy::arithmetic_side_effects)]

use crate::text::Stop;

/// Arithmetic of a ring.
pub trait Ring<T> {
    /// An integer.
    fn integer(&self, value: i64) -> T;

    /// Adds a term to a sum.
    fn add(&self, sum: &mut T, term: &T) -> Result<(), Stop>;

    /// Adds a product to a sum.
    fn add_product(&self, sum: &mut T, left: &T, right: &T) -> Result<(), Stop>;

    /// −x/k.
    fn share(&self, x: &T, k: usize) -> Result<T, Stop>;
}

/// The coefficients of det(t − M), from the constant one on (Faddeev and LeVerrier).
pub fn characteristic<T: Clone>(ring: &impl Ring<T>, matrix: &[Vec<T>]) -> Result<Vec<T>, Stop> {
    let size = matrix.len();
    let zero = || vec![vec![ring.integer(0); size]; size];
    let (mut coefficients, mut power) = (vec![ring.integer(1)], zero());
    for k in 1..=size {
        // N ← M(N + c), c ← −tr(N)/k.
        for (i, row) in power.iter_mut().enumerate() {
            if let (Some(entry), Some(c)) = (row.get_mut(i), coefficients.last()) {
                ring.add(entry, c)?;
            }
        }
        let mut next = zero();
        for (row, sums) in matrix.iter().zip(&mut next) {
            for (entry, other) in row.iter().zip(&power) {
                for (sum, x) in sums.iter_mut().zip(other) {
                    ring.add_product(sum, entry, x)?;
                }
            }
        }
        let mut trace = ring.integer(0);
        for (i, row) in next.iter().enumerate() {
            if let Some(entry) = row.get(i) {
                ring.add(&mut trace, entry)?;
            }
        }
        coefficients.push(ring.share(&trace, k)?);
        power = next;
    }
    coefficients.reverse();
    Ok(coefficients)
}
