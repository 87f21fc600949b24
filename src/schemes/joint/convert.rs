//! Between exact numbers and f64.

use super::entry::Entry;
use super::matrix_set::MatrixSet;
use crate::exact::{Enclosed, Integer, Rational};
use crate::float::extremal::Rows;
use crate::float::{exact, nearest};

/// The matrices in f64.
pub(super) fn floats<F: Entry>(set: &MatrixSet<F>) -> Vec<Rows> {
    let row = |row: &Vec<F>| row.iter().map(nearest).collect();
    set.matrices().iter().map(|matrix| matrix.iter().map(row).collect()).collect()
}

/// The multiple of 2^(−bits) that is nearest to x.
pub(super) fn on_grid(x: f64, bits: u32) -> Option<Rational> {
    let unit = Rational::from(Integer::one().shifted_left(bits));
    Some(Rational::from((exact(x)? * &unit).round_half_even()) / unit)
}

/// A rational number that is not below x: x itself if it is rational, and otherwise less than 2^(−60) above.
pub(super) fn at_most(x: &impl Enclosed) -> Rational {
    let enclosure = x.enclosure(0);
    if enclosure.lower() == enclosure.upper() {
        return enclosure.upper().clone();
    }
    let unit = Rational::from(Integer::one().shifted_left(61));
    Rational::from((enclosure.upper() * &unit).ceil()) / unit
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
