//! Gaussian elimination over any field of real numbers.

use crate::exact::{Rational, Real};

/// The matrix in reduced echelon form, without rows of zeros, and the column of each pivot.
pub(super) fn reduced<F: Real + PartialEq>(mut rows: Vec<Vec<F>>) -> (Vec<Vec<F>>, Vec<usize>) {
    let columns = rows.first().map_or(0, Vec::len);
    let mut pivots = Vec::new();
    for column in 0..columns {
        let done = pivots.len();
        let Some(pivot) = (done..rows.len()).find(|&i| rows[i][column] != F::zero()) else {
            continue;
        };
        rows.swap(done, pivot);
        let scale = rows[done][column].clone();
        rows[done].iter_mut().for_each(|x| *x = x.over(&scale));
        let top = rows[done].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            let factor = row[column].clone();
            if i != done && factor != F::zero() {
                row.iter_mut().zip(&top).for_each(|(x, t)| x.lessen(&factor.times(t)));
            }
        }
        pivots.push(column);
    }
    rows.truncate(pivots.len());
    (rows, pivots)
}

/// A basis of the rows v with vM = 0 for a square matrix M.
pub(crate) fn null_rows<F: Real + PartialEq>(matrix: &[Vec<F>]) -> Vec<Vec<F>> {
    let size = matrix.len();
    let transposed = (0..size).map(|j| matrix.iter().map(|row| row[j].clone()).collect()).collect();
    let (rows, pivots) = reduced(transposed);
    let free = (0..size).filter(|column| !pivots.contains(column));
    let solution = |free: usize| {
        let mut solution = vec![F::zero(); size];
        solution[free] = F::from_rational(&Rational::one());
        for (row, &pivot) in rows.iter().zip(&pivots) {
            solution[pivot] = F::zero().minus(&row[free]);
        }
        solution
    };
    free.map(solution).collect()
}

/// Coefficients c with Σ c_j v_j = x, if the rows v_j are independent and there are such.
pub(super) fn coefficients<F: Real + PartialEq>(rows: &[&Vec<F>], x: &[F]) -> Option<Vec<F>> {
    let equation = |k: usize| {
        let left = rows.iter().map(|row| row[k].clone());
        left.chain([x[k].clone()]).collect()
    };
    let (reduced, pivots) = reduced((0..x.len()).map(equation).collect());
    let independent = pivots.iter().copied().eq(0..rows.len());
    independent.then(|| reduced.into_iter().map(|mut row| row.pop().expect("a column")).collect())
}
