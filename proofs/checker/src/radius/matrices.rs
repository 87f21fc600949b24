//! Matrices of real numbers.

use super::element::Element;
use crate::numbers::{Meter, Q, int};
use crate::text::Stop;

/// A square matrix, row by row.
pub type Matrix = Vec<Vec<Element>>;

/// A row times a matrix.
pub fn times(row: &[Element], matrix: &Matrix) -> Vec<Element> {
    let mut sum = vec![Element::whole(0); matrix.len()];
    for (x, entries) in row.iter().zip(matrix).filter(|(x, _)| x.sign() != 0) {
        for (sum, entry) in sum.iter_mut().zip(entries) {
            *sum = sum.plus(&x.times(entry));
        }
    }
    sum
}

/// The steps of an operation with each entry of a matrix.
fn cost(matrix: &Matrix) -> u64 {
    matrix.iter().flatten().map(Element::cost).sum()
}

/// The product of two matrices.
pub fn multiplied(a: &Matrix, b: &Matrix, meter: &Meter) -> Result<Matrix, Stop> {
    meter.spend(a.len() as u64 * (cost(a) + cost(b)))?;
    Ok(a.iter().map(|row| times(row, b)).collect())
}

/// The determinant, by elimination.
pub fn determinant(mut rows: Matrix, meter: &Meter) -> Result<Element, Stop> {
    let (size, mut value) = (rows.len(), Element::whole(1));
    for step in 0..size {
        let Some(pivot) = (step..size).find(|&i| rows[i][step].sign() != 0) else {
            return Ok(Element::whole(0));
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
pub fn symmetric_square(matrix: &Matrix) -> Matrix {
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
