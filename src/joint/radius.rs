//! Both bounds of the joint spectral radius.

use super::extremal::{Extremal, Rate, scaled};
use super::hull::Hull;
use super::matrix_set::MatrixSet;
use super::product::{Eigenvalue, largest_real, shown, square_of_radius};
use super::proposal::{floats, hull};
use crate::exact::{
    Enclosed as _, FieldElement, Integer, IntegerPolynomial, Rational, RealAlgebraic,
};
use crate::float::extremal::{Candidates, SearchCaps, candidates, row_times};
use crate::float::nearest;

/// The most factors of a product that is looked at.
const MAX_FACTORS: u32 = 14;

/// How many products of each length are continued.
const BEAM: usize = 250;

/// The most work of the search for products: their number, times the cube of the size.
const MAX_PRODUCTS: usize = 60_000_000;

/// The most rows of a hull.
const MAX_ROWS: usize = 1_200;

/// The most work of the search for a hull.
const MAX_WORK: u64 = 1_500_000_000;

/// The largest matrices for which products of two conjugate eigenvalues are taken.
const MAX_CONJUGATE: usize = 8;

/// The greatest degree of the field in which a hull is verified.
const MAX_DEGREE: usize = 12;

/// The excesses of the bounds that are tried in turn when the radius is not found exactly.
const EXCESSES: [f64; 8] = [0.3, 0.1, 0.03, 1e-2, 1e-3, 1e-4, 1e-5, 1e-7];

/// The excess of the rational bound beside an exact irrational radius.
const FINE: f64 = 1e-8;

/// The joint spectral radius ϱ of a set of matrices, from both sides.
#[derive(Clone, Debug)]
pub struct JointRadius {
    /// The factors of a product, in the order of multiplication, counted from 0; none where ϱ = 0.
    pub product: Vec<usize>,
    /// ϱ ≥ root^{1/degree}.
    pub root: RealAlgebraic,
    /// The number of the factors; twice that where `root` is the product of two conjugate eigenvalues.
    pub degree: usize,
    /// Whether ϱ = root^{1/degree}, by an extremal hull; all products of l factors are then at most
    /// Cϱ^l. Where the bounds meet, both is proven.
    pub exact: bool,
    /// ϱ ≤ its bound; `None` where all products of d factors are 0.
    pub hull: Option<Hull>,
}

impl JointRadius {
    /// A rational lower bound that a sign shows; `None` where ϱ = 0, or no sign shows it.
    #[must_use]
    pub fn eigenvalue(&self, set: &MatrixSet) -> Option<Eigenvalue> {
        shown(set, &self.product, &self.root, self.degree != self.product.len())
    }
}

/// Bounds the joint spectral radius of a set of matrices.
///
/// Where no extremal hull is found, the bounds are as near as the search comes within 1200 rows.
///
/// # Panics
/// Never.
#[must_use]
pub fn joint_radius(set: &MatrixSet) -> JointRadius {
    if set.is_nilpotent() {
        let root = RealAlgebraic::from(Rational::zero());
        return JointRadius { product: Vec::new(), root, degree: 1, exact: true, hull: None };
    }
    let matrices = floats(set);
    let found = candidates(&matrices, MAX_FACTORS, beam(set, BEAM));
    let Some(lower) = Lower::of(set, &found) else { return by_norm(set) };
    let unit = Rational::new(1, 16);
    let extremal = lower.extremal(set, &unit, &found);
    let exact = extremal.is_some();
    let upper = match extremal {
        Some(Some(hull)) => hull,
        _ => lower.nearest_hull(set, &unit, exact),
    };
    let Lower { product, root, degree, .. } = lower;
    JointRadius { product, root, degree, exact, hull: Some(upper) }
}

/// How many products of each length are continued, within the work.
fn beam(set: &MatrixSet, most: usize) -> usize {
    let each = set.matrices().len() * set.size().pow(3);
    (MAX_PRODUCTS / each / 14).clamp(4, most)
}

