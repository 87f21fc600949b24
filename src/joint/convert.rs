//! Between exact numbers and f64.

use super::matrix_set::MatrixSet;
use crate::exact::{Integer, Rational};
use crate::float::extremal::Rows;
use crate::float::{exact, nearest};

/// The matrices in f64.
pub(super) fn floats(set: &MatrixSet) -> Vec<Rows> {
    let row = |row: &Vec<Rational>| row.iter().map(nearest).collect();
    set.matrices().iter().map(|matrix| matrix.iter().map(row).collect()).collect()
}

/// The multiple of 2^(−bits) that is nearest to x.
pub(super) fn on_grid(x: f64, bits: u32) -> Option<Rational> {
    let unit = Rational::from(Integer::one().shifted_left(bits));
    Some(Rational::from((exact(x)? * &unit).round_half_even()) / unit)
}

/// A count in f64.
pub(super) fn float(count: usize) -> f64 {
    f64::from(u32::try_from(count).expect("a small number"))
}

/// A matrix times a number.
pub(super) fn scaled(mut matrix: Rows, factor: f64) -> Rows {
    matrix.iter_mut().flatten().for_each(|x| *x *= factor);
    matrix
}
