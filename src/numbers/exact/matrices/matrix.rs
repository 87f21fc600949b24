//! Matrices with few distinct entries.

use crate::exact::Scalar;
use std::collections::HashMap;
use std::hash::Hash;

/// A matrix that stores each distinct entry once: m_{a,b} = values\[names_{a,b}\]. The
/// number 0 always has the name 0.
///
/// The subdivision matrix around an extraordinary point is such a matrix: its weights
/// repeat under rotations, so n² names refer to about n numbers.
///
/// ```
/// use subcert::exact::{Matrix, Rational};
///
/// let [one, two] = [1, 2].map(Rational::from);
/// let matrix = Matrix::from_rows(vec![vec![one.clone(), two.clone()], vec![two, one]]);
/// assert_eq!(matrix.values(), [0, 1, 2].map(Rational::from));
/// assert_eq!(matrix.left_product(&[1, 1].map(Rational::from)), [3, 3].map(Rational::from));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Matrix<S> {
    values: Vec<S>,
    names: Vec<Vec<u32>>,
}

/// Assigns the names 0, 1, 2, … to numbers. Equal numbers get the same name.
#[derive(Debug)]
pub struct Naming<S> {
    names: HashMap<S, u32>,
}

impl<S: Scalar + Eq + Hash> Naming<S> {
    /// Starts with the number 0, under the name 0.
    #[must_use]
    pub fn new() -> Naming<S> {
        Naming { names: HashMap::from([(S::zero(), 0)]) }
    }

    /// The name of `value`, a new one if it has none yet.
    ///
    /// # Panics
    /// When 2³² distinct numbers have names already.
    pub fn name(&mut self, value: S) -> u32 {
        let next = u32::try_from(self.names.len()).expect("fewer numbers");
        *self.names.entry(value).or_insert(next)
    }

    /// The matrix whose entries have these names, row by row.
    ///
    /// # Panics
    /// When `names` contains a name that was never assigned.
    #[must_use]
    pub fn matrix(self, names: Vec<Vec<u32>>) -> Matrix<S> {
        let count = self.names.len();
        assert!(names.iter().flatten().all(|&name| (name as usize) < count), "names of numbers");
        let mut values: Vec<(S, u32)> = self.names.into_iter().collect();
        values.sort_unstable_by_key(|(_, name)| *name);
        Matrix { values: values.into_iter().map(|(value, _)| value).collect(), names }
    }
}

impl<S: Scalar + Eq + Hash> Default for Naming<S> {
    fn default() -> Naming<S> {
        Naming::new()
    }
}

impl<S: Scalar + Eq + Hash> Matrix<S> {
    /// The matrix with these rows.
    ///
    /// # Panics
    /// When it has 2³² distinct entries or more.
    #[must_use]
    pub fn from_rows(rows: Vec<Vec<S>>) -> Matrix<S> {
        let mut naming = Naming::new();
        let names = rows.into_iter().map(|row| row.into_iter().map(|x| naming.name(x)).collect());
        let names = names.collect();
        naming.matrix(names)
    }
}

impl<S> Matrix<S> {
    /// The number 0 and the distinct entries, in the order of their names.
    #[must_use]
    pub fn values(&self) -> &[S] {
        &self.values
    }

    /// The names of the entries, row by row.
    #[must_use]
    pub fn names(&self) -> &[Vec<u32>] {
        &self.names
    }

    /// The number of rows.
    #[must_use]
    pub fn row_count(&self) -> usize {
        self.names.len()
    }

    /// m_{a,b}.
    ///
    /// # Panics
    /// When there is no such entry.
    #[must_use]
    pub fn entry(&self, a: usize, b: usize) -> &S {
        self.value(self.names[a][b])
    }

    /// The entries of the row a.
    ///
    /// # Panics
    /// When there is no such row.
    #[must_use]
    pub fn row(&self, a: usize) -> impl ExactSizeIterator<Item = &S> + Clone {
        self.names[a].iter().map(|&name| self.value(name))
    }

    /// The matrix with `map` applied to every entry. `map` must send 0 to 0, as products
    /// skip the entries with the name 0.
    #[must_use]
    pub fn map<T>(&self, map: impl FnMut(&S) -> T) -> Matrix<T> {
        Matrix { values: self.values.iter().map(map).collect(), names: self.names.clone() }
    }

    fn value(&self, name: u32) -> &S {
        &self.values[name as usize]
    }
}

impl<S: Scalar> Matrix<S> {
    /// Mx: the sums Σ_b m_{a,b} x_b over the entries other than 0, from left to right.
    ///
    /// # Panics
    /// When `x` does not have one coordinate for each column.
    #[must_use]
    pub fn product(&self, x: &[S]) -> Vec<S> {
        let sum = |row: &Vec<u32>| {
            assert_eq!(row.len(), x.len(), "a coordinate for each column");
            let terms = row.iter().zip(x).filter(|(name, _)| **name != 0);
            terms.fold(S::zero(), |sum, (&name, x)| sum.plus(&self.value(name).times(x)))
        };
        self.names.iter().map(sum).collect()
    }

    /// wᵀM: the sums Σ_a w_a m_{a,b}, computed by [`Scalar::left_product`].
    ///
    /// # Panics
    /// When `w` does not have one coordinate for each row.
    #[must_use]
    pub fn left_product(&self, w: &[S]) -> Vec<S> {
        assert_eq!(w.len(), self.names.len(), "a coordinate for each row");
        S::left_product(w, &self.values, &self.names)
    }
}
