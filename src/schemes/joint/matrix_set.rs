//! Sets of square matrices of one size.

use crate::exact::{Rational, Real, Scalar, echelon, row_times};

/// The most rows of a matrix.
pub const MAX_SIZE: usize = 64;

/// The most matrices of a set.
pub const MAX_MATRICES: usize = 64;

/// A matrix, row by row.
pub(crate) type Matrix<F> = Vec<Vec<F>>;

/// Square matrices of one size, over the rationals or over one real field.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MatrixSet<F = Rational> {
    matrices: Vec<Matrix<F>>,
}

/// Why matrices are no set of square matrices, or too large a one.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MatrixSetError {
    /// None, or more than [`MAX_MATRICES`].
    #[error("{0} matrices; there must be from 1 to {MAX_MATRICES}")]
    Count(usize),
    /// No row, or more than [`MAX_SIZE`].
    #[error("matrix {matrix} has {rows} rows; there must be from 1 to {MAX_SIZE}")]
    Size {
        /// Which matrix, counted from 1.
        matrix: usize,
        /// Its rows.
        rows: usize,
    },
    /// A row of another length than the first matrix has rows.
    #[error(
        "row {row} of matrix {matrix} has {found} entries, not {expected}; all matrices must be \
         square and of one size"
    )]
    Row {
        /// Which matrix, counted from 1.
        matrix: usize,
        /// Which row, counted from 1.
        row: usize,
        /// Its length.
        found: usize,
        /// The size of the first matrix.
        expected: usize,
    },
    /// A matrix of another size than the first.
    #[error(
        "matrix {matrix} has {found} rows, and matrix 1 has {expected}; all must be of one size"
    )]
    Different {
        /// Which matrix, counted from 1.
        matrix: usize,
        /// How many rows it has.
        found: usize,
        /// How many rows the first has.
        expected: usize,
    },
}

impl<F: Real + PartialEq> MatrixSet<F> {
    /// The set of these matrices, each row by row.
    ///
    /// # Errors
    /// When they are not square and of one size, or beyond the caps.
    pub fn new(matrices: Vec<Matrix<F>>) -> Result<MatrixSet<F>, MatrixSetError> {
        if !(1..=MAX_MATRICES).contains(&matrices.len()) {
            return Err(MatrixSetError::Count(matrices.len()));
        }
        let expected = matrices[0].len();
        for (matrix, rows) in (1..).zip(&matrices) {
            if !(1..=MAX_SIZE).contains(&rows.len()) {
                return Err(MatrixSetError::Size { matrix, rows: rows.len() });
            }
            if rows.len() != expected {
                return Err(MatrixSetError::Different { matrix, found: rows.len(), expected });
            }
            for (row, entries) in (1..).zip(rows) {
                if entries.len() != expected {
                    let found = entries.len();
                    return Err(MatrixSetError::Row { matrix, row, found, expected });
                }
            }
        }
        Ok(MatrixSet { matrices })
    }

    /// The set of square matrices of one size, however large.
    pub(crate) fn of_any_size(matrices: Vec<Matrix<F>>) -> MatrixSet<F> {
        MatrixSet { matrices }
    }

    /// What becomes of the matrices.
    pub(super) fn part(&self, of: &dyn Fn(&Matrix<F>) -> Matrix<F>) -> MatrixSet<F> {
        MatrixSet { matrices: self.matrices.iter().map(of).collect() }
    }

    /// The matrices, row by row.
    #[must_use]
    pub fn matrices(&self) -> &[Matrix<F>] {
        &self.matrices
    }

    /// d of d×d matrices.
    #[must_use]
    pub fn size(&self) -> usize {
        self.matrices[0].len()
    }

    /// M_{w_1}⋯M_{w_l}; the unit matrix for no factor.
    ///
    /// # Panics
    /// When there is no such matrix.
    #[must_use]
    pub fn product(&self, word: &[usize]) -> Vec<Vec<F>> {
        let size = self.size();
        let entry = |i: usize, j: usize| F::from_rational(&Rational::from(i64::from(i == j)));
        let unit = |i: usize| (0..size).map(|j| entry(i, j)).collect();
        let start: Matrix<F> = (0..size).map(unit).collect();
        word.iter().fold(start, |product, &i| {
            product.iter().map(|row| row_times(row, &self.matrices[i])).collect()
        })
    }

    /// The matrices with every entry mapped.
    pub(super) fn map<T: Scalar>(&self, map: impl Fn(&F) -> T + Copy) -> MatrixSet<T> {
        let row = |row: &Vec<F>| row.iter().map(map).collect();
        let matrix = |rows: &Matrix<F>| rows.iter().map(row).collect();
        MatrixSet { matrices: self.matrices.iter().map(matrix).collect() }
    }

    /// Whether every product of d factors is 0: the radius is then 0, and otherwise it is positive.
    #[must_use]
    pub fn is_nilpotent(&self) -> bool {
        // The spans of the rows of all products of k factors, k = 0, 1, …, are each a part of the one before.
        let mut span = self.product(&[]);
        loop {
            let images =
                self.matrices.iter().flat_map(|m| span.iter().map(|row| row_times(row, m)));
            let next = echelon(images.collect()).0;
            if next.is_empty() || next.len() == span.len() {
                return next.is_empty();
            }
            span = next;
        }
    }
}
