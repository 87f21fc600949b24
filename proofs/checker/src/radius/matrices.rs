//! Matrices of real numbers.

use super::number::Number;
use crate::decimal::{Q, int};
use crate::meter::Meter;
use crate::reject::Stop;

/// A square matrix, row by row.
pub type Matrix<N> = Vec<Vec<N>>;

/// The unit matrix.
pub fn unit<N: Number>(size: usize) -> Matrix<N> {
    let row = |i| (0..size).map(|j| if i == j { N::whole(1) } else { N::whole(0) }).collect();
    (0..size).map(row).collect()
}

/// The sum of the rows of a matrix, each scaled by the entry of a row.
fn times<N: Number, M: Number>(row: &[M], by: impl Fn(&N, &M) -> N, matrix: &Matrix<N>) -> Vec<N> {
    let mut sum = vec![N::whole(0); matrix.len()];
    for (x, entries) in row.iter().zip(matrix).filter(|(x, _)| x.sign() != 0) {
        for (sum, entry) in sum.iter_mut().zip(entries) {
            *sum = sum.plus(&by(entry, x));
        }
    }
    sum
}

/// A row of fractions times a matrix.
pub fn scaled_times<N: Number>(row: &[Q], matrix: &Matrix<N>) -> Vec<N> {
    times(row, N::scaled, matrix)
}

/// The steps of an operation with each entry of a matrix.
fn cost<N: Number>(matrix: &Matrix<N>) -> u64 {
    matrix.iter().flatten().map(Number::cost).sum()
}

/// The product of two matrices.
pub fn multiplied<N: Number>(
    a: &Matrix<N>,
    b: &Matrix<N>,
    meter: &Meter,
) -> Result<Matrix<N>, Stop> {
    meter.spend(a.len() as u64 * (cost(a) + cost(b)))?;
    Ok(a.iter().map(|row| times(row, N::times, b)).collect())
}

/// The determinant, by elimination.
pub fn determinant<N: Number>(mut rows: Matrix<N>, meter: &Meter) -> Result<N, Stop> {
    let (size, mut value) = (rows.len(), N::whole(1));
    for step in 0..size {
        let Some(pivot) = (step..size).find(|&i| rows[i][step].sign() != 0) else {
            return Ok(N::whole(0));
        };
        meter.spend(cost(&rows))?;
        if pivot != step {
            rows.swap(step, pivot);
            value = value.scaled(&int(-1));
        }
        value = value.times(&rows[step][step]);
        let top = rows[step].clone();
        let inverse = top[step].inverse();
        for row in &mut rows[step + 1..] {
            let factor = row[step].times(&inverse);
            if factor.sign() != 0 {
                meter.spend(top.iter().map(|t| t.cost().max(factor.cost())).sum())?;
                for (x, t) in row.iter_mut().zip(&top).skip(step) {
                    *x = x.minus(&factor.times(t));
                }
            }
        }
    }
    Ok(value)
}

/// The matrix on symmetric tensors: its eigenvalues are the products λ_i λ_j, i ≤ j.
///
/// x_a x_b becomes Σ m_{a,p} m_{b,q} x_p x_q.
pub fn symmetric_square<N: Number>(matrix: &Matrix<N>) -> Matrix<N> {
    let size = matrix.len();
    let half = Q::new(1.into(), 2.into());
    let pairs: Vec<(usize, usize)> =
        (0..size).flat_map(|a| (a..size).map(move |b| (a, b))).collect();
    let entry = |(a, b): (usize, usize), (p, q): (usize, usize)| {
        let one = matrix[a][p].times(&matrix[b][q]);
        let both = one.plus(&matrix[a][q].times(&matrix[b][p]));
        if p == q { both.scaled(&half) } else { both }
    };
    pairs.iter().map(|&row| pairs.iter().map(|&column| entry(row, column)).collect()).collect()
}
