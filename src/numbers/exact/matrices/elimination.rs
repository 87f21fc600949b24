//! Gaussian elimination over any field of real numbers.

use crate::exact::{Rational, Real, Scalar};

/// The reduced echelon form of a matrix, without rows of zeros, and the column of each pivot.
///
/// ```
/// use subcert::exact::{Rational, echelon};
///
/// let row = |entries: [i64; 3]| entries.map(Rational::from).to_vec();
/// let (rows, pivots) = echelon(vec![row([2, 4, 6]), row([1, 2, 4])]);
/// assert_eq!((rows, pivots), (vec![row([1, 2, 0]), row([0, 0, 1])], vec![0, 2]));
/// ```
#[must_use]
pub fn echelon<F: Real + PartialEq>(mut rows: Vec<Vec<F>>) -> (Vec<Vec<F>>, Vec<usize>) {
    let zero = F::zero();
    let columns = rows.first().map_or(0, Vec::len);
    let mut pivots = Vec::new();
    for column in 0..columns {
        let done = pivots.len();
        let Some(pivot) = (done..rows.len()).find(|&i| rows[i][column] != zero) else { continue };
        rows.swap(done, pivot);
        let inverse = F::from_rational(&Rational::one()).over(&rows[done][column]);
        rows[done].iter_mut().skip(column).for_each(|x| *x = x.times(&inverse));
        let top = rows[done].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            let factor = row[column].clone();
            if i != done && factor != zero {
                let entries = row.iter_mut().zip(&top).skip(column);
                entries.for_each(|(x, t)| x.lessen(&factor.times(t)));
            }
        }
        pivots.push(column);
    }
    rows.truncate(pivots.len());
    (rows, pivots)
}

/// The only solution x of Σ_j m_{i,j} x_j = y_i, where row i is m_{i,0}, …, m_{i,n−1}, y_i; `None` where there is
/// none or more than one.
///
/// # Panics
/// When a row is empty.
#[must_use]
pub fn only_solution<F: Real + PartialEq>(rows: Vec<Vec<F>>) -> Option<Vec<F>> {
    let unknowns = rows.first().map_or(0, |row| row.len() - 1);
    let (rows, pivots) = echelon(rows);
    let right = |mut row: Vec<F>| row.pop().expect("a right side");
    pivots.into_iter().eq(0..unknowns).then(|| rows.into_iter().map(right).collect())
}

/// A basis of the rows v with vM = 0.
#[must_use]
pub fn null_rows<F: Real + PartialEq>(matrix: &[Vec<F>]) -> Vec<Vec<F>> {
    let size = matrix.len();
    let columns = matrix.first().map_or(0, Vec::len);
    let transposed =
        (0..columns).map(|j| matrix.iter().map(|row| row[j].clone()).collect()).collect();
    let (rows, pivots) = echelon(transposed);
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

/// xM.
#[must_use]
pub fn row_times<F: Scalar + PartialEq>(x: &[F], matrix: &[Vec<F>]) -> Vec<F> {
    let zero = F::zero();
    let mut sum = vec![zero.clone(); matrix.first().map_or(0, Vec::len)];
    for (x, row) in x.iter().zip(matrix).filter(|(x, _)| **x != zero) {
        for (sum, entry) in sum.iter_mut().zip(row).filter(|(_, entry)| **entry != zero) {
            sum.accumulate(&x.times(entry));
        }
    }
    sum
}
