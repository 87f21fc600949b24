//! Reduction of a set of matrices to blocks, by subspaces that all of them leave invariant.
//!
//! These subspaces are looked for: coordinate subspaces; the sum of the images of the matrices; and for up to
//! [`MAX_VECTORS`] rows, what a unit row generates, or an eigenrow of one matrix for a rational eigenvalue. The same is
//! done for columns. So not every invariant subspace is found.

use super::balance::{balance, changed};
use super::hull::Hull;
use super::invariant::by_kernels;
use super::matrix_set::{Matrix, MatrixSet};
use crate::exact::{
    IntegerPolynomial, Rational, RealAlgebraic, characteristic_coefficients, echelon, null_rows,
    row_times,
};

/// The most rows of matrices for which the subspaces are looked for that single rows generate.
const MAX_VECTORS: usize = 16;

/// A basis in which all matrices of a set are block triangular, and the blocks on the diagonal.
///
/// With the basis as the rows of T, TMT^{−1} has no entries to the right of the blocks. The joint spectral radius is the
/// maximum of those of the blocks. `proofs/THEOREMS.md`, 103 (c).
#[derive(Clone, Debug)]
pub struct Reduction {
    /// T.
    pub basis: Vec<Vec<Rational>>,
    /// T^{−1}.
    pub inverse: Vec<Vec<Rational>>,
    /// The blocks, from above.
    pub blocks: Vec<MatrixSet>,
}

impl Reduction {
    /// The blocks of a set; `None` where no invariant subspace is found.
    #[must_use]
    pub fn of(set: &MatrixSet) -> Option<Reduction> {
        Reduction::by(set, &invariant)
    }

    /// The same, with subspaces that kernels of elements of the algebra generate.
    #[must_use]
    pub fn fine(set: &MatrixSet) -> Option<Reduction> {
        Reduction::by(set, &|set| invariant(set).or_else(|| by_elements(set)))
    }

    /// All as one block.
    pub(super) fn whole(set: &MatrixSet) -> Reduction {
        let unit = set.product(&[]);
        Reduction { basis: unit.clone(), inverse: unit, blocks: vec![set.clone()] }
    }

    fn by(set: &MatrixSet, invariant: &Search<'_>) -> Option<Reduction> {
        let (basis, blocks) = flag(set, invariant);
        if blocks.len() == 1 {
            return None;
        }
        let inverse = inverse(&basis)?;
        Some(Reduction { basis, inverse, blocks })
    }

    /// The same with each block in a basis in which its matrices are about as large as their radius.
    #[must_use]
    pub fn balanced(self) -> Reduction {
        let Reduction { mut basis, mut inverse, mut blocks } = self;
        let mut start = 0;
        for block in &mut blocks {
            let size = block.size();
            if let Some((own, back)) = balance(block).filter(|_| size > 1) {
                *block = changed(block, &own, &back);
                let rows = own.iter().map(|row| row_times(row, &basis[start..start + size]));
                let rows: Vec<Vec<Rational>> = rows.collect();
                basis.splice(start..start + size, rows);
                for row in &mut inverse {
                    let part = row_times(&row[start..start + size], &back);
                    row.splice(start..start + size, part);
                }
            }
            start += size;
        }
        Reduction { basis, inverse, blocks }
    }

    /// The matrices with the blocks alone, in this basis.
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn diagonal(&self) -> MatrixSet {
        let count = self.blocks[0].matrices().len();
        let matrix = |i: usize| {
            self.blocks.iter().fold(Vec::new(), |all, block| beside(all, &block.matrices()[i]))
        };
        MatrixSet::of_any_size((0..count).map(matrix).collect())
    }

