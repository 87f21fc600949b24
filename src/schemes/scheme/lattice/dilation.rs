//! Dilation matrices: how the indices of a mask on Z^d grow by one step.

use super::matrices::{adjugate, apply, determinant};
use crate::exact::Rational;
use crate::scheme::rules::MAX_ARITY;
use std::collections::BTreeMap;

/// A point of Z^d, d ≤ 3; the coordinates beyond d are 0.
pub type Point = [i64; 3];

/// The most axes.
pub const MAX_DIMENSION: usize = 3;

/// The largest |entry| of a dilation matrix.
pub const MAX_ENTRY: i64 = 64;

/// An integer d×d matrix M, d = 2 or 3, of whose eigenvalues all have moduli above 1, with a digit for each class of Z^d/MZ^d.
///
/// The digits are the points ε with M^{−1}ε in [0, 1)^d, in the order of their coordinates; so the first is 0, and α = Mβ + ε with
/// β = ⌊M^{−1}α⌋ in each coordinate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Dilation {
    dimension: usize,
    /// M, beyond d with the unit matrix.
    matrix: [Point; 3],
    /// det(M)·M^{−1}.
    adjugate: [Point; 3],
    determinant: i64,
    digits: Vec<Point>,
    places: BTreeMap<Point, usize>,
}

/// Why a matrix is no dilation.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum DilationError {
    /// Not square, or of another size than 2 or 3.
    #[error(
        "a dilation matrix has 2 rows of 2 integers, or 3 rows of 3, as [[2, 0], [0, 2]]; for curves the arity is the sum of the coefficients"
    )]
    Shape,
    /// An entry beyond the cap.
    #[error("the entry {0} of the dilation matrix is beyond the cap of {MAX_ENTRY}")]
    Entry(i64),
    /// Too few or too many classes.
    #[error(
        "the determinant of the dilation matrix is {0}: its modulus is the number of rules, which is from 2 to {MAX_ARITY}"
    )]
    Determinant(i64),
    /// An eigenvalue that does not expand.
    #[error(
        "an eigenvalue of the dilation matrix has a modulus of 1 or less, so that its powers do not expand in all directions"
    )]
    Eigenvalue,
}

impl Dilation {
    /// The dilation by this matrix, row by row.
    ///
    /// # Errors
    /// When it is not square of size 2 or 3, an entry or the determinant is out of range, or an eigenvalue has a modulus of at most 1.
    ///
    /// ```
    /// use subcert::scheme::Dilation;
    ///
    /// let quincunx = Dilation::new(&[vec![1, 1], vec![1, -1]])?;
    /// assert_eq!(quincunx.digits(), [[0, 0, 0], [1, 0, 0]]);
    /// assert_eq!(quincunx.split([-2, 1, 0]), (1, [-1, -2, 0]));
    /// assert!(Dilation::new(&[vec![2, 0], vec![0, 1]]).is_err());
    /// # Ok::<(), subcert::scheme::DilationError>(())
    /// ```
    pub fn new(rows: &[Vec<i64>]) -> Result<Dilation, DilationError> {
        let dimension = rows.len();
        if !(2..=MAX_DIMENSION).contains(&dimension)
            || rows.iter().any(|row| row.len() != dimension)
        {
            return Err(DilationError::Shape);
        }
        let too_large = |entry: &&i64| entry.unsigned_abs() > MAX_ENTRY.unsigned_abs();
        if let Some(entry) = rows.iter().flatten().find(too_large) {
            return Err(DilationError::Entry(*entry));
        }
        let unit = |i: usize, j: usize| i64::from(i == j);
        let entry = |i: usize, j: usize| {
            rows.get(i).and_then(|row| row.get(j)).copied().unwrap_or(unit(i, j))
        };
        let matrix = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
        let adjugate = adjugate(&matrix);
        let determinant = determinant(&matrix);
        if !(2..=MAX_ARITY as u64).contains(&determinant.unsigned_abs()) {
            return Err(DilationError::Determinant(determinant));
        }
        if !expands(&matrix, dimension, determinant) {
            return Err(DilationError::Eigenvalue);
        }
        let mut dilation = Dilation {
            dimension,
            matrix,
            adjugate,
            determinant,
            digits: Vec::new(),
            places: BTreeMap::new(),
        };
        dilation.digits = dilation.all_digits();
        dilation.places = dilation.digits.iter().copied().zip(0..).collect();
        Ok(dilation)
    }

    /// nI in d dimensions.
    ///
    /// # Errors
    /// As [`Dilation::new`].
    pub fn scalar(n: i64, dimension: usize) -> Result<Dilation, DilationError> {
        let row = |i: usize| (0..dimension).map(|j| if i == j { n } else { 0 }).collect();
        Dilation::new(&(0..dimension).map(row).collect::<Vec<Vec<i64>>>())
    }

    /// d.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// M, row by row.
    pub fn rows(&self) -> impl Iterator<Item = &[i64]> {
        self.matrix.iter().take(self.dimension).map(|row| &row[..self.dimension])
    }

    /// det M.
    #[must_use]
    pub fn determinant(&self) -> i64 {
        self.determinant
    }

