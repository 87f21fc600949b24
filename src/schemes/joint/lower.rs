//! The bounds that start from a product of large spectral radius.

use super::convert::{float, floats, on_grid, scaled};
use super::entry::Entry;
use super::extremal::{Extremal, Rate};
use super::hull::Hull;
use super::matrix_set::MatrixSet;
use super::product::{Root, largest_real, shown, square_of_radius};
use super::proposal::hull;
use super::roots::{algebraic_root, rational_root};
use crate::exact::{Rational, RealAlgebraic};
use crate::float::extremal::{Candidates, SearchCaps, row_times};
use crate::float::nearest;

/// The largest matrices for which products of two conjugate eigenvalues are taken.
const MAX_CONJUGATE: usize = 8;

/// The most rows of a hull.
pub(super) const MAX_ROWS: usize = 1_200;

/// The most work of the search for a hull.
const MAX_WORK: u64 = 1_500_000_000;

/// The excesses of the bounds that are tried in turn when the radius is not found exactly.
const EXCESSES: [f64; 9] = [0.3, 0.1, 0.03, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7];

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
        real.or_else(conjugate)
            .or_else(|| words.iter().find_map(|word| bound(word, true)))
            .or_else(|| words.iter().find_map(|word| Lower::near(set, word, found.rate)))
    }

    /// A rational number a little below the rate, if a sign shows it: where no root is found within the caps.
    fn near(set: &MatrixSet<F>, word: &[usize], rate: f64) -> Option<Lower<F>> {
        let length = i32::try_from(word.len()).ok()?;
        let value = on_grid(rate.powi(length) * (1.0 - NEAR), NEAR_BITS)?;
        let root = RealAlgebraic::from(value);
        shown(set, word, &root, false)?;
        let (product, degree) = (word.to_vec(), word.len());
        let rate = nearest(&root).powf(1.0 / float(degree));
        Some(Lower { product, root, polynomial: Vec::new(), degree, rate, real: true })
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
        let caps = SearchCaps { rows, slack: 1e-10, work: MAX_WORK };
        let mut words = vec![self.product.clone()];
        words.extend(found.words.iter().filter(|word| **word != self.product).cloned());
        let rational = self.root.as_rational().and_then(|root| rational_root(root, self.degree));
        if let (Some(set), Some(rate)) = (F::rational(set), rational) {
            let norm = Hull::norm(set);
            if norm.bound == rate {
                return Some(Exact::Rational(norm));
            }
            let rate = Rate::new(rate, 1);
            let extremal = Extremal::search(set, rate, unit, &words, caps)?;
            return extremal.hull(set, unit).map(Exact::Rational);
        }
        let invariant = |polynomial: &[F], root: &RealAlgebraic, length| -> Option<()> {
            let (set, root) = F::with_root(set, polynomial, root)?;
            let rate = Rate::new(root, length);
            let extremal = Extremal::search(&set, rate, unit, &words, caps)?;
            extremal.is_invariant(&set, unit).then_some(())
        };
        // Where rows of several powers of θ meet on the boundary, Q(α) does not decide, but Q(θ) does.
        let base = || (self.degree > 1).then(|| algebraic_root(&self.root, self.degree))?;
        invariant(&self.polynomial, &self.root, self.degree)
            .or_else(|| invariant(&stretched(&self.polynomial, self.degree), &base()?, 1))
            .map(|()| Exact::Irrational)
    }

    /// The hull with the least bound that is found.
    pub(super) fn nearest_hull(&self, set: &MatrixSet<F>, unit: &Rational, exact: bool) -> Hull {
        let seeds = self.seeds(set);
        let attempt = |excess| hull(set, &seeds, unit, (self.rate, excess), (MAX_ROWS, MAX_WORK));
        if let Some(hull) = exact.then(|| attempt(FINE)).flatten() {
            return hull;
        }
        let mut best = Hull::norm(set);
        for excess in EXCESSES {
            match attempt(excess) {
                Some(hull) if hull.bound < best.bound => best = hull,
                Some(_) => {}
                None => break,
            }
        }
        best
    }

    /// The cycle of left eigenvectors in f64: rows of a high power of the product.
    pub(super) fn seeds(&self, set: &MatrixSet<F>) -> Vec<Vec<f64>> {
        let matrices: Vec<_> =
            floats(set).into_iter().map(|matrix| scaled(matrix, 1.0 / self.rate)).collect();
        let mut rows = Vec::new();
        let mut row = vec![1.0; set.size()];
        for round in 0..200 {
            for &i in &self.product {
                row = row_times(&row, &matrices[i]);
                let length: f64 = row.iter().map(|x| x.abs()).sum();
                if length == 0.0 {
                    return Vec::new();
                }
                for x in &mut row {
                    *x /= length;
                }
                if round == 199 {
                    rows.push(row.clone());
                }
            }
        }
        if self.real { rows } else { Vec::new() }
    }
}

/// p(x^degree).
fn stretched<F: Entry>(p: &[F], degree: usize) -> Vec<F> {
    let mut stretched = Vec::new();
    for c in p {
        stretched.resize(stretched.len().next_multiple_of(degree), F::zero());
        stretched.push(c.clone());
    }
    stretched
}
