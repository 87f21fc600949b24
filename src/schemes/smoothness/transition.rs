//! The matrices of a scheme on windows of its data.

use super::symbol::Symbol;
use crate::joint::{Entry, MatrixSet, MatrixSetError};

/// The n matrices T_e, e = 0, …, n−1, of a symbol B = Σ_{s=0}^{L} b_s z^s (up to a power of z), with the
/// entries b_{L−n+1+e+i−nj}, i, j = 0, …, w−1, w = max(1, ⌈(L−1)/(n−1)⌉ + 1).
///
/// They take w successive data to w successive data of the next level, and every such window arises from
/// one of them. The rows of all products of c of them are those of S_B^c, so that their joint spectral
/// radius is the spectral radius of S_B in the supremum norm. `proofs/THEOREMS.md`, 106.
///
/// # Errors
/// When the matrices are beyond the caps of [`MatrixSet`].
///
/// # Panics
/// Never.
pub fn transition_matrices<F: Entry>(symbol: &Symbol<F>) -> Result<MatrixSet<F>, MatrixSetError> {
    MatrixSet::new(windows(symbol.coefficients(), symbol.arity(), &F::zero()))
}

/// The matrices of [`transition_matrices`] for the coefficients b_0, …, b_L.
pub(super) fn windows<T: Clone>(b: &[T], n: usize, zero: &T) -> Vec<Vec<Vec<T>>> {
    let last = b.len().saturating_sub(1);
    let width = if last == 0 { 1 } else { (last - 1).div_ceil(n - 1) + 1 };
    let entry = |e: usize, i: usize, j: usize| {
        // L + 1 + e + i − n(j + 1).
        let place = (last + 1 + e + i).checked_sub(n * (j + 1));
        place.and_then(|place| b.get(place)).unwrap_or(zero).clone()
    };
    let row = |e, i| (0..width).map(|j| entry(e, i, j)).collect();
    (0..n).map(|e| (0..width).map(|i| row(e, i)).collect()).collect()
}
