//! Matrices of fractions.

use crate::decimal::{Q, int};
use num_traits::{One, Zero};

/// A square matrix, row by row.
pub type Matrix = Vec<Vec<Q>>;

/// The unit matrix.
pub fn unit(size: usize) -> Matrix {
    let row = |i| (0..size).map(|j| if i == j { Q::one() } else { Q::zero() }).collect();
    (0..size).map(row).collect()
}

/// A row times a matrix.
pub fn times(row: &[Q], matrix: &Matrix) -> Vec<Q> {
    let mut sum = vec![Q::zero(); matrix.len()];
    for (x, entries) in row.iter().zip(matrix).filter(|(x, _)| !x.is_zero()) {
        for (sum, entry) in sum.iter_mut().zip(entries) {
            *sum += x * entry;
        }
    }
    sum
}

/// The product of two matrices.
pub fn multiplied(a: &Matrix, b: &Matrix) -> Matrix {
    a.iter().map(|row| times(row, b)).collect()
}

/// The determinant, by elimination.
pub fn determinant(mut rows: Matrix) -> Q {
    let (size, mut value) = (rows.len(), Q::one());
    for step in 0..size {
        let Some(pivot) = (step..size).find(|&i| !rows[i][step].is_zero()) else {
            return Q::zero();
        };
        if pivot != step {
            rows.swap(step, pivot);
            value = -value;
        }
        value *= &rows[step][step];
        let top = rows[step].clone();
        for row in &mut rows[step + 1..] {
            let factor = &row[step] / &top[step];
            if !factor.is_zero() {
                for (x, t) in row.iter_mut().zip(&top).skip(step) {
                    *x -= &factor * t;
                }
            }
        }
    }
    value
}

/// The matrix on symmetric tensors: its eigenvalues are the products λ_i λ_j, i ≤ j.
///
/// x_a x_b becomes Σ m_{a,p} m_{b,q} x_p x_q.
pub fn symmetric_square(matrix: &Matrix) -> Matrix {
    let size = matrix.len();
    let pairs: Vec<(usize, usize)> =
        (0..size).flat_map(|a| (a..size).map(move |b| (a, b))).collect();
    let entry = |(a, b): (usize, usize), (p, q): (usize, usize)| {
        let both = &matrix[a][p] * &matrix[b][q] + &matrix[a][q] * &matrix[b][p];
        if p == q { both / int(2) } else { both }
    };
    pairs.iter().map(|&row| pairs.iter().map(|&column| entry(row, column)).collect()).collect()
}