    /// A hull of the matrices with the blocks alone, of hulls of the blocks.
    pub(super) fn hull(&self, of_blocks: &[&Hull]) -> Hull {
        let size: usize = self.blocks.iter().map(MatrixSet::size).sum();
        let bound = of_blocks.iter().map(|hull| &hull.bound).max().expect("a block").clone();
        let unit = Rational::one();
        let (mut rows, mut units, mut images) = (Vec::new(), Vec::new(), Vec::new());
        let mut start = 0;
        for (block, hull) in self.blocks.iter().zip(of_blocks) {
            let (own, before) = (block.size(), rows.len());
            let place = |j: usize| if j < own { start + j } else { size + before + j - own };
            let moved = |terms: &Vec<(usize, Rational)>| -> Vec<(usize, Rational)> {
                terms.iter().map(|(j, c)| (place(*j), c.clone())).collect()
            };
            let all = hull.images.iter().map(|row| row.iter().map(moved).collect::<Vec<_>>());
            let mut all = all.collect::<Vec<_>>().into_iter();
            units.extend(all.by_ref().take(own));
            images.extend(all);
            // The unit rows of the block become those of the whole: all its rows are scaled alike.
            for row in &hull.rows {
                let mut wide = vec![Rational::zero(); size];
                for (x, v) in wide[start..].iter_mut().zip(row) {
                    *x = v / &hull.unit;
                }
                rows.push(wide);
            }
            start += own;
        }
        units.extend(images);
        Hull { bound, unit, rows, images: units }
    }
}

/// A search for an invariant subspace, neither 0 nor all.
type Search<'a> = dyn Fn(&MatrixSet) -> Option<Matrix<Rational>> + 'a;

/// A basis, and the blocks on the diagonal.
fn flag(set: &MatrixSet, invariant: &Search<'_>) -> (Matrix<Rational>, Vec<MatrixSet>) {
    let Some(rows) = invariant(set) else { return (set.product(&[]), vec![set.clone()]) };
    let size = set.size();
    let (inside, pivots) = echelon(rows);
    let others: Vec<usize> = (0..size).filter(|k| !pivots.contains(k)).collect();
    // A row of the subspace has its entries at the pivots as coordinates; without them, those at the others are left.
    let first = |m: &Matrix<Rational>| -> Matrix<Rational> {
        let image = |row: &Vec<Rational>| {
            let image = row_times(row, m);
            pivots.iter().map(|&k| image[k].clone()).collect()
        };
        inside.iter().map(image).collect()
    };
    let second = |m: &Matrix<Rational>| -> Matrix<Rational> {
        let image = |&i: &usize| {
            let mut image = m[i].clone();
            for (row, &pivot) in inside.iter().zip(&pivots) {
                let factor = image[pivot].clone();
                image.iter_mut().zip(row).for_each(|(x, v)| *x -= &(&factor * v));
            }
            others.iter().map(|&k| image[k].clone()).collect()
        };
        others.iter().map(image).collect()
    };
    let part = |of: &dyn Fn(&Matrix<Rational>) -> Matrix<Rational>| flag(&set.part(of), invariant);
    let ((above, mut blocks), (below, more)) = (part(&first), part(&second));
    blocks.extend(more);
    let unit = set.product(&[]);
    let whole: Matrix<Rational> =
        inside.iter().cloned().chain(others.iter().map(|&k| unit[k].clone())).collect();
    let basis = beside(above, &below);
    (basis.iter().map(|row| row_times(row, &whole)).collect(), blocks)
}

/// The matrix with these two on the diagonal.
fn beside(first: Matrix<Rational>, second: &Matrix<Rational>) -> Matrix<Rational> {
    let (before, after) = (first.len(), second.len());
    let zeros = |count: usize| std::iter::repeat_n(Rational::zero(), count);
    let above = first.into_iter().map(|row| row.into_iter().chain(zeros(after)).collect());
    let below = second.iter().map(|row| zeros(before).chain(row.iter().cloned()).collect());
    above.chain(below).collect()
}

/// The inverse of an invertible matrix.
fn inverse(matrix: &Matrix<Rational>) -> Option<Matrix<Rational>> {
    let size = matrix.len();
    let unit = |i: usize| (0..size).map(move |j| Rational::from(i64::from(i == j)));
    let wide =
        matrix.iter().enumerate().map(|(i, row)| row.iter().cloned().chain(unit(i)).collect());
    let (rows, pivots) = echelon(wide.collect());
    let regular = pivots.iter().copied().eq(0..size);
    regular.then(|| rows.into_iter().map(|row| row[size..].to_vec()).collect())
}