    /// m = |det M|, the number of classes.
    #[must_use]
    pub fn class_count(&self) -> usize {
        self.digits.len()
    }

    /// One point of each class, 0 the first.
    #[must_use]
    pub fn digits(&self) -> &[Point] {
        &self.digits
    }

    /// The diagonal of M, if all other entries are 0.
    #[must_use]
    pub fn diagonal(&self) -> Option<Vec<i64>> {
        let entry = |(i, row): (usize, &[i64])| {
            let diagonal = row.iter().enumerate().all(|(j, x)| i == j || *x == 0);
            diagonal.then_some(row[i])
        };
        self.rows().enumerate().map(entry).collect()
    }

    /// n, where |det M| = n^d.
    #[must_use]
    pub fn root(&self) -> Option<usize> {
        let (m, d) = (self.class_count(), u32::try_from(self.dimension()).ok()?);
        (2..=m).find(|n| n.checked_pow(d) == Some(m))
    }

    /// M^{−1}x.
    #[must_use]
    pub fn inverse_times(&self, x: &[Rational]) -> Vec<Rational> {
        let d = self.dimension();
        let inverse = Rational::from(self.determinant()).recip();
        let unit = |j: usize| std::array::from_fn(|i| i64::from(i == j));
        let columns: Vec<Point> = (0..d).map(|j| self.adjugate_times(unit(j))).collect();
        let entry = |i: usize| {
            let terms = columns.iter().zip(x).map(|(column, x)| x * &Rational::from(column[i]));
            terms.sum::<Rational>() * &inverse
        };
        (0..d).map(entry).collect()
    }

    /// n, where M = nI.
    #[must_use]
    pub fn factor(&self) -> Option<i64> {
        let diagonal = self.diagonal()?;
        diagonal.iter().all(|n| *n == diagonal[0]).then_some(diagonal[0])
    }

    /// Mα.
    #[must_use]
    pub fn times(&self, point: Point) -> Point {
        apply(&self.matrix, point)
    }

    /// det(M)·M^{−1}α.
    #[must_use]
    pub fn adjugate_times(&self, point: Point) -> Point {
        apply(&self.adjugate, point)
    }

    /// M^{−1}α, if it is integer.
    #[must_use]
    pub fn divided(&self, point: Point) -> Option<Point> {
        let (class, quotient) = self.split(point);
        (class == 0).then_some(quotient)
    }

    /// The number of the digit ε and β of α = Mβ + ε.
    ///
    /// # Panics
    /// Never: each class has a digit.
    #[must_use]
    pub fn split(&self, point: Point) -> (usize, Point) {
        let quotient = self.floor(point);
        let rest = difference(point, self.times(quotient));
        (self.places[&rest], quotient)
    }

    /// ⌊M^{−1}α⌋.
    fn floor(&self, point: Point) -> Point {
        let sign = self.determinant.signum();
        let size = self.determinant.abs();
        self.adjugate_times(point).map(|x| (sign * x).div_euclid(size))
    }

    fn all_digits(&self) -> Vec<Point> {
        // M[0, 1)^d is between the sums of the negative and of the positive entries of each row.
        let range = |i: usize| {
            let row = &self.matrix[i][..self.dimension];
            let sum = |of: fn(i64) -> i64| row.iter().map(|x| of(*x)).sum::<i64>();
            if i < self.dimension { sum(|x| x.min(0))..=sum(|x| x.max(0)) } else { 0..=0 }
        };
        let mut digits = Vec::new();
        for x in range(0) {
            for y in range(1) {
                for z in range(2) {
                    if self.floor([x, y, z]) == [0; 3] {
                        digits.push([x, y, z]);
                    }
                }
            }
        }
        // 0 is the first.
        digits.sort_by_key(|digit| (*digit != [0; 3], *digit));
        digits
    }
}

/// The sum of two points.
#[must_use]
pub fn sum(a: Point, b: Point) -> Point {
    std::array::from_fn(|i| a[i] + b[i])
}

/// The difference of two points.
#[must_use]
pub fn difference(a: Point, b: Point) -> Point {
    std::array::from_fn(|i| a[i] - b[i])
}

/// Whether all eigenvalues have moduli above 1: the roots of the characteristic polynomial, read backwards, are then inside the unit circle, which the
/// recursion of Schur and Cohn decides.
fn expands(m: &[Point; 3], dimension: usize, determinant: i64) -> bool {
    let trace: i64 = (0..dimension).map(|i| m[i][i]).sum();
    let backwards = if dimension == 2 {
        // λ² − tλ + D has the reverse D·λ² − tλ + 1.
        vec![1, -trace, determinant]
    } else {
        let minors = (0..3)
            .flat_map(|i| (0..i).map(move |j| m[i][i] * m[j][j] - m[i][j] * m[j][i]))
            .sum::<i64>();
        vec![1, -trace, minors, -determinant]
    };
    let mut f: Vec<i128> = backwards.into_iter().map(i128::from).collect();
    while f.len() > 1 {
        let (first, last) = (f[0], f[f.len() - 1]);
        if first.unsigned_abs() >= last.unsigned_abs() {
            return false;
        }
        f = (1..f.len()).map(|i| last * f[i] - first * f[f.len() - 1 - i]).collect();
    }
    true
}
