//! Invariant subspaces, from the kernels of elements of the algebra that matrices generate.

use super::matrix_set::{Matrix, MatrixSet};
use crate::exact::{
    IntegerPolynomial, Modulus, Rational, Residues, characteristic_polynomial, null_rows, row_times,
};

/// The largest degree of a factor of a characteristic polynomial whose kernel is looked at.
const MAX_DEGREE: usize = 6;

/// The most rows of a kernel that are tried one by one.
const MAX_TRIED: usize = 6;

/// The proper invariant subspace that a row generates.
pub(super) type OrbitOf<'a> = dyn Fn(&[Rational]) -> Option<Matrix<Rational>> + 'a;

/// Rows that span an invariant subspace, neither 0 nor all, if one is found.
///
/// If an element X of the algebra has the irreducible factor f in its characteristic polynomial just on a composition factor, a row of the kernel of f(X) is
/// in a proper invariant subspace, or that of a column is (Parker 1984, Holt and Rees 1994). Elements are sums and products of few matrices. Whether
/// a row generates less than all is first seen modulo a prime.
pub(super) fn by_kernels(set: &MatrixSet, orbit: &OrbitOf<'_>) -> Option<Matrix<Rational>> {
    let p = Modulus::greatest();
    let reduced: Vec<Residues> =
        set.matrices().iter().map(|matrix| p.residues(matrix)).collect::<Option<_>>()?;
    for element in elements(set) {
        let factors = characteristic_polynomial(&element).irreducible_factors()?;
        let small = |factor: &&IntegerPolynomial| factor.degree().is_some_and(|k| k <= MAX_DEGREE);
        for factor in factors.iter().filter(small) {
            let kernel = p.null_rows(&p.value(factor, &p.residues(&element)?));
            let tried = kernel.iter().take(MAX_TRIED);
            if tried.map(|row| p.orbit(row, &reduced)).all(|size| size >= set.size()) {
                continue;
            }
            let kernel = null_rows(&value(factor, &element));
            let found = kernel.iter().take(MAX_TRIED).find_map(|row| orbit(row));
            if found.is_some() {
                return found;
            }
        }
    }
    None
}

/// Some elements of the algebra: the matrices, sums of two, and sums with products of two.
fn elements(set: &MatrixSet) -> impl Iterator<Item = Matrix<Rational>> {
    let all = set.matrices();
    let pairs = move || (0..all.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
    let single = all.iter().cloned();
    let whole = || all.iter().skip(1).fold(all[0].clone(), |sum, m| plus(&sum, m, 1));
    let sums = pairs().map(move |(i, j)| plus(&all[i], &all[j], 1));
    let mixed =
        pairs().map(move |(i, j)| plus(&plus(&product(&all[i], &all[j]), &all[i], 1), &all[j], -2));
    single.chain(std::iter::once_with(whole)).chain(sums).chain(mixed)
}

fn plus(a: &Matrix<Rational>, b: &Matrix<Rational>, times: i64) -> Matrix<Rational> {
    let times = Rational::from(times);
    let row = |(a, b): (&Vec<Rational>, &Vec<Rational>)| {
        a.iter().zip(b).map(|(x, y)| x + &(y * &times)).collect()
    };
    a.iter().zip(b).map(row).collect()
}

fn product(a: &Matrix<Rational>, b: &Matrix<Rational>) -> Matrix<Rational> {
    a.iter().map(|row| row_times(row, b)).collect()
}

/// f(X).
fn value(f: &IntegerPolynomial, x: &Matrix<Rational>) -> Matrix<Rational> {
    let mut value = vec![vec![Rational::zero(); x.len()]; x.len()];
    for c in f.coefficients().iter().rev() {
        value = product(&value, x);
        for (i, row) in value.iter_mut().enumerate() {
            row[i] += &Rational::from(c.clone());
        }
    }
    value
}
