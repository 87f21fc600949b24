//! Both bounds of the joint spectral radius.

use super::convert::floats;
use super::entry::Entry;
use super::hull::Hull;
use super::lower::{Exact, Lower, MAX_ROWS};
use super::matrix_set::MatrixSet;
use super::product::{Eigenvalue, shown};
use super::proposal::beam;
use super::roots::greatest;
use crate::exact::{Enclosure, Integer, Rational, RealAlgebraic};
use crate::float::extremal::candidates;

/// The most factors of a product that is looked at.
const MAX_FACTORS: u32 = 14;

/// The digits after the point of an enclosure of a root.
const PLACES: u32 = 14;

/// How many products of each length are continued.
const BEAM: usize = 250;

/// The most rows of a hull where only its existence is asked for.
const FEW_ROWS: usize = 300;

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
    pub fn eigenvalue<F: Entry>(&self, set: &MatrixSet<F>) -> Option<Eigenvalue> {
        shown(set, &self.product, &self.root, self.degree != self.product.len())
    }

    /// An enclosure of root^{1/degree} of two neighbouring decimals of 14 places, or the number itself.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::joint::{MatrixSet, joint_radius};
    ///
    /// let set = MatrixSet::new(vec![vec![vec![Rational::new(1, 2)]]])?;
    /// assert_eq!(*joint_radius(&set).root_enclosure().lower(), Rational::new(1, 2));
    /// assert_eq!(joint_radius(&set).upper(), Rational::new(1, 2));
    /// # Ok::<(), subcert::joint::MatrixSetError>(())
    /// ```
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn root_enclosure(&self) -> Enclosure {
        let degree = i32::try_from(self.degree).expect("a short product");
        let unit = Rational::from(Integer::power_of_ten(PLACES));
        let reaches = |x: &Integer| {
            let power = (Rational::from(x.clone()) / &unit).pow(degree);
            self.root.cmp_rational(&power) != std::cmp::Ordering::Less
        };
        let low = greatest(reaches);
        let exact = (Rational::from(low.clone()) / &unit).pow(degree);
        let is_root = self.root.cmp_rational(&exact).is_eq();
        let high = if is_root { low.clone() } else { &low + &Integer::one() };
        Enclosure::new(Rational::from(low) / &unit, Rational::from(high) / unit)
    }

    /// The best rational upper bound of the radius.
    #[must_use]
    pub fn upper(&self) -> Rational {
        let exact = self.exact.then(|| self.root_enclosure().upper().clone());
        let hull = self.hull.as_ref().map(|hull| hull.bound.clone());
        exact.into_iter().chain(hull).min().unwrap_or_else(Rational::zero)
    }
}

/// Bounds the joint spectral radius of a set of matrices.
///
/// Where no extremal hull is found, the bounds are as near as the search comes within 1200 rows.
///
/// # Panics
/// Never.
#[must_use]
pub fn joint_radius<F: Entry>(set: &MatrixSet<F>) -> JointRadius {
    if set.is_nilpotent() {
        let root = RealAlgebraic::from(Rational::zero());
        return JointRadius { product: Vec::new(), root, degree: 1, exact: true, hull: None };
    }
    let matrices = floats(set);
    let found = candidates(&matrices, MAX_FACTORS, beam(set, BEAM));
    let Some(lower) = Lower::of(set, &found) else { return by_norm(set) };
    let unit = Rational::new(1, 16);
    let extremal = lower.extremal(set, &unit, &found, MAX_ROWS);
    let exact = extremal.is_some();
    let upper = match extremal {
        Some(Exact::Rational(hull)) => hull,
        _ => lower.nearest_hull(set, &unit, exact),
    };
    let Lower { product, root, degree, .. } = lower;
    JointRadius { product, root, degree, exact, hull: Some(upper) }
}

/// Whether the radius is that of a product, by an extremal hull; then all products of l factors are at most
/// Cϱ^l. `None` where none of up to 300 rows is found.
#[must_use]
pub fn extremal_rate<F: Entry>(set: &MatrixSet<F>) -> Option<(RealAlgebraic, usize)> {
    let found = candidates(&floats(set), MAX_FACTORS, beam(set, BEAM));
    let lower = Lower::of(set, &found)?;
    lower.extremal(set, &Rational::new(1, 16), &found, FEW_ROWS)?;
    Some((lower.root, lower.degree))
}

/// What is known when f64 finds no product with an eigenvalue other than 0.
fn by_norm<F: Entry>(set: &MatrixSet<F>) -> JointRadius {
    let root = RealAlgebraic::from(Rational::zero());
    let hull = Some(Hull::norm(set));
    JointRadius { product: vec![0], root, degree: 1, exact: false, hull }
}
