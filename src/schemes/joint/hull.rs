//! Invariant hulls with rational rows: the proof of an upper bound.

use super::convert::at_most;
use super::entry::Entry;
use super::matrix_set::MatrixSet;
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
    /// The norm ‖·‖_∞ as a hull: of the unit rows alone, with the largest row sum as u, or a rational number
    /// next to it.
    #[must_use]
    pub fn norm<F: Entry>(set: &MatrixSet<F>) -> Hull {
        let sums = set.matrices().iter().flatten().map(F::sum_of_magnitudes);
        let bound = at_most(&F::maximum(sums));
        let images = vec![vec![Vec::new(); set.matrices().len()]; set.size()];
        Hull { bound, unit: Rational::one(), rows: Vec::new(), images }
    }

    /// Whether the bound is below 1.
    pub(super) fn contracts(&self) -> bool {
        self.bound < Rational::one()
    }

    /// That of the matrices times a positive number.
    pub(super) fn times(self, factor: &Rational) -> Hull {
        let scaled = |terms: Vec<(usize, Rational)>| {
            terms.into_iter().map(|(j, c)| (j, c * factor)).collect()
        };
        let images = self.images.into_iter();
        let images = images.map(|row| row.into_iter().map(scaled).collect()).collect();
        Hull { bound: self.bound * factor, images, ..self }
    }

    /// Whether this proves that the radius of the set is at most u.
    #[must_use]
    pub fn proves<F: Entry>(&self, set: &MatrixSet<F>) -> bool {
        let bound = F::from_rational(&self.bound);
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
                        && self.cost(&row, matrix, combination) <= bound
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
    pub(super) fn cost<F: Entry>(
        &self,
        row: &[Rational],
        matrix: &[Vec<F>],
        combination: &[(usize, Rational)],
    ) -> F {
        let zero = F::zero();
        let mut rest = vec![zero.clone(); row.len()];
        for (x, entries) in row.iter().zip(matrix).filter(|(x, _)| !x.is_zero()) {
            let x = F::from_rational(x);
            for (sum, entry) in rest.iter_mut().zip(entries).filter(|(_, entry)| **entry != zero) {
                sum.accumulate(&x.times(entry));
            }
        }
        for (j, c) in combination {
            match j.checked_sub(row.len()) {
                Some(j) => {
                    for (x, v) in rest.iter_mut().zip(&self.rows[j]) {
                        x.lessen(&F::from_rational(&(c * v)));
                    }
                }
                None => rest[*j].lessen(&F::from_rational(&(c * &self.unit))),
            }
        }
        let coefficients: Rational = combination.iter().map(|(_, c)| c.abs()).sum();
        let remainder = F::sum_of_magnitudes(&rest).over(&F::from_rational(&self.unit));
        remainder.plus(&F::from_rational(&coefficients))
    }
}
