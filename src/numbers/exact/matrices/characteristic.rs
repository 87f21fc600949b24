//! Characteristic polynomials of matrices.

use super::elimination::row_times;
use crate::exact::{IntegerPolynomial, Rational, Scalar};

/// The polynomial of which the roots are the products λ_i λ_j, i ≤ j, of the eigenvalues of a square
/// matrix, times a positive integer. The square of the spectral radius is one of its roots, and the
/// greatest real one.
///
/// The sum of the k-th powers of the roots is (p_k² + p_{2k})/2, where p_k is that of the eigenvalues.
///
/// # Panics
/// When the matrix is not square.
///
/// ```
/// use subcert::exact::{Rational, symmetric_square_polynomial};
///
/// // The eigenvalues are i and −i; the products are −1, 1 and −1.
/// let rows = [[0, 1], [-1, 0]].map(|row| row.map(Rational::from).to_vec());
/// assert_eq!(symmetric_square_polynomial(&rows).to_string(), "x^3 + x^2 - x - 1");
/// ```
#[must_use]
pub fn symmetric_square_polynomial(rows: &[Vec<Rational>]) -> IntegerPolynomial {
    IntegerPolynomial::over_common_denominator(&symmetric_square_coefficients(rows))
}

/// c_d, …, c_1, 1 of the characteristic polynomial of a square matrix over any field, from the constant term
/// upwards; see [`characteristic_polynomial`](crate::exact::characteristic_polynomial).
///
/// By the recursion of Faddeev and Le Verrier: N_1 = M, c_k = −tr(N_k)/k, N_{k+1} = M(N_k + c_k I);
/// the polynomial is x^d + c_1 x^{d−1} + … + c_d.
///
/// # Panics
/// When the matrix is not square.
#[must_use]
pub fn characteristic_coefficients<F: Scalar + PartialEq>(rows: &[Vec<F>]) -> Vec<F> {
    let size = rows.len();
    assert!(rows.iter().all(|row| row.len() == size), "a square matrix");
    let mut coefficients = vec![F::from_rational(&Rational::one())];
    let mut power = rows.to_vec();
    for k in 1..=size {
        if k > 1 {
            power = rows.iter().map(|row| row_times(row, &power)).collect();
        }
        let trace = F::total((0..size).map(|i| &power[i][i]));
        let c = trace.times(&F::from_rational(&-Rational::from(k).recip()));
        for (i, row) in power.iter_mut().enumerate() {
            row[i].accumulate(&c);
        }
        coefficients.push(c);
    }
    coefficients.reverse();
    coefficients
}

/// The coefficients of the monic polynomial of [`symmetric_square_polynomial`], over any field.
///
/// # Panics
/// When the matrix is not square.
#[must_use]
pub fn symmetric_square_coefficients<F: Scalar + PartialEq>(rows: &[Vec<F>]) -> Vec<F> {
    let size = rows.len();
    let degree = size * (size + 1) / 2;
    let sums = power_sums(&characteristic_coefficients(rows), 2 * degree);
    let half = F::from_rational(&Rational::new(1, 2));
    let squares = (1..=degree).map(|k| sums[k].times(&sums[k]).plus(&sums[2 * k]).times(&half));
    let squares: Vec<F> = [F::zero()].into_iter().chain(squares).collect();
    // Newton: k e_k = Σ_{i=1}^{k} (−1)^{i−1} e_{k−i} p_i; here c_k = (−1)^k e_k.
    let mut coefficients = vec![F::from_rational(&Rational::one())];
    for k in 1..=degree {
        let mut sum = F::zero();
        (1..=k).for_each(|i| sum.accumulate(&coefficients[k - i].times(&squares[i])));
        coefficients.push(sum.times(&F::from_rational(&-Rational::from(k).recip())));
    }
    coefficients.reverse();
    coefficients
}

/// p_0, …, p_{count} of the roots of a monic polynomial, by Newton's identities.
fn power_sums<F: Scalar>(monic: &[F], count: usize) -> Vec<F> {
    let size = monic.len() - 1;
    let whole = |k: usize| F::from_rational(&Rational::from(k));
    // The coefficient of x^{size − i}.
    let c = |i: usize| &monic[size - i];
    let mut sums = vec![whole(size)];
    for k in 1..=count {
        let mut sum = F::zero();
        for i in 1..k.min(size + 1) {
            sum.lessen(&c(i).times(&sums[k - i]));
        }
        if k <= size {
            sum.lessen(&whole(k).times(c(k)));
        }
        sums.push(sum);
    }
    sums
}
