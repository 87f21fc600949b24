//! Invariant hulls with rational rows: the proof of an upper bound.

use super::matrix_set::{MatrixSet, row_times};
use crate::exact::Rational;

/// Rows v_1, …, v_m, of which the first d are τ times the unit rows, and for each row and each matrix
/// coefficients c with
///
/// Σ_j |c_j| + Σ_k |r_k|/τ ≤ u, r = vM − Σ_j c_j v_j.
///
/// Then vM/u is in the absolutely convex hull of the rows, since r = Σ_k (r_k/τ)·τe_k; and the radius is
/// at most u. The remainder r makes it unnecessary that the coefficients are exact.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hull {
    /// u.
    pub bound: Rational,
    /// τ.
    pub unit: Rational,
    /// The rows beyond the first d.
    pub rows: Vec<Vec<Rational>>,
    /// For each row, the first d as well, and each matrix, the rows with their coefficients.
    pub images: Vec<Vec<Vec<(usize, Rational)>>>,
}

impl Hull {
    /// The norm ‖·‖_∞ as a hull: of the unit rows alone, with the largest row sum as u.
    #[must_use]
    pub fn norm(set: &MatrixSet) -> Hull {
        let sum = |row: &Vec<Rational>| row.iter().map(Rational::abs).sum::<Rational>();
        let sums = set.matrices().iter().flatten().map(sum);
        let bound = sums.max().unwrap_or_else(Rational::zero);
        let images = vec![vec![Vec::new(); set.matrices().len()]; set.size()];
        Hull { bound, unit: Rational::one(), rows: Vec::new(), images }
    }

    /// Whether this proves that the radius of the set is at most u.
    #[must_use]
    pub fn proves(&self, set: &MatrixSet) -> bool {
        let count = set.size() + self.rows.len();
        let shape = self.unit.sign() > 0
            && self.bound.sign() > 0
            && self.images.len() == count
            && self.rows.iter().all(|row| row.len() == set.size());
        let inside = |(i, images): (usize, &Vec<Vec<(usize, Rational)>>)| {
            let row = self.row(i, set.size());
            images.len() == set.matrices().len()
                && images.iter().zip(set.matrices()).all(|(combination, matrix)| {
                    combination.iter().all(|(j, _)| *j < count)
                        && self.cost(&row, matrix, combination) <= self.bound
                })
        };
        shape && self.images.iter().enumerate().all(inside)
    }

    /// v_i, counted from 0.
    fn row(&self, i: usize, size: usize) -> Vec<Rational> {
        if let Some(i) = i.checked_sub(size) {
            return self.rows[i].clone();
        }
        let entry = |k| if k == i { self.unit.clone() } else { Rational::zero() };
        (0..size).map(entry).collect()
    }

    /// Σ|c_j| + Σ|r_k|/τ.
    pub(super) fn cost(
        &self,
        row: &[Rational],
        matrix: &[Vec<Rational>],
        combination: &[(usize, Rational)],
    ) -> Rational {
        let mut rest = row_times(row, matrix);
        for (j, c) in combination {
            match j.checked_sub(row.len()) {
                Some(j) => {
                    for (x, v) in rest.iter_mut().zip(&self.rows[j]) {
                        *x -= &(c * v);
                    }
                }
                None => rest[*j] -= &(c * &self.unit),
            }
        }
        let coefficients: Rational = combination.iter().map(|(_, c)| c.abs()).sum();
        let remainder: Rational = rest.iter().map(Rational::abs).sum();
        coefficients + remainder / &self.unit
    }
}
