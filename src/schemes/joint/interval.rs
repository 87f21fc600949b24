//! Whether a radius is below 1, quickly: for many sets along an interval of a parameter.

use super::balance::{balance, changed};
use super::convert::{floats, scaled};
use super::hull::Hull;
use super::lower::eigenvectors;
use super::matrix_set::{Matrix, MatrixSet};
use super::product::{largest_real, square_of_radius};
use super::proposal::{beam, hull};
use crate::exact::{Rational, RealAlgebraic};
use crate::float::extremal::{Candidates, Rows, candidates, row_times};

/// The cost of the searches on whole intervals of a parameter.
const QUICK: (u32, usize) = (8, 40);

/// The most rows and the most work of a hull there.
const HULL: (usize, u64) = (400, 60_000_000);

/// The same for matrices in a basis of their own, which are larger and fewer.
pub(super) const LARGE_HULL: (usize, u64) = (1_000, 1_000_000_000);

/// How near to its beginning a cycle of eigenvectors ends. Its first row has the length 1.
const CLOSED: f64 = 1e-6;

/// How a hull for all matrices of an interval is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Closing {
    /// The one that these matrices generate.
    All,
    /// The one that the matrices in the middle generate. It has fewer rows where the radius is nearly 1, and is
    /// invariant under the others on short intervals.
    Middle,
}

/// Whether the radius of a set is shown to be below 1, by a hull for a bound below 1. The hull is that of the
/// cycle of a product that is large in `middle`, a set near the others.
///
/// `ends` are the sets at the ends of the interval, or at the corners of the box. Their rates stand for that of the
/// whole set, which has many products of nearly the same size: to find the largest of them takes longer than a hull,
/// and the bound that the hull is made for hardly depends on it.
#[must_use]
pub fn contracts(
    set: &MatrixSet,
    middle: &MatrixSet,
    ends: &[MatrixSet],
    closing: Closing,
) -> bool {
    contracting(set, middle, ends, closing, HULL).is_some()
}

/// A hull for a bound below 1, within so many rows and so much work.
pub(super) fn contracting(
    set: &MatrixSet,
    middle: &MatrixSet,
    ends: &[MatrixSet],
    closing: Closing,
    most: (usize, u64),
) -> Option<Hull> {
    let (factors, width) = QUICK;
    let found = candidates(&floats(middle), factors, beam(middle, width));
    if found.words.is_empty() {
        return Some(Hull::norm(set)).filter(Hull::contracts);
    }
    let rates = ends.iter().map(|end| candidates(&floats(end), factors, beam(end, width)).rate);
    let rate = rates.fold(found.rate, f64::max);
    if rate >= 1.0 - 1e-9 {
        return None;
    }
    let seeds = seeds(middle, &found);
    // Shorter unit rows would leave longer chains of images outside.
    let unit = Rational::one();
    let (near, rate) = match closing {
        Closing::All => (set, rate),
        Closing::Middle => (middle, found.rate),
    };
    let excess = 0.95 * (1.0 / rate - 1.0);
    hull(set, near, &seeds, &unit, (rate, excess), most).filter(Hull::contracts)
}

/// A hull in a basis of its own, which shows that a radius is below 1.
#[derive(Clone, Debug)]
pub struct BalancedHull {
    /// The basis, and its inverse; `None` where it is that of the matrices.
    pub basis: Option<[Matrix<Rational>; 2]>,
    /// The hull for a bound below 1.
    pub hull: Hull,
}

/// The same in a basis in which the matrices in the middle are about as large as their radius.
#[must_use]
pub fn hull_when_balanced(
    set: &MatrixSet,
    middle: &MatrixSet,
    ends: &[MatrixSet],
    closing: Closing,
) -> Option<BalancedHull> {
    let Some((basis, back)) = balance(middle) else {
        let hull = contracting(set, middle, ends, closing, LARGE_HULL)?;
        return Some(BalancedHull { basis: None, hull });
    };
    let changed = |set: &MatrixSet| changed(set, &basis, &back);
    let ends: Vec<MatrixSet> = ends.iter().map(changed).collect();
    let hull = contracting(&changed(set), &changed(middle), &ends, closing, LARGE_HULL)?;
    Some(BalancedHull { basis: Some([basis, back]), hull })
}

/// The cycle of eigenvectors of the first of these products whose largest eigenvalue is real, as far as f64 can tell:
/// only then a row of a high power of it is an eigenvector. None where there is no such product.
fn seeds(middle: &MatrixSet, found: &Candidates) -> Vec<Vec<f64>> {
    let scale = |matrix| scaled(matrix, 1.0 / found.rate);
    let matrices: Vec<Rows> = floats(middle).into_iter().map(scale).collect();
    let closed = |word: &Vec<usize>| {
        let rows = eigenvectors(&matrices, word);
        let (first, last) = (rows.first()?, rows.last()?);
        let next = row_times(last, &matrices[*word.last()?]);
        let differ = |sign: f64| first.iter().zip(&next).map(move |(x, y)| (x - sign * y).abs());
        let near = [1.0, -1.0].into_iter().any(|sign| differ(sign).sum::<f64>() < CLOSED);
        near.then_some(rows)
    };
    found.words.iter().find_map(closed).unwrap_or_default()
}

/// A product whose spectral radius is 1 or more as far as f64 can tell.
#[must_use]
pub fn expanding_product(set: &MatrixSet) -> Option<Vec<usize>> {
    let (factors, width) = QUICK;
    let found = candidates(&floats(set), factors, beam(set, width));
    let shortest = found.words.into_iter().min_by_key(Vec::len);
    shortest.filter(|_| found.rate >= 1.0)
}

/// Whether the spectral radius of a product is 1 or more, exactly.
#[must_use]
pub fn expands(set: &MatrixSet, word: &[usize]) -> bool {
    let reaches = |root: RealAlgebraic| root.cmp_rational(&Rational::one()).is_ge();
    largest_real(set, word).is_some_and(|found| reaches(found.root))
        || square_of_radius(set, word).is_some_and(|found| reaches(found.root))
}
