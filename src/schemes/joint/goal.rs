//! Hulls that show that a radius is below a given number.

use super::convert::floats;
use super::hull::Hull;
use super::interval::{Closing, LARGE_HULL, contracting};
use super::lower::Lower;
use super::matrix_set::{Matrix, MatrixSet};
use super::proposal::beam;
use super::radius::{BEAM, JointRadius, MAX_FACTORS, by_norm, joint_radius_until, power};
use super::reduction::Reduction;
use crate::exact::Rational;
use crate::float::extremal::candidates;
use crate::stop::Stop;

/// Bounds of a joint spectral radius where it matters whether it is below `goal`: if a hull is found for a bound below it, the bounds are those of this
/// hull and of a product, and no nearer ones are looked for. Otherwise they are those of [`joint_radius_until`].
///
/// Such a hull has room between the radius and the goal, and so fewer rows than one that is near the radius.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::joint::{MatrixSet, joint_radius_below};
/// use subcert::stop::Stop;
///
/// let matrix = |rows: [[i64; 2]; 2]| rows.map(|row| row.map(Rational::from).to_vec()).to_vec();
/// let set = MatrixSet::new(vec![matrix([[1, 1], [0, 1]]), matrix([[1, 0], [1, 1]])])?;
/// // The radius is the golden ratio, 1.618….
/// let goal = Rational::new(17, 10);
/// let found = joint_radius_below(&set, &goal, &Stop::default());
/// assert_eq!(found.is_below(&goal), Some(true));
/// let low = Rational::new(8, 5);
/// assert_eq!(joint_radius_below(&set, &low, &Stop::default()).is_below(&low), Some(false));
/// # Ok::<(), subcert::joint::MatrixSetError>(())
/// ```
///
/// # Panics
/// Never.
#[must_use]
pub fn joint_radius_below(set: &MatrixSet, goal: &Rational, stop: &Stop) -> JointRadius {
    let quick = || {
        if set.is_nilpotent() {
            return None;
        }
        let reduction = parts(set);
        let hull = hull_below(&reduction, goal)?;
        let bounds = at_least(set);
        Some(JointRadius { hull: Some(hull), reduction: Some(reduction), ..bounds })
    };
    match stop.run(quick) {
        Ok(Some(found)) => found,
        _ => joint_radius_until(set, stop),
    }
}

impl JointRadius {
    /// Whether ϱ < goal; `None` where the bounds do not tell.
    ///
    /// # Panics
    /// Never: products are short.
    #[must_use]
    pub fn is_below(&self, goal: &Rational) -> Option<bool> {
        if self.hull.as_ref().is_none_or(|hull| hull.bound < *goal) {
            return Some(goal.sign() > 0);
        }
        if goal.sign() <= 0 || self.root.cmp_rational(&goal.pow(power(self.degree))).is_ge() {
            return Some(false);
        }
        // The root is below the goal, and ϱ is the root.
        self.exact.then_some(true)
    }

    /// These bounds of a set, with another hull for each of the goals for which they do not tell whether ϱ is below it, and that hull shows it.
    #[must_use]
    pub fn toward(mut self, set: &MatrixSet, goals: &[Rational], stop: &Stop) -> JointRadius {
        let mut known = None;
        for goal in goals {
            if self.is_below(goal).is_some() {
                continue;
            }
            let found = stop.run(|| {
                let reduction = known.get_or_insert_with(|| parts(set));
                Some((hull_below(reduction, goal)?, reduction.clone()))
            });
            if let Ok(Some((hull, reduction))) = found {
                self = JointRadius { hull: Some(hull), reduction: Some(reduction), ..self };
            }
        }
        self
    }
}

/// The blocks of a set, each in a basis of its own.
fn parts(set: &MatrixSet) -> Reduction {
    Reduction::fine(set).unwrap_or_else(|| Reduction::whole(set)).balanced()
}

/// A hull for a bound below the goal, of the blocks.
fn hull_below(reduction: &Reduction, goal: &Rational) -> Option<Hull> {
    if goal.sign() <= 0 {
        return None;
    }
    let over = |matrix: &Matrix<Rational>| -> Matrix<Rational> {
        matrix.iter().map(|row| row.iter().map(|x| x / goal).collect()).collect()
    };
    let of_block = |block: &MatrixSet| {
        let scaled = block.part(&over);
        let ends = [scaled.clone()];
        let hull = contracting(&scaled, &scaled, &ends, Closing::All, LARGE_HULL)?;
        Some(hull.times(goal))
    };
    let hulls: Vec<Hull> = reduction.blocks.iter().map(of_block).collect::<Option<_>>()?;
    Some(reduction.hull(&hulls.iter().collect::<Vec<_>>()))
}

/// A lower bound, and the largest row sum.
fn at_least(set: &MatrixSet) -> JointRadius {
    let found = candidates(&floats(set), MAX_FACTORS, beam(set, BEAM));
    match Lower::of(set, &found) {
        Some(Lower { product, root, degree, .. }) => {
            JointRadius { product, root, degree, ..by_norm(set) }
        }
        None => by_norm(set),
    }
}
