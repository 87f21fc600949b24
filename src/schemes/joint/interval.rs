//! Whether a radius is below 1, quickly: for many sets along an interval of a parameter.

use super::convert::floats;
use super::hull::Hull;
use super::lower::Lower;
use super::matrix_set::MatrixSet;
use super::product::{largest_real, square_of_radius};
use super::proposal::{beam, hull};
use crate::exact::{Rational, RealAlgebraic};
use crate::float::extremal::candidates;

/// The cost of the searches on whole intervals of a parameter.
const QUICK: (u32, usize, usize) = (8, 40, 400);

/// The most work of a hull there.
const QUICK_WORK: u64 = 60_000_000;

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
#[must_use]
pub fn contracts(set: &MatrixSet, middle: &MatrixSet, closing: Closing) -> bool {
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
    let seeds = lower.seeds(middle);
    // Shorter unit rows would leave longer chains of images outside.
    let unit = Rational::one();
    let (near, rate) = match closing {
        Closing::All => (set, rate),
        Closing::Middle => (middle, lower.rate),
    };
    let excess = 0.95 * (1.0 / rate - 1.0);
    let hull = hull(set, near, &seeds, &unit, (rate, excess), (rows, QUICK_WORK));
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

/// Whether the spectral radius of a product is 1 or more, exactly.
#[must_use]
pub fn expands(set: &MatrixSet, word: &[usize]) -> bool {
    let reaches = |root: RealAlgebraic| root.cmp_rational(&Rational::one()).is_ge();
    largest_real(set, word).is_some_and(|found| reaches(found.root))
        || square_of_radius(set, word).is_some_and(|found| reaches(found.root))
}
