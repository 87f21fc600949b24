//! Characteristic polynomials of rational matrices.

use super::{IntegerPolynomial, Rational};

/// det(xI − M) times its least common denominator, for a square matrix M.
///
/// By the recursion of Faddeev and Le Verrier: N_1 = M, c_k = −tr(N_k)/k, N_{k+1} = M(N_k + c_k I);
/// the polynomial is x^d + c_1 x^{d−1} + … + c_d.
///
/// # Panics
/// When M is not square.
///
/// ```
/// use subcert::exact::{Rational, characteristic_polynomial};
///
/// let rows = [[1, 1], [1, 0]].map(|row| row.map(Rational::from).to_vec());
/// assert_eq!(characteristic_polynomial(&rows).to_string(), "x^2 - x - 1");
/// ```
#[must_use]
pub fn characteristic_polynomial(rows: &[Vec<Rational>]) -> IntegerPolynomial {
    IntegerPolynomial::over_common_denominator(&monic(rows))
}

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
    let size = rows.len();
    let degree = size * (size + 1) / 2;
    let sums = power_sums(&monic(rows), 2 * degree);
    let half = Rational::new(1, 2);
    let squares = (1..=degree).map(|k| (&sums[k] * &sums[k] + &sums[2 * k]) * &half);
    let squares: Vec<Rational> = [Rational::zero()].into_iter().chain(squares).collect();
    // Newton: k e_k = Σ_{i=1}^{k} (−1)^{i−1} e_{k−i} p_i; here c_k = (−1)^k e_k.
    let mut coefficients = vec![Rational::one()];
    for k in 1..=degree {
        let sum: Rational = (1..=k).map(|i| &coefficients[k - i] * &squares[i]).sum();
        coefficients.push(-sum / Rational::from(k));
    }
    coefficients.reverse();
    IntegerPolynomial::over_common_denominator(&coefficients)
}

/// c_d, …, c_1, 1 of the monic characteristic polynomial.
fn monic(rows: &[Vec<Rational>]) -> Vec<Rational> {
    let size = rows.len();
    assert!(rows.iter().all(|row| row.len() == size), "a square matrix");
    let mut coefficients = vec![Rational::one()];
    let mut power = rows.to_vec();
    for k in 1..=size {
        if k > 1 {
            power = product(rows, &power);
        }
        let trace: Rational = (0..size).map(|i| &power[i][i]).sum();
        let c = -trace / Rational::from(k);
        for (i, row) in power.iter_mut().enumerate() {
            row[i] += &c;
        }
        coefficients.push(c);
    }
    coefficients.reverse();
    coefficients
}

fn product(a: &[Vec<Rational>], b: &[Vec<Rational>]) -> Vec<Vec<Rational>> {
    let entry = |row: &Vec<Rational>, j: usize| {
        let terms = row.iter().zip(b).filter(|(x, _)| !x.is_zero());
        terms.map(|(x, other)| x * &other[j]).sum()
    };
    a.iter().map(|row| (0..b.len()).map(|j| entry(row, j)).collect()).collect()
}

/// p_0, …, p_{count} of the roots of a monic polynomial, by Newton's identities.
fn power_sums(monic: &[Rational], count: usize) -> Vec<Rational> {
    let size = monic.len() - 1;
    // The coefficient of x^{size − i}.
    let c = |i: usize| &monic[size - i];
    let mut sums = vec![Rational::from(size)];
    for k in 1..=count {
        let known: Rational = (1..k.min(size + 1)).map(|i| c(i) * &sums[k - i]).sum();
        let own = if k <= size { Rational::from(k) * c(k) } else { Rational::zero() };
        sums.push(-(known + own));
    }
    sums
}
