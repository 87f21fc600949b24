//! Eigenvalues and radii in floating-point numbers.

use super::masks::{Q, float, int, norm};
use num_traits::{One, Signed};

/// A number of either sign, as large as a few steps make it, beyond which the product has a real eigenvalue.
pub fn eigenvalue(matrices: &[Vec<Vec<Q>>], factors: &[usize]) -> Q {
    let size = matrices[0].len();
    let norm = factors.iter().fold(Q::one(), |most, _| most * norm(matrices));
    let float = |m: &Vec<Vec<Q>>| m.iter().map(|row| row.iter().map(float).collect()).collect();
    let floats: Vec<Vec<Vec<f64>>> = matrices.iter().map(float).collect();
    let product = factors[1..]
        .iter()
        .fold(floats[factors[0]].clone(), |p, factor| multiply(&p, &floats[*factor]));
    for step in (1..=32).rev() {
        for sign in [1, -1] {
            let q = &norm * int(sign * step) / int(32);
            let shifted = |i: usize, j: usize| {
                let own = if i == j { self::float(&q.abs()) } else { 0.0 };
                own - f64::from(i32::try_from(sign).unwrap_or(1)) * product[i][j]
            };
            let rows = (0..size).map(|i| (0..size).map(|j| shifted(i, j)).collect()).collect();
            if determinant(rows) < 1e-9 {
                return q;
            }
        }
    }
    Q::one()
}

fn determinant(mut rows: Vec<Vec<f64>>) -> f64 {
    let mut value = 1.0;
    for step in 0..rows.len() {
        let pivot =
            (step..rows.len()).max_by(|a, b| rows[*a][step].abs().total_cmp(&rows[*b][step].abs()));
        let pivot = pivot.unwrap_or(step);
        if pivot != step {
            rows.swap(pivot, step);
            value = -value;
        }
        let top = rows[step].clone();
        value *= top[step];
        if top[step] == 0.0 {
            return 0.0;
        }
        for row in &mut rows[step + 1..] {
            let factor = row[step] / top[step];
            row.iter_mut().zip(&top).for_each(|(x, t)| *x -= factor * t);
        }
    }
    value
}

/// The product of two matrices.
pub fn multiply(a: &[Vec<f64>], b: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let entry = |row: &Vec<f64>, j: usize| row.iter().zip(b).map(|(x, other)| x * other[j]).sum();
    a.iter().map(|row| (0..b.len()).map(|j| entry(row, j)).collect()).collect()
}

/// A bound from below of the joint spectral radius: |tr P^k/w|^{1/kl} for products of up to so many factors.
pub fn radius_from_below(matrices: &[Vec<Vec<f64>>], longest: u32) -> f64 {
    let size = matrices[0].len();
    let mut best: f64 = 0.0;
    let mut products = matrices.to_vec();
    for l in 1..=longest {
        for product in &products {
            let mut power = product.clone();
            for k in 1..=12 {
                let trace: f64 = (0..size).map(|i| power[i][i]).sum();
                // Powers of large numbers overflow, and say nothing.
                if trace.is_finite() {
                    best = best.max((trace.abs() / size as f64).powf(1.0 / f64::from(k * l)));
                }
                power = multiply(&power, product);
            }
        }
        let longer =
            |p: &Vec<Vec<f64>>| matrices.iter().map(|m| multiply(p, m)).collect::<Vec<_>>();
        products = if l < longest { products.iter().flat_map(longer).collect() } else { products };
    }
    best
}