/// Rows that span an invariant subspace, neither 0 nor all.
fn invariant(set: &MatrixSet) -> Option<Matrix<Rational>> {
    of_rows(set).or_else(|| by_columns(set, of_rows))
}

/// The rows that vanish on an invariant subspace of columns.
fn by_columns(
    set: &MatrixSet,
    search: impl Fn(&MatrixSet) -> Option<Matrix<Rational>>,
) -> Option<Matrix<Rational>> {
    let columns = search(&set.part(&transpose))?;
    Some(null_rows(&transpose(&columns)))
}

/// Rows that span an invariant subspace, from kernels.
fn by_elements(set: &MatrixSet) -> Option<Matrix<Rational>> {
    let of = |set: &MatrixSet| by_kernels(set, &|row| orbit(set, row));
    of(set).or_else(|| by_columns(set, of))
}

fn transpose(matrix: &Matrix<Rational>) -> Matrix<Rational> {
    let columns = matrix.first().map_or(0, Vec::len);
    (0..columns).map(|j| matrix.iter().map(|row| row[j].clone()).collect()).collect()
}

fn of_rows(set: &MatrixSet) -> Option<Matrix<Rational>> {
    let size = set.size();
    let unit = set.product(&[]);
    if let Some(places) = (0..size).map(|i| reached(set, i)).find(|places| places.len() < size) {
        return Some(places.into_iter().map(|k| unit[k].clone()).collect());
    }
    let proper = |rows: &Matrix<Rational>| (1..size).contains(&rows.len());
    let images = echelon(set.matrices().iter().flatten().cloned().collect()).0;
    if proper(&images) {
        return Some(images);
    }
    if size > MAX_VECTORS {
        return None;
    }
    unit.iter()
        .find_map(|row| orbit(set, row))
        .or_else(|| set.matrices().iter().flat_map(eigenrows).find_map(|row| orbit(set, &row)))
}

/// The unit rows in the least coordinate subspace that has this one and is invariant.
fn reached(set: &MatrixSet, from: usize) -> Vec<usize> {
    let mut places = vec![from];
    let mut next = 0;
    while let Some(&i) = places.get(next) {
        for matrix in set.matrices() {
            for (k, _) in matrix[i].iter().enumerate().filter(|(_, x)| !x.is_zero()) {
                if !places.contains(&k) {
                    places.push(k);
                }
            }
        }
        next += 1;
    }
    places
}

/// The invariant subspace that a row generates, unless it is the whole space.
fn orbit(set: &MatrixSet, row: &[Rational]) -> Option<Matrix<Rational>> {
    let mut basis: Vec<(usize, Vec<Rational>)> = Vec::new();
    let mut waiting = vec![row.to_vec()];
    while let Some(mut row) = waiting.pop() {
        for (pivot, known) in &basis {
            let factor = row[*pivot].clone();
            if !factor.is_zero() {
                row.iter_mut().zip(known).for_each(|(x, v)| *x -= &(&factor * v));
            }
        }
        let Some(pivot) = row.iter().position(|x| !x.is_zero()) else { continue };
        let scale = row[pivot].recip();
        row = row.iter().map(|x| x * &scale).collect();
        if basis.len() + 1 == set.size() {
            return None;
        }
        waiting.extend(set.matrices().iter().map(|matrix| row_times(&row, matrix)));
        basis.push((pivot, row));
    }
    Some(basis.into_iter().map(|(_, row)| row).collect())
}

/// Left eigenrows for the rational eigenvalues, a basis for each.
fn eigenrows(matrix: &Matrix<Rational>) -> Vec<Vec<Rational>> {
    let polynomial =
        IntegerPolynomial::over_common_denominator(&characteristic_coefficients(matrix));
    let of = |root: RealAlgebraic| {
        let mut shifted = matrix.clone();
        if let Some(value) = root.as_rational() {
            shifted.iter_mut().enumerate().for_each(|(i, row)| row[i] -= value);
            return null_rows(&shifted);
        }
        Vec::new()
    };
    RealAlgebraic::roots_of(&polynomial).into_iter().flat_map(of).collect()
}
