//! Linear equations, and unit matrices.

use super::decimal::Q;
use num_traits::Zero;

/// A multiple of the unit matrix, by its entries off and on the diagonal.
pub fn unit<T: Clone>(size: usize, [off, on]: [T; 2]) -> Vec<Vec<T>> {
    let entry = |i, j| if i == j { on.clone() } else { off.clone() };
    (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect()
}

/// The unique solution of equations, or `None`. The right side of each equation comes last.
pub fn solve(mut rows: Vec<Vec<Q>>) -> Option<Vec<Q>> {
    let d = rows.len();
    for j in 0..d {
        let pivot = (j..d).find(|&i| !rows[i][j].is_zero())?;
        rows.swap(j, pivot);
        let leading = rows[j][j].clone();
        rows[j].iter_mut().for_each(|value| *value /= &leading);
        let pivot = rows[j].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != j) {
            let factor = row[j].clone();
            for (value, p) in row.iter_mut().zip(&pivot) {
                *value -= &factor * p;
            }
        }
    }
    Some(rows.into_iter().map(|mut row| row.swap_remove(d)).collect())
}
