//! Inverses of matrices in f64, without proven errors.

/// The inverse of a square matrix, by elimination with the largest pivot of a column; `None` where a pivot is below
/// `least`.
#[must_use]
pub fn inverse(mut rows: Vec<Vec<f64>>, least: f64) -> Option<Vec<Vec<f64>>> {
    let size = rows.len();
    for (i, row) in rows.iter_mut().enumerate() {
        row.extend((0..size).map(|j| if i == j { 1.0 } else { 0.0 }));
    }
    for step in 0..size {
        let magnitude = |row: usize| rows[row][step].abs();
        let pivot = (step..size).max_by(|&a, &b| magnitude(a).total_cmp(&magnitude(b)))?;
        if magnitude(pivot) < least {
            return None;
        }
        rows.swap(step, pivot);
        let scale = rows[step][step];
        rows[step].iter_mut().for_each(|x| *x /= scale);
        let top = rows[step].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            let factor = row[step];
            if i != step && factor != 0.0 {
                row.iter_mut().zip(&top).for_each(|(x, t)| *x -= factor * t);
            }
        }
    }
    Some(rows.into_iter().map(|row| row[size..].to_vec()).collect())
}

/// The rows of an inverse after row k of the matrix has become its combination of the old rows with these coefficients: a
/// change of rank 1.
pub fn replace<'a>(inverse: impl Iterator<Item = &'a mut [f64]>, coefficients: &[f64], k: usize) {
    let pivot = coefficients[k];
    for row in inverse {
        let factor = row[k] / pivot;
        row.iter_mut().zip(coefficients).for_each(|(x, d)| *x -= factor * d);
        row[k] += factor;
    }
}
