//! The characteristic polynomial and the adjugate of a matrix over any ring that contains the rationals.

use crate::exact::{Rational, Scalar};

/// det(x − M) and the adjugate of x − M for a square matrix M, as polynomials in x.
#[derive(Clone, Debug)]
pub struct Adjugate<S> {
    /// c_0, …, c_s with det(x − M) = Σ c_k x^k, c_s = 1.
    pub characteristic: Vec<S>,
    /// B_0, …, B_{s−1} with adj(x − M) = Σ B_k x^k.
    pub adjugate: Vec<Vec<Vec<S>>>,
}

impl<S: Scalar> Adjugate<S> {
    /// By the method of Faddeev and Leverrier: B_{s−1} = 1, and for k = 1, …, s
    ///
    /// c_{s−k} = −tr(M B_{s−k})/k,  B_{s−k−1} = M B_{s−k} + c_{s−k}.
    ///
    /// For an eigenvalue λ of M, every row of adj(λ − M) that is not 0 is a left eigenvector.
    ///
    /// # Panics
    /// When M is not a square matrix of at least one row.
    ///
    /// ```
    /// use subcert::exact::{Adjugate, Rational};
    ///
    /// let number = |n: i64| Rational::from(n);
    /// let found = Adjugate::of(&[vec![number(1), number(2)], vec![number(3), number(4)]]);
    /// assert_eq!(found.characteristic, [-2, -5, 1].map(Rational::from));
    /// assert_eq!(found.adjugate[0], [[-4, 2], [3, -1]].map(|row| row.map(Rational::from).to_vec()));
    /// ```
    #[must_use]
    pub fn of(matrix: &[Vec<S>]) -> Adjugate<S> {
        let size = matrix.len();
        assert!(size > 0 && matrix.iter().all(|row| row.len() == size), "a square matrix");
        let mut current = scalar(size, &S::from_rational(&Rational::one()));
        let mut characteristic = vec![S::from_rational(&Rational::one())];
        let mut adjugate = Vec::with_capacity(size);
        for k in 1..=size {
            let mut product = times(matrix, &current);
            adjugate.push(current);
            let trace = S::total((0..size).map(|i| &product[i][i]));
            let coefficient = trace.times(&S::from_rational(&Rational::new(-1, k)));
            for (i, row) in product.iter_mut().enumerate() {
                row[i].accumulate(&coefficient);
            }
            characteristic.push(coefficient);
            current = product;
        }
        characteristic.reverse();
        adjugate.reverse();
        Adjugate { characteristic, adjugate }
    }
}

/// `value` times the identity.
fn scalar<S: Scalar>(size: usize, value: &S) -> Vec<Vec<S>> {
    let entry = |i: usize, j: usize| if i == j { value.clone() } else { S::zero() };
    (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect()
}

fn times<S: Scalar>(left: &[Vec<S>], right: &[Vec<S>]) -> Vec<Vec<S>> {
    let entry = |row: &[S], j: usize| {
        let mut sum = S::zero();
        for (a, b) in row.iter().zip(right) {
            sum.accumulate(&a.times(&b[j]));
        }
        sum
    };
    left.iter().map(|row| (0..right.len()).map(|j| entry(row, j)).collect()).collect()
}
