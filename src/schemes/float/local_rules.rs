//! The constants of a ring in f64, with their true errors and proven bounds of these
//! errors.

use super::apriori::Tracked;
use super::certify::MAX_TRACKED_STEPS;
use super::quantity::Quantity;
use crate::bound::{LocalConstants, LocalWork, displaced_rows, power_rows};
use crate::exact::{Rational, Real, RealCyclotomic};
use crate::machine::nearest;
use crate::scheme::{LocalRules, Representatives};

/// The constants of a ring in f64, compared with the exact constants.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalCertification {
    /// The weights of the representatives of the new points under the rotation, T_c, Λ_c
    /// and σ.
    pub quantities: Vec<Quantity<RealCyclotomic>>,
    /// The greatest c with a priori bounds.
    pub tracked_block: u32,
}

impl LocalCertification {
    /// The quantity of this name.
    #[must_use]
    pub fn quantity(&self, name: &str) -> Option<&Quantity<RealCyclotomic>> {
        self.quantities.iter().find(|quantity| quantity.name == name)
    }
}

/// Computes the constants of a ring in f64, exactly, and with a proven bound on the
/// error, for c = 1, …, `max_block`. The f64 path rounds the weights to nearest, computes
/// rows of M^c by repeated products, and from these rows Λ_c, T_c and σ.
///
/// In f64, each norm ‖w‖_* is computed as Σ_a w_a P_a, where the integer heights P attain
/// the norm of the exact w. The heights come from the exact path. So no decision depends
/// on rounded numbers, and [`Tracked`] applies.
///
/// # Errors
/// When the work for the powers of M is above
/// [`MAX_LOCAL_WORK`](crate::bound::MAX_LOCAL_WORK).
///
/// ```
/// use subcert::float::certify_local_rules;
/// use subcert::scheme::parse_local_rules;
///
/// let found = certify_local_rules(&parse_local_rules("doo-sabin:n=5")?, 2)?;
/// let t = found.quantity("T_1").unwrap();
/// assert_eq!(t.exact.to_string(), "9/20 + 3/10*cos(2*pi/5)");
/// assert_eq!(t.encloses(), Some(true));
/// assert!(t.bound.unwrap() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn certify_local_rules(
    ring: &LocalRules,
    max_block: u32,
) -> Result<LocalCertification, LocalWork> {
    let chosen = ring.representatives();
    let exact = LocalConstants::new(ring, max_block)?;
    let tracked_block = tracked_block(ring, &chosen, max_block);
    let float = Constants::along(&exact, &ring.map(nearest), &chosen, max_block);
    let tracked = ring.map(|weight| Tracked::nearest(weight.clone()));
    let tracked = Constants::along(&exact, &tracked, &chosen, tracked_block);
    let ideal = Constants::known(&exact, ring, &chosen);
    let names = |block| names(ring, &chosen, block);
    let bounds = names(tracked_block).into_iter().zip(tracked.listed());
    let bounds: std::collections::BTreeMap<String, f64> =
        bounds.map(|(name, tracked)| (name, tracked.error())).collect();
    let values = ideal.listed().into_iter().zip(float.listed());
    let quantities = names(max_block).into_iter().zip(values).map(|(name, (exact, value))| {
        let bound = bounds.get(&name).copied();
        Quantity::new(name, value, exact, bound)
    });
    Ok(LocalCertification { quantities: quantities.collect(), tracked_block })
}

/// The constants in some arithmetic.
struct Constants<S> {
    weights: Vec<S>,
    contraction: Vec<S>,
    norm: Vec<S>,
    sigma: S,
}

impl Constants<RealCyclotomic> {
    /// The constants from the exact path.
    fn known(
        exact: &LocalConstants,
        ring: &LocalRules,
        chosen: &Representatives,
    ) -> Constants<RealCyclotomic> {
        let contraction = exact.levels.iter().map(|level| level.contraction().1.value.clone());
        Constants {
            weights: weights(ring, chosen),
            contraction: contraction.collect(),
            norm: exact.levels.iter().map(|level| level.norm.clone()).collect(),
            sigma: exact.displacement().1.value.clone(),
        }
    }
}

impl<S: Real> Constants<S> {
    /// The constants of a ring in this arithmetic, with the heights of the exact path.
    fn along(
        exact: &LocalConstants,
        ring: &LocalRules<S>,
        chosen: &Representatives,
        blocks: u32,
    ) -> Constants<S> {
        let mut constants = Constants {
            weights: weights(ring, chosen),
            contraction: Vec::new(),
            norm: Vec::new(),
            sigma: S::zero(),
        };
        for (rows, level) in power_rows(ring, chosen, blocks).zip(&exact.levels) {
            let heights = level.differences.iter().map(|(_, found)| &found.heights[..]);
            constants.contraction.push(greatest(&rows.differences(chosen), heights));
            constants.norm.push(rows.norm(chosen));
        }
        let heights = exact.displacements.iter().map(|(_, found)| &found.heights[..]);
        constants.sigma = greatest(&displaced_rows(ring, chosen), heights);
        constants
    }

    fn listed(self) -> Vec<S> {
        let Constants { weights, contraction, norm, sigma } = self;
        weights.into_iter().chain(contraction).chain(norm).chain([sigma]).collect()
    }
}

/// The names of [`Constants::listed`].
fn names(ring: &LocalRules, chosen: &Representatives, blocks: u32) -> Vec<String> {
    let columns = 0..ring.point_count();
    let weights = chosen.points.iter().flat_map(|&a| {
        columns.clone().map(move |b| format!("m[{}][{}]", ring.name(a), ring.name(b)))
    });
    let constants = |symbol| (1..=blocks).map(move |c| format!("{symbol}_{c}"));
    let constants = constants("T").chain(constants("Lambda"));
    weights.chain(constants).chain(["sigma".to_owned()]).collect()
}

fn weights<S: Clone>(ring: &LocalRules<S>, chosen: &Representatives) -> Vec<S> {
    chosen.points.iter().flat_map(|&a| ring.weights().row(a).cloned()).collect()
}

/// The greatest Σ_b w_b P_b over the functionals w, each with its heights P.
fn greatest<'a, S: Real>(functionals: &[Vec<S>], heights: impl Iterator<Item = &'a [i64]>) -> S {
    let value = |(w, heights): (&Vec<S>, &[i64])| {
        w.iter().zip(heights).fold(S::zero(), |sum, (w, &height)| {
            sum.plus(&w.times(&S::from_rational(&Rational::from(height))))
        })
    };
    S::maximum(functionals.iter().zip(heights).map(value))
}

/// The greatest c ≤ `max_block` whose products stay within [`MAX_TRACKED_STEPS`].
fn tracked_block(ring: &LocalRules, chosen: &Representatives, max_block: u32) -> u32 {
    let rows = (chosen.points.len() + 2 * chosen.edges.len()) as u64;
    let steps = rows.saturating_mul(ring.product_count() as u64);
    (1..=max_block).take_while(|&c| steps * u64::from(c) <= MAX_TRACKED_STEPS).last().unwrap_or(0)
}
