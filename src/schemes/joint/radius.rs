//! Both bounds of the joint spectral radius.

use super::convert::floats;
use super::entry::Entry;
use super::hull::Hull;
use super::lower::{Exact, Lower, MAX_ROWS};
use super::matrix_set::{MAX_SIZE, MatrixSet};
use super::product::{Eigenvalue, shown};
use super::proposal::beam;
use super::reduction::Reduction;
use super::roots::{enclosed_root, order};
use super::single::of_multiples;
use crate::exact::{Enclosure, Rational, RealAlgebraic};
use crate::float::extremal::candidates;
use crate::stop::{Stop, Stopped};
use std::cmp::Ordering;

/// The most factors of a product that is looked at.
pub const MAX_FACTORS: u32 = 14;

/// How many products of each length are continued.
pub(super) const BEAM: usize = 250;

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
    /// Whether ϱ = root^{1/degree}: by an extremal hull, or as the largest of the blocks, or the spectral radius of
    /// one matrix, of which the others are multiples.
    pub exact: bool,
    /// Whether ϱ is exact, and all products of l factors are shown to be at most Cϱ^l.
    pub bounded: bool,
    /// ϱ ≤ its bound; `None` where all products of d factors are 0. It is one of the blocks, if the set is reduced.
    pub hull: Option<Hull>,
    /// The blocks, where the bounds are theirs.
    pub reduction: Option<Reduction>,
    /// Whether the search was stopped, so that the bounds are those which it had found.
    pub stopped: bool,
}

