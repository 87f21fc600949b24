//! Extremal hulls: the proof that the radius is the one of a product.

use super::convert::{float, floats, scaled};
use super::entry::Entry;
use super::matrix_set::MatrixSet;
use crate::exact::{Rational, Real, null_rows, only_solution};
use crate::float::extremal::{Closure, Image, Origin, Rows, SearchCaps, close};
use crate::float::nearest;

/// |λ| of a product of `length` factors, as a number of a field; θ = |λ|^{1/length}.
#[derive(Clone, Debug)]
pub(super) struct Rate<F> {
    pub(super) root: F,
    inverse: F,
    pub(super) length: usize,
}

/// A row θ^{−power}·row, 0 ≤ power < length.
#[derive(Clone, Debug)]
pub(super) struct Vertex<F> {
    pub(super) row: Vec<F>,
    pub(super) power: usize,
}

/// The rows of a hull that was found in f64, exactly; the first d are τ times the unit rows.
pub(super) struct Extremal<F> {
    pub(super) rate: Rate<F>,
    pub(super) vertices: Vec<Vertex<F>>,
    pub(super) closure: Closure,
}

impl<F: Real> Rate<F> {
    pub(super) fn new(root: F, length: usize) -> Rate<F> {
        let inverse = F::from_rational(&Rational::one()).over(&root);
        Rate { root, inverse, length }
    }

    /// θ^{−1}·vM.
    pub(super) fn step(&self, vertex: &Vertex<F>, matrix: &[Vec<F>]) -> Vertex<F>
    where
        F: PartialEq,
    {
        let zero = F::zero();
        let mut row = vec![F::zero(); matrix.len()];
        for (x, entries) in vertex.row.iter().zip(matrix) {
            for (sum, entry) in row.iter_mut().zip(entries).filter(|(_, entry)| **entry != zero) {
                sum.accumulate(&x.times(entry));
            }
        }
        let power = vertex.power + 1;
        if power < self.length {
            return Vertex { row, power };
        }
        for x in &mut row {
            *x = x.times(&self.inverse);
        }
        Vertex { row, power: 0 }
    }
}

impl<F: Entry> Extremal<F> {
    /// Searches for an extremal hull: of τ times the unit rows, and of the left eigenvectors of these
    /// words, of which the first has the rate.
    ///
    /// `None` where no eigenvector of the words has this rate, or the search meets its caps.
    pub(super) fn search(
        set: &MatrixSet<F>,
        rate: Rate<F>,
        unit: &Rational,
        words: &[Vec<usize>],
        caps: SearchCaps,
    ) -> Option<Extremal<F>> {
        let size = set.size();
        let unit_row = |i: usize| {
            let entry = |k| if k == i { F::from_rational(unit) } else { F::zero() };
            Vertex { row: (0..size).map(entry).collect(), power: 0 }
        };
        let mut vertices: Vec<Vertex<F>> = (0..size).map(unit_row).collect();
        let mut known = Vec::new();
        for word in words.iter().filter(|word| word.len().is_multiple_of(rate.length)) {
            for mut vertex in eigenvectors(set, &rate, word) {
                let start = vertices.len();
                for (i, &by) in word.iter().enumerate() {
                    let next = rate.step(&vertex, &set.matrices()[by]);
                    vertices.push(std::mem::replace(&mut vertex, next));
                    known.push((start + i, by, start + (i + 1) % word.len()));
                }
            }
        }
        if known.is_empty() {
            return None;
        }
        let theta = nearest(&rate.root).powf(1.0 / float(rate.length));
        let matrices: Vec<Rows> = floats(set).into_iter().map(|m| scaled(m, 1.0 / theta)).collect();
        let seeds = vertices.iter().map(|vertex| {
            let scale = theta.powf(-float(vertex.power));
            vertex.row.iter().map(|x| nearest(x) * scale).collect()
        });
        let closure = close(&matrices, seeds.collect(), &known, caps)?;
        for origin in &closure.origins[vertices.len()..] {
            if let Origin::Image { of, by } = *origin {
                vertices.push(rate.step(&vertices[of], &set.matrices()[by]));
            }
        }
        Some(Extremal { rate, vertices, closure })
    }

    /// Every row with each matrix, and where the image lies.
    pub(super) fn images(&self) -> impl Iterator<Item = (usize, usize, &Image)> {
        let rows = self.closure.images.iter().enumerate();
        rows.flat_map(|(i, images)| {
            images.iter().enumerate().map(move |(by, image)| (i, by, image))
        })
    }

    /// The exact coefficients of a vertex as a combination of others of the same power, if Σ|c_j| ≤ 1.
    pub(super) fn exact_combination(
        &self,
        image: &Vertex<F>,
        combination: &[(usize, f64)],
    ) -> Option<Vec<(usize, F)>> {
        // Coefficients that are 0 but for rounding are left out first.
        let used: Vec<usize> =
            combination.iter().filter(|(_, c)| c.abs() > 1e-9).map(|(j, _)| *j).collect();
        if used.iter().any(|&j| self.vertices[j].power != image.power) {
            return None;
        }
        let equation = |(k, x): (usize, &F)| {
            used.iter().map(|&j| self.vertices[j].row[k].clone()).chain([x.clone()]).collect()
        };
        let exact = only_solution(image.row.iter().enumerate().map(equation).collect())?;
        let sum = F::sum_of_magnitudes(&exact);
        let one = F::from_rational(&Rational::one());
        (sum.greater(&one) == one).then(|| used.into_iter().zip(exact).collect())
    }
}

/// Left eigenvectors of the product for the eigenvalues ±θ^l, with Σ|v_k| = 1.
fn eigenvectors<F: Entry>(set: &MatrixSet<F>, rate: &Rate<F>, word: &[usize]) -> Vec<Vertex<F>> {
    let product = set.product(word);
    let one = F::from_rational(&Rational::one());
    let power = (0..word.len() / rate.length).fold(one, |power, _| power.times(&rate.root));
    let shifted = |eigenvalue: &F| -> Vec<Vec<F>> {
        let entry = |i: usize, j: usize, x: &F| {
            if i == j { x.minus(eigenvalue) } else { x.clone() }
        };
        let row = |(i, row): (usize, &Vec<F>)| {
            row.iter().enumerate().map(|(j, x)| entry(i, j, x)).collect()
        };
        product.iter().enumerate().map(row).collect()
    };
    let negative = F::zero().minus(&power);
    let rows = [&power, &negative].into_iter().flat_map(|value| null_rows(&shifted(value)));
    rows.map(|row| {
        let length = F::sum_of_magnitudes(&row);
        Vertex { row: row.iter().map(|x| x.over(&length)).collect(), power: 0 }
    })
    .collect()
}
