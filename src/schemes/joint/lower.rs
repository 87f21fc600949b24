//! The bounds that start from a product of large spectral radius.

use super::convert::{float, floats, on_grid, scaled};
use super::entry::Entry;
use super::extremal::{Extremal, Rate};
use super::hull::Hull;
use super::matrix_set::MatrixSet;
use super::product::{LeadingEigenvalue, Root, largest_real, shown, square_of_radius};
use super::proposal::hull;
use super::roots::{algebraic_root, rational_root};
use crate::exact::{Rational, RealAlgebraic, stretched};
use crate::float::extremal::{Candidates, Rows, SearchCaps, close, row_times};
use crate::float::nearest;

/// The largest matrices for which products of two conjugate eigenvalues are taken.
pub(super) const MAX_CONJUGATE: usize = 8;

/// The most rows of a hull.
pub const MAX_ROWS: usize = 1_200;

/// The most work of the search for a hull.
const MAX_WORK: u64 = 1_500_000_000;

/// The excesses of the bounds that are tried in turn when the radius is not found exactly.
const EXCESSES: [f64; 9] = [0.3, 0.1, 0.03, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7];

/// From a polynomial of so many coefficients on, f64 decides first whether an extremal hull can be found.
const LONG_POLYNOMIAL: usize = 8;

/// Where more products have the rate, an extremal hull is first looked for with the eigenvectors of so many of the
/// shortest: of a group of matrices all products have it, and the eigenvectors of one are enough.
const FEW_WORDS: usize = 8;

/// How often a row is multiplied by a product until it is taken for an eigenvector.
const ROUNDS: usize = 200;

/// How often rows are turned by a product.
const TURNS: usize = 12;

/// How far below the rate a rational bound is that takes the place of a root beyond the caps, and its grid.
const NEAR: f64 = 1e-9;
const NEAR_BITS: u32 = 60;

/// The excess of the rational bound beside an exact irrational radius.
const FINE: f64 = 1e-8;

/// An extremal hull.
pub(super) enum Exact {
    /// With rational rows, which prove the radius.
    Rational(Hull),
    /// With rows in the field of the radius.
    Irrational,
}

/// The lower bound.
pub(super) struct Lower<F = Rational> {
    pub(super) product: Vec<usize>,
    pub(super) root: RealAlgebraic,
    /// The coefficients of a polynomial that has this root; none where the root is only near an eigenvalue.
    polynomial: Vec<F>,
    pub(super) degree: usize,
    /// root^{1/degree} in f64.
    pub(super) rate: f64,
    /// Whether the root is the absolute value of a real eigenvalue.
    real: bool,
}

impl<F: Entry> Lower<F> {
    pub(super) fn of(set: &MatrixSet<F>, found: &Candidates) -> Option<Lower<F>> {
        let mut words = found.words.clone();
        words.sort_by_key(Vec::len);
        let bound = |word: &Vec<usize>, real: bool| {
            let Root { root, polynomial } =
                if real { largest_real(set, word)? } else { square_of_radius(set, word)? };
            let degree = if real { word.len() } else { 2 * word.len() };
            let rate = nearest(&root).powf(1.0 / float(degree));
            Some(Lower { product: word.clone(), root, polynomial, degree, rate, real })
        };
        let real = words.iter().find_map(|word| {
            bound(word, true).filter(|lower| lower.rate > found.rate * (1.0 - 1e-8))
        });
        // The polynomial of the products of two eigenvalues has a degree of half the square of the size.
        let conjugate = || (set.size() <= MAX_CONJUGATE).then(|| bound(words.first()?, false))?;
        // In f64 some eigenvalue of the shortest word has the rate.
        let near = || Lower::near(set, words.first()?, found.rate);
        real.or_else(conjugate)
            .or_else(near)
            .or_else(|| words.iter().find_map(|word| bound(word, true)))
            .or_else(|| words.iter().find_map(|word| Lower::near(set, word, found.rate)))
    }

    /// A rational number a little below the rate, if that is shown: where no root is found within the caps.
    fn near(set: &MatrixSet<F>, word: &[usize], rate: f64) -> Option<Lower<F>> {
        let length = i32::try_from(word.len()).ok()?;
        let value = on_grid(rate.powi(length) * (1.0 - NEAR), NEAR_BITS)?;
        let root = RealAlgebraic::from(value);
        let real = shown(set, word, &root, false)?.kind != LeadingEigenvalue::Modulus;
        let (product, degree) = (word.to_vec(), word.len());
        let rate = nearest(&root).powf(1.0 / float(degree));
        Some(Lower { product, root, polynomial: Vec::new(), degree, rate, real })
    }

    /// Whether an extremal hull of up to so many rows is found, and that hull where it is rational.
    pub(super) fn extremal(
        &self,
        set: &MatrixSet<F>,
        unit: &Rational,
        found: &Candidates,
        rows: usize,
    ) -> Option<Exact> {
        if !self.real || self.polynomial.is_empty() {
            return None;
        }
        let mut words = vec![self.product.clone()];
        words.extend(found.words.iter().filter(|word| **word != self.product).cloned());
        let few = &words[..words.len().min(FEW_WORDS)];
        let all = || (few.len() < words.len()).then(|| self.closed(set, unit, &words, rows))?;
        self.closed(set, unit, few, rows).or_else(all)
    }

