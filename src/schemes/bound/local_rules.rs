//! The constants of a ring: T_c, Λ_c and σ.

use super::local_power::{LocalWork, PowerRows, displaced_rows};
use super::transport::{Transport, transport};
use crate::exact::{Real, RealCyclotomic};
use crate::formula::Value;
use crate::scheme::LocalRules;

/// T_c and Λ_c of a ring.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalLevel<S = RealCyclotomic> {
    /// ‖e_aᵀM^c − e_bᵀM^c‖_* for the edges (a, b).
    pub differences: Vec<((usize, usize), Transport<S>)>,
    /// Λ_c = max_a Σ_b |(M^c)_{a,b}|.
    pub norm: S,
}

/// The constants of a ring `x'_a = Σ_b m_{a,b} x_b` with β = max |x_a − x_b| over the edges
/// (a, b) of its mesh:
///
/// - T_c = max over the edges of ‖e_aᵀM^c − e_bᵀM^c‖_*, the least number such that β is
///   at most T_c β after c refinements;
/// - Λ_c = max_a Σ_b |(M^c)_{a,b}|, the least number such that max |x_a| grows at most by
///   the factor Λ_c in c refinements;
/// - σ = max_a ‖e_aᵀ(M − I)‖_*, the least number such that every new point x'_a is within
///   σβ of the old point x_a of the same name.
///
/// ‖·‖_* is the norm of [`transport()`], which is dual to β. All three constants are
/// attained by some control ring. Edges and points are representatives under the
/// [rotation](LocalRules::rotation) of the ring, if it has one.
///
/// ```
/// use subcert::bound::LocalConstants;
/// use subcert::exact::Rational;
/// use subcert::scheme::parse_local_rules;
///
/// // A square face is biquadratic: x'_0 − x'_1 = 3/8 (x_0 − x_1) + 1/8 (x_3 − x_2).
/// let constants = LocalConstants::new(&parse_local_rules("doo-sabin:n=4")?, 2)?;
/// assert_eq!(constants.contraction(1).unwrap().1.value, Rational::new(1, 2).into());
/// assert_eq!(constants.contraction(2).unwrap().1.value, Rational::new(1, 4).into());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LocalConstants<S = RealCyclotomic> {
    /// ‖e_aᵀ(M − I)‖_* for the points a.
    pub displacements: Vec<(usize, Transport<S>)>,
    /// T_c and Λ_c, from c = 1.
    pub levels: Vec<LocalLevel<S>>,
}

impl<S: Real + Ord + Value> LocalConstants<S> {
    /// The constants for c = 1, …, `levels`.
    ///
    /// # Errors
    /// When the work for the powers of M is above
    /// [`MAX_LOCAL_WORK`](super::MAX_LOCAL_WORK).
    ///
    /// # Panics
    /// Never: the weights of a ring sum to 1, so that their differences sum to 0, and
    /// its mesh is connected.
    pub fn new(ring: &LocalRules<S>, levels: u32) -> Result<LocalConstants<S>, LocalWork> {
        let chosen = ring.representatives();
        LocalWork::check(ring, chosen.points.len(), levels)?;
        let norm = |w: Vec<S>| {
            transport(&w, ring.edges()).expect("differences of affine combinations sum to 0")
        };
        let points = chosen.points.iter().copied();
        let displacements = points.zip(displaced_rows(ring, &chosen).into_iter().map(norm));
        let level = |rows: PowerRows<S>| {
            let edges = chosen.edges.iter().copied();
            let differences = edges.zip(rows.differences(&chosen).into_iter().map(norm));
            LocalLevel { differences: differences.collect(), norm: rows.norm(&chosen) }
        };
        Ok(LocalConstants {
            displacements: displacements.collect(),
            levels: PowerRows::turned(ring, &chosen, levels).map(level).collect(),
        })
    }
}

impl<S: Ord> LocalLevel<S> {
    /// T_c, with an edge and a control ring that attain it.
    ///
    /// # Panics
    /// Never: a ring has edges.
    #[must_use]
    pub fn contraction(&self) -> &((usize, usize), Transport<S>) {
        greatest(&self.differences).expect("a ring has edges")
    }
}

impl<S: Ord> LocalConstants<S> {
    /// T_c, with an edge and a control ring that attain it; `None` when c is 0 or greater
    /// than the number of computed levels.
    #[must_use]
    pub fn contraction(&self, c: u32) -> Option<&((usize, usize), Transport<S>)> {
        let at = (c as usize).checked_sub(1)?;
        self.levels.get(at).map(LocalLevel::contraction)
    }

    /// σ, with a point and a control ring that attain it.
    ///
    /// # Panics
    /// Never: a ring has points.
    #[must_use]
    pub fn displacement(&self) -> &(usize, Transport<S>) {
        greatest(&self.displacements).expect("a ring has points")
    }
}

/// The first item with the greatest value.
fn greatest<T, S: Ord>(all: &[(T, Transport<S>)]) -> Option<&(T, Transport<S>)> {
    all.iter().rev().max_by(|left, right| left.1.value.cmp(&right.1.value))
}
