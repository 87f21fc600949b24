//! Bases in which matrices are about as large as their radius.

use super::convert::floats;
use super::matrix_set::{Matrix, MatrixSet};
use crate::exact::{Rational, row_times};
use crate::float::extremal::Rows;

/// The longest products that are looked at.
const LENGTH: usize = 6;

/// The most products of one length.
const MOST: usize = 1 << 10;

/// The most exchanges of two rows.
const MAX_ROUNDS: usize = 10_000;

/// How much shorter the next row must be for an exchange.
const SHORTER: f64 = 0.75;

/// A basis of a set of matrices, and its inverse: of integers, times powers of 2.
///
/// In ‖v‖² = Σ_w |vM_w|²/r^{2l}, over words w of up to 6 letters, with the largest Σ_w|M_w|² of one length as the scale r^{2l}, rows are made short
/// by the algorithm of Lenstra, Lenstra and Lovász, and then scaled. Rounding has no effect but on how good the basis is.
pub(super) fn balance(set: &MatrixSet) -> Option<(Matrix<Rational>, Matrix<Rational>)> {
    let size = set.size();
    let matrices = floats(set);
    let gram = gram(&matrices, size)?;
    let (mut rows, mut inverse) = (unit(size), unit(size));
    reduce(&gram, &mut rows, &mut inverse)?;
    let whole = |x: i64| Rational::from(x);
    let mut basis: Matrix<Rational> =
        rows.iter().map(|row| row.iter().map(|x| whole(*x)).collect()).collect();
    let mut back: Matrix<Rational> =
        inverse.iter().map(|row| row.iter().map(|x| whole(*x)).collect()).collect();
    for (i, row) in rows.iter().enumerate() {
        let length = product(&gram, row, row).sqrt();
        if !length.is_normal() {
            return None;
        }
        // The row times 2^{−e} has a length from 1 to 2.
        let exponent = (0..64).find(|e| length < f64::powi(2.0, e - 31))? - 32;
        let scale = Rational::from(2).pow(exponent);
        basis[i].iter_mut().for_each(|x| *x = &*x / &scale);
        for row in &mut back {
            row[i] = &row[i] * &scale;
        }
    }
    Some((basis, back))
}

/// BMB^{−1} for each matrix.
pub(super) fn changed(
    set: &MatrixSet,
    basis: &Matrix<Rational>,
    back: &Matrix<Rational>,
) -> MatrixSet {
    set.part(&|matrix| basis.iter().map(|row| row_times(&row_times(row, matrix), back)).collect())
}

type Whole = Vec<Vec<i64>>;

fn unit(size: usize) -> Whole {
    (0..size).map(|i| (0..size).map(|j| i64::from(i == j)).collect()).collect()
}

/// Σ_w M_w M_wᵀ, each length scaled so that its largest entry is 1; `None` where there is none.
fn gram(matrices: &[Rows], size: usize) -> Option<Rows> {
    let mut sum: Rows =
        (0..size).map(|i| (0..size).map(|j| f64::from(u8::from(i == j))).collect()).collect();
    let mut level: Vec<Rows> = vec![sum.clone()];
    for _ in 0..LENGTH {
        if level.len() * matrices.len() > MOST {
            break;
        }
        level = level
            .iter()
            .flat_map(|left| {
                matrices.iter().map(move |right| {
                    left.iter().map(|row| crate::float::extremal::row_times(row, right)).collect()
                })
            })
            .collect();
        let mut own: Rows = vec![vec![0.0; size]; size];
        for product in &level {
            for (i, a) in product.iter().enumerate() {
                for (j, b) in product.iter().enumerate() {
                    own[i][j] += a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
                }
            }
        }
        let most = own.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
        if !most.is_normal() {
            return None;
        }
        sum.iter_mut().flatten().zip(own.iter().flatten()).for_each(|(x, y)| *x += y / most);
        let scale = most.sqrt();
        level.iter_mut().flatten().flatten().for_each(|x| *x /= scale);
    }
    Some(sum)
}

#[expect(clippy::cast_precision_loss, reason = "rounding has no effect on what is proved")]
fn product(gram: &Rows, a: &[i64], b: &[i64]) -> f64 {
    let of_row = |row: &Vec<f64>| row.iter().zip(b).map(|(g, y)| g * *y as f64).sum::<f64>();
    a.iter().zip(gram).filter(|(x, _)| **x != 0).map(|(x, row)| *x as f64 * of_row(row)).sum()
}

/// Rows U that are short in a norm, with their inverse.
#[expect(clippy::cast_possible_truncation, reason = "checked to be small")]
fn reduce(gram: &Rows, rows: &mut Whole, inverse: &mut Whole) -> Option<()> {
    let size = rows.len();
    let mut k = 1;
    for _ in 0..MAX_ROUNDS {
        if k >= size {
            return Some(());
        }
        let (mut factors, mut squares) = orthogonalised(gram, rows, k)?;
        for j in (0..k).rev() {
            let q = factors[j].round();
            if q != 0.0 {
                if q.abs() > 1e12 {
                    return None;
                }
                let q = q as i64;
                let before = rows[j].clone();
                for (x, y) in rows[k].iter_mut().zip(before) {
                    *x = x.checked_sub(q.checked_mul(y)?)?;
                }
                for row in inverse.iter_mut() {
                    row[j] = row[j].checked_add(q.checked_mul(row[k])?)?;
                }
                (factors, squares) = orthogonalised(gram, rows, k)?;
            }
        }
        if squares[k] < (SHORTER - factors[k - 1] * factors[k - 1]) * squares[k - 1] {
            rows.swap(k, k - 1);
            for row in inverse.iter_mut() {
                row.swap(k, k - 1);
            }
            k = (k - 1).max(1);
        } else {
            k += 1;
        }
    }
    Some(())
}

/// The coefficients of row k in the orthogonalised rows before, and the squares of the lengths of the orthogonalised rows up to k.
fn orthogonalised(gram: &Rows, rows: &Whole, k: usize) -> Option<(Vec<f64>, Vec<f64>)> {
    let mut squares = Vec::new();
    let mut factors: Vec<Vec<f64>> = Vec::new();
    for i in 0..=k {
        let mut of_row: Vec<f64> = Vec::new();
        for j in 0..i {
            let known = (0..j).map(|l| of_row[l] * factors[j][l] * squares[l]).sum::<f64>();
            of_row.push((product(gram, &rows[i], &rows[j]) - known) / squares[j]);
        }
        let known = (0..i).map(|l| of_row[l] * of_row[l] * squares[l]).sum::<f64>();
        let square = product(gram, &rows[i], &rows[i]) - known;
        if !(square.is_normal() && square > 0.0) {
            return None;
        }
        squares.push(square);
        factors.push(of_row);
    }
    Some((factors.pop().unwrap_or_default(), squares))
}