    /// The same, with the eigenvectors of these words.
    fn closed(
        &self,
        set: &MatrixSet<F>,
        unit: &Rational,
        words: &[Vec<usize>],
        rows: usize,
    ) -> Option<Exact> {
        let caps = SearchCaps { rows, slack: 1e-10, work: MAX_WORK };
        let rational = self.root.as_rational().and_then(|root| rational_root(root, self.degree));
        if let (Some(set), Some(rate)) = (F::rational(set), rational) {
            let norm = Hull::norm(set);
            if norm.bound == rate {
                return Some(Exact::Rational(norm));
            }
            let rate = Rate::new(rate, 1);
            let extremal = Extremal::search(set, rate, unit, words, caps)?;
            return extremal.hull(set, unit).map(Exact::Rational);
        }
        if self.polynomial.len() > LONG_POLYNOMIAL && !self.closes(set, unit, words, caps) {
            return None;
        }
        let invariant = |polynomial: &[F], root: &RealAlgebraic, length| -> Option<()> {
            let (set, root) = F::with_root(set, polynomial, root)?;
            let rate = Rate::new(root, length);
            let extremal = Extremal::search(&set, rate, unit, words, caps)?;
            extremal.is_invariant(&set, unit).then_some(())
        };
        // Where rows of several powers of θ meet on the boundary, Q(α) does not decide, but Q(θ) does.
        let base = || (self.degree > 1).then(|| algebraic_root(&self.root, self.degree))?;
        invariant(&self.polynomial, &self.root, self.degree)
            .or_else(|| invariant(&stretched(&self.polynomial, self.degree), &base()?, 1))
            .map(|()| Exact::Irrational)
    }

    /// Whether the hull of f64 eigenvectors of these words is closed within the caps: what the exact search asks
    /// for as well, after it has found the eigenvectors in the field of the root, which takes long in a large one.
    fn closes(
        &self,
        set: &MatrixSet<F>,
        unit: &Rational,
        words: &[Vec<usize>],
        caps: SearchCaps,
    ) -> bool {
        let size = set.size();
        let tau = nearest(unit);
        let unit_row = |i: usize| (0..size).map(|j| if i == j { tau } else { 0.0 }).collect();
        let mut seeds: Vec<Vec<f64>> = (0..size).map(unit_row).collect();
        let mut known = Vec::new();
        for word in words.iter().filter(|word| word.len().is_multiple_of(self.degree)) {
            let start = seeds.len();
            seeds.extend(self.eigenvectors(set, word));
            let next = |i: usize| start + (i + 1) % word.len();
            if seeds.len() > start {
                known.extend(word.iter().enumerate().map(|(i, &by)| (start + i, by, next(i))));
            }
        }
        close(&self.scaled(set), seeds, &known, caps).is_some()
    }

    /// The hull with the least bound that is found; `better` is told of each that is better than those before.
    pub(super) fn nearest_hull(
        &self,
        set: &MatrixSet<F>,
        unit: &Rational,
        exact: bool,
        mut better: impl FnMut(&Hull),
    ) -> Hull {
        let seeds = self.seeds(set);
        let attempt =
            |excess| hull(set, set, &seeds, unit, (self.rate, excess), (MAX_ROWS, MAX_WORK));
        if let Some(hull) = exact.then(|| attempt(FINE)).flatten() {
            return hull;
        }
        let mut best = Hull::norm(set);
        for excess in EXCESSES {
            match attempt(excess) {
                Some(hull) if hull.bound < best.bound => {
                    better(&hull);
                    best = hull;
                }
                Some(_) => {}
                None => break,
            }
        }
        best
    }

    /// The left eigenvectors of the rotations of the leading product, or, of large matrices, rows that turn in a plane with it, where its leading eigenvalue
    /// is not real.
    pub(super) fn seeds(&self, set: &MatrixSet<F>) -> Vec<Vec<f64>> {
        match (self.real, set.size() > MAX_CONJUGATE) {
            (true, _) => self.eigenvectors(set, &self.product),
            (false, true) => self.eigenvectors(set, &self.product.repeat(TURNS)),
            (false, false) => Vec::new(),
        }
    }

    /// The left eigenvectors of the rotations of a product.
    fn eigenvectors(&self, set: &MatrixSet<F>, word: &[usize]) -> Vec<Vec<f64>> {
        eigenvectors(&self.scaled(set), word)
    }

    /// The matrices in f64, over the rate.
    fn scaled(&self, set: &MatrixSet<F>) -> Vec<Rows> {
        floats(set).into_iter().map(|matrix| scaled(matrix, 1.0 / self.rate)).collect()
    }
}

/// The left eigenvectors of the rotations of a product in f64, of which each is the one before it times a
/// factor: rows of a high power of the product. None where the power is 0. `matrices` are those over the rate.
pub(super) fn eigenvectors(matrices: &[Rows], word: &[usize]) -> Vec<Vec<f64>> {
    let mut row = vec![1.0; matrices.first().map_or(0, Vec::len)];
    for i in word.repeat(ROUNDS) {
        row = row_times(&row, &matrices[i]);
        let length: f64 = row.iter().map(|x| x.abs()).sum();
        if length == 0.0 {
            return Vec::new();
        }
        for x in &mut *row {
            *x /= length;
        }
    }
    let mut rows = Vec::new();
    for &i in word {
        let next = row_times(&row, &matrices[i]);
        rows.push(std::mem::replace(&mut row, next));
    }
    rows
}
