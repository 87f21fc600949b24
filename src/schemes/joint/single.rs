//! Multiples of one matrix, whose joint spectral radius is its spectral radius.

use super::entry::Entry;
use super::lower::MAX_CONJUGATE;
use super::matrix_set::{Matrix, MatrixSet};
use super::product::{largest_real, square_of_radius};
use super::roots::order;
use crate::exact::{Rational, RealAlgebraic};

/// The product, the root and the degree, where all matrices are multiples cM, |c| ≤ 1, of one of them, M ≠ 0.
///
/// The spectral radius of M is an eigenvalue if no entry is negative. Otherwise its square is the largest real
/// eigenvalue of M on symmetric tensors; `None` then for more than [`MAX_CONJUGATE`] rows.
pub(super) fn of_multiples<F: Entry>(
    set: &MatrixSet<F>,
) -> Option<(Vec<usize>, RealAlgebraic, usize)> {
    let all = set.matrices();
    let lead = (0..all.len()).find(|&k| all.iter().all(|m| is_multiple(m, &all[k])))?;
    let word = vec![lead];
    let real = largest_real(set, &word);
    if all[lead].iter().flatten().all(|x| x.signum() >= 0) {
        return Some((word, real?.root, 1));
    }
    if set.size() > MAX_CONJUGATE {
        return None;
    }
    let square = square_of_radius(set, &word)?.root;
    let leads =
        |root: &RealAlgebraic| order((root, 1), (&square, 2)) == Some(std::cmp::Ordering::Equal);
    match real.filter(|real| leads(&real.root)) {
        Some(real) => Some((word, real.root, 1)),
        None => Some((word, square, 2)),
    }
}

/// Whether a matrix is cM with |c| ≤ 1.
fn is_multiple<F: Entry>(matrix: &Matrix<F>, of: &Matrix<F>) -> bool {
    let pairs = || matrix.iter().flatten().zip(of.iter().flatten());
    let Some((x, y)) = pairs().find(|(_, y)| y.signum() != 0) else { return false };
    let factor = x.over(y);
    let short = F::from_rational(&Rational::one()).minus(&factor.times(&factor)).signum() >= 0;
    short && pairs().all(|(x, y)| *x == factor.times(y))
}