/// Whether the radius is that of a product, by an extremal hull; then all products of l factors are at most
/// Cϱ^l. `None` where none is found.
#[must_use]
pub fn extremal_rate(set: &MatrixSet) -> Option<(RealAlgebraic, usize)> {
    let found = candidates(&floats(set), MAX_FACTORS, beam(set, BEAM));
    let lower = Lower::of(set, &found)?;
    lower.extremal(set, &Rational::new(1, 16), &found)?;
    Some((lower.root, lower.degree))
}

/// The cost of the searches on whole intervals of a parameter.
const QUICK: (u32, usize, usize) = (8, 40, 400);

/// The most work of a hull there.
const QUICK_WORK: u64 = 60_000_000;

/// Whether the radius of a set is shown to be below 1, by a hull for a bound below 1. The hull is that of the
/// cycle of a product that is large in `middle`, a set near the others.
#[must_use]
pub fn contracts(set: &MatrixSet, middle: &MatrixSet) -> bool {
    let (factors, width, rows) = QUICK;
    let found = candidates(&floats(middle), factors, beam(middle, width));
    let Some(lower) = Lower::of(middle, &found) else {
        return Hull::norm(set).bound < Rational::one();
    };
    // The radius of the whole set is larger than that in the middle; f64 tells by how much at least.
    let rate = candidates(&floats(set), factors, beam(set, width)).rate.max(lower.rate);
    if rate >= 1.0 - 1e-9 {
        return false;
    }
    let excess = 0.95 * (1.0 / rate - 1.0);
    let seeds = lower.seeds(middle);
    let unit = Rational::new(1, 16);
    let hull = hull(set, &seeds, &unit, (rate, excess), (rows, QUICK_WORK));
    hull.is_some_and(|hull| hull.bound < Rational::one())
}

/// A product whose spectral radius is 1 or more as far as f64 can tell.
#[must_use]
pub fn expanding_product(set: &MatrixSet) -> Option<Vec<usize>> {
    let (factors, width, _) = QUICK;
    let found = candidates(&floats(set), factors, beam(set, width));
    let shortest = found.words.into_iter().min_by_key(Vec::len);
    shortest.filter(|_| found.rate >= 1.0)
}

/// What is known when f64 finds no product with an eigenvalue other than 0.
fn by_norm(set: &MatrixSet) -> JointRadius {
    let root = RealAlgebraic::from(Rational::zero());
    let hull = Some(Hull::norm(set));
    JointRadius { product: vec![0], root, degree: 1, exact: false, hull }
}

/// The lower bound.
struct Lower {
    product: Vec<usize>,
    root: RealAlgebraic,
    degree: usize,
    /// root^{1/degree} in f64.
    rate: f64,
    /// Whether the root is the absolute value of a real eigenvalue.
    real: bool,
}

impl Lower {
    fn of(set: &MatrixSet, found: &Candidates) -> Option<Lower> {
        let mut words = found.words.clone();
        words.sort_by_key(Vec::len);
        let bound = |word: &Vec<usize>, real: bool| {
            let root = if real { largest_real(set, word)? } else { square_of_radius(set, word)? };
            let degree = if real { word.len() } else { 2 * word.len() };
            let rate = nearest(&root).powf(1.0 / super::extremal::float(degree));
            Some(Lower { product: word.clone(), root, degree, rate, real })
        };
        let real = words.iter().find_map(|word| {
            bound(word, true).filter(|lower| lower.rate > found.rate * (1.0 - 1e-8))
        });
        // The polynomial of the products of two eigenvalues has a degree of half the square of the size.
        let conjugate = || (set.size() <= MAX_CONJUGATE).then(|| bound(words.first()?, false))?;
        real.or_else(conjugate).or_else(|| words.iter().find_map(|word| bound(word, true)))
    }