impl JointRadius {
    /// A rational lower bound that a sign shows; `None` where ϱ = 0, or no sign shows it.
    #[must_use]
    pub fn eigenvalue<F: Entry>(&self, set: &MatrixSet<F>) -> Option<Eigenvalue> {
        let conjugate = self.degree != self.product.len();
        match &self.reduction {
            None => shown(set, &self.product, &self.root, conjugate),
            Some(reduction) => reduction
                .blocks
                .iter()
                .find_map(|block| shown(block, &self.product, &self.root, conjugate)),
        }
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
        enclosed_root(&self.root, self.degree)
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
/// Where no extremal hull is found, rational matrices are reduced to blocks. Where there are none, and the matrices are no
/// multiples of one, the bounds are as near as the search comes within [`MAX_ROWS`] rows.
///
/// # Panics
/// Never.
#[must_use]
pub fn joint_radius<F: Entry>(set: &MatrixSet<F>) -> JointRadius {
    searched(set, &mut by_norm(set))
}

/// The same, with the bounds that are found until the search is stopped: from above at least the largest row sum.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::joint::{MatrixSet, joint_radius_until};
/// use subcert::stop::Stop;
///
/// let set = MatrixSet::new(vec![vec![vec![Rational::from(2), Rational::one()], vec![Rational::zero(), Rational::one()]]])?;
/// let stop = Stop::default();
/// assert!(joint_radius_until(&set, &stop).exact);
/// stop.stop();
/// let bounds = joint_radius_until(&set, &stop);
/// assert_eq!((bounds.stopped, bounds.exact, bounds.upper()), (true, false, Rational::from(3)));
/// # Ok::<(), subcert::joint::MatrixSetError>(())
/// ```
///
/// # Panics
/// Never.
#[must_use]
pub fn joint_radius_until<F: Entry>(set: &MatrixSet<F>, stop: &Stop) -> JointRadius {
    let mut best = by_norm(set);
    match stop.run(|| searched(set, &mut best)) {
        Ok(found) => found,
        Err(Stopped) => JointRadius { stopped: true, ..best },
    }
}

/// The same, with rational matrices reduced to blocks before anything else is looked for.
#[must_use]
pub fn radius_of_blocks(set: &MatrixSet, stop: &Stop) -> JointRadius {
    let best = by_norm(set);
    let radius = || match Reduction::fine(set) {
        Some(reduction) => of_blocks(reduction.balanced()),
        None if set.size() > MAX_SIZE => by_norm(set),
        None => joint_radius(set),
    };
    stop.run(radius).unwrap_or(JointRadius { stopped: true, ..best })
}

/// The bounds of a set. `best` has what is known of them while they are looked for.
fn searched<F: Entry>(set: &MatrixSet<F>, best: &mut JointRadius) -> JointRadius {
    if set.is_nilpotent() {
        let root = RealAlgebraic::from(Rational::zero());
        return JointRadius {
            product: Vec::new(),
            root,
            degree: 1,
            exact: true,
            bounded: true,
            hull: None,
            reduction: None,
            stopped: false,
        };
    }
    let matrices = floats(set);
    let found = candidates(&matrices, MAX_FACTORS, beam(set, BEAM));
    let lower = Lower::of(set, &found);
    if let Some(Lower { product, root, degree, .. }) = &lower {
        (best.product, best.root, best.degree) = (product.clone(), root.clone(), *degree);
    }
    let unit = Rational::new(1, 16);
    let extremal = lower.as_ref().and_then(|lower| lower.extremal(set, &unit, &found, MAX_ROWS));
    let exact = extremal.is_some();
    if !exact && let Some(reduction) = F::rational(set).and_then(Reduction::of) {
        return of_blocks(reduction);
    }
    let Some(lower) = lower else { return by_norm(set) };
    let hull = match extremal {
        Some(Exact::Rational(hull)) => hull,
        _ => lower.nearest_hull(set, &unit, exact, |hull| best.hull = Some(hull.clone())),
    };
    let Lower { product, root, degree, .. } = lower;
    let meet = root.cmp_rational(&hull.bound.pow(power(degree))).is_eq();
    let (exact, hull) = (exact || meet, Some(hull));
    let radius = JointRadius {
        product,
        root,
        degree,
        exact,
        bounded: exact,
        hull,
        reduction: None,
        stopped: false,
    };
    match of_multiples(set).filter(|_| !exact) {
        Some((product, root, degree)) => {
            JointRadius { product, root, degree, exact: true, ..radius }
        }
        None => radius,
    }
}

pub(super) fn power(degree: usize) -> i32 {
    i32::try_from(degree).expect("a short product")
}

/// The maximum of the radii of the blocks.
fn of_blocks(reduction: Reduction) -> JointRadius {
    let of = |block: &MatrixSet| {
        if block.size() > MAX_SIZE { by_norm(block) } else { joint_radius(block) }
    };
    let radii: Vec<JointRadius> = reduction.blocks.iter().map(of).collect();
    let compared =
        |a: &JointRadius, b: &JointRadius| order((&a.root, a.degree), (&b.root, b.degree));
    let greater = |best: usize, i: usize| {
        if compared(&radii[i], &radii[best]) == Some(Ordering::Greater) { i } else { best }
    };
    let lead = (1..radii.len()).fold(0, greater);
    let best = &radii[lead];
    let limit =
        |other: &JointRadius| best.root.cmp_rational(&other.upper().pow(power(best.degree)));
    let others = || radii.iter().enumerate().filter(|(i, _)| *i != lead).map(|(_, other)| other);
    let at_most = |other: &JointRadius| {
        limit(other).is_ge() || other.exact && compared(other, best).is_some_and(Ordering::is_le)
    };
    let exact = best.exact && others().all(at_most);
    // The blocks beside the diagonal are then multiplied by sums of geometric series.
    let bounded = exact && best.bounded && others().all(|other| limit(other).is_gt());
    let hulls = reduction.blocks.iter().zip(&radii);
    let hulls =
        hulls.map(|(block, radius)| radius.hull.clone().unwrap_or_else(|| Hull::norm(block)));
    let hulls: Vec<Hull> = hulls.collect();
    let hull = Some(reduction.hull(&hulls.iter().collect::<Vec<_>>()));
    let (product, root, degree) = (best.product.clone(), best.root.clone(), best.degree);
    let reduction = Some(reduction);
    JointRadius { product, root, degree, exact, bounded, hull, reduction, stopped: false }
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

/// What is known before any search, or when f64 finds no product with an eigenvalue other than 0.
pub(super) fn by_norm<F: Entry>(set: &MatrixSet<F>) -> JointRadius {
    let (product, root) = (vec![0], RealAlgebraic::from(Rational::zero()));
    let (degree, hull, reduction) = (1, Some(Hull::norm(set)), None);
    let (exact, bounded, stopped) = (false, false, false);
    JointRadius { product, root, degree, exact, bounded, hull, reduction, stopped }
}