    /// Whether an extremal hull exists, and that hull where it is rational.
    fn extremal(
        &self,
        set: &MatrixSet,
        unit: &Rational,
        found: &Candidates,
    ) -> Option<Option<Hull>> {
        if !self.real {
            return None;
        }
        let caps = SearchCaps { rows: MAX_ROWS, slack: 1e-10, work: MAX_WORK };
        let mut words = vec![self.product.clone()];
        words.extend(found.words.iter().filter(|word| **word != self.product).cloned());
        let rational = self.root.as_rational();
        if let Some(rate) = rational.and_then(|root| rational_root(root, self.degree)) {
            let norm = Hull::norm(set);
            if norm.bound == rate {
                return Some(Some(norm));
            }
            let rate = Rate::new(rate, 1);
            let extremal = Extremal::search(set, rate, unit, &words, caps)?;
            return extremal.hull(set, unit).map(Some);
        }
        let invariant = |root: &RealAlgebraic, length| -> Option<()> {
            if root.minimal_polynomial()?.degree()? > MAX_DEGREE {
                return None;
            }
            let rate = Rate::new(FieldElement::generator(root)?, length);
            let extremal = Extremal::search(set, rate, unit, &words, caps)?;
            extremal.is_invariant(set, unit).then_some(())
        };
        // Where rows of several powers of θ meet on the boundary, Q(α) does not decide, but Q(θ) does.
        let base = || (self.degree > 1).then(|| algebraic_root(&self.root, self.degree))?;
        invariant(&self.root, self.degree).or_else(|| invariant(&base()?, 1)).map(|()| None)
    }

    /// The hull with the least bound that is found.
    fn nearest_hull(&self, set: &MatrixSet, unit: &Rational, exact: bool) -> Hull {
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
    fn seeds(&self, set: &MatrixSet) -> Vec<Vec<f64>> {
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
                row.iter_mut().for_each(|x| *x /= length);
                if round == 199 {
                    rows.push(row.clone());
                }
            }
        }
        if self.real { rows } else { Vec::new() }
    }
}

/// The rational number q ≥ 0 with q^degree = x, if there is one.
pub(crate) fn rational_root(x: &Rational, degree: usize) -> Option<Rational> {
    let degree = u32::try_from(degree).ok()?;
    Some(Rational::new(root(&x.numerator(), degree)?, root(&x.denominator(), degree)?))
}

/// The positive θ with θ^degree = x, as a root of f(z^degree), f a polynomial of x.
fn algebraic_root(x: &RealAlgebraic, degree: usize) -> Option<RealAlgebraic> {
    let mut stretched = Vec::new();
    for c in x.polynomial().coefficients() {
        stretched.resize(stretched.len().next_multiple_of(degree), Integer::zero());
        stretched.push(c.clone());
    }
    let power = i32::try_from(degree).ok()?;
    // The power of a root is a root of f, and x is the only one of these in its interval.
    let is_root = |theta: &RealAlgebraic| {
        let enclosure = theta.enclosure(1);
        let (low, high) = (enclosure.lower().pow(power), enclosure.upper().pow(power));
        let (least, greatest) = x.bounds();
        let inside = least <= low && high <= greatest;
        let rational = x.as_rational().is_some_and(|x| low <= *x && *x <= high);
        theta.sign() > 0 && (inside || rational)
    };
    RealAlgebraic::roots_of(&IntegerPolynomial::new(stretched)).into_iter().find(is_root)
}

fn root(x: &Integer, degree: u32) -> Option<Integer> {
    let bits = u32::try_from(x.bits()).ok()?;
    let (mut low, mut high) = (Integer::zero(), Integer::one().shifted_left(bits / degree + 1));
    // low^degree ≤ x < high^degree.
    while &high - &low > Integer::one() {
        let middle = (&low + &high).shifted_right(1);
        if middle.pow(degree) <= *x { low = middle } else { high = middle }
    }
    (low.pow(degree) == *x).then_some(low)
}
