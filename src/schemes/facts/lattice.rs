//! The facts of a mask on Z^d.

use super::shape::PointPlacement;
use crate::exact::Rational;
use crate::lattice::{
    LatticeConstants, LatticeSmoothness, displacement, is_interpolating, limit_values, mean,
    natural_shift, reproduction, sum_rules, support, symmetries,
};
use crate::scheme::{LatticeMask, Point};
use crate::stop::Stop;
use std::collections::BTreeMap;

/// The constants are those of c = 1, …, this many levels.
const MAX_LEVELS: u32 = 4;

/// The most differences of one constant.
const MAX_DIFFERENCES: usize = 1 << 11;

/// What is known of a mask on Z^d at once. What is not decided is `None`, or shorter.
#[derive(Clone, Debug)]
pub struct LatticeFacts {
    /// The mask.
    pub mask: LatticeMask,
    /// The box of the support of φ, axis by axis.
    pub support: Option<Vec<[Rational; 2]>>,
    /// The number of symmetries with entries −1, 0 and 1.
    pub symmetries: usize,
    /// Whether the scheme is primal or dual, by its natural shift.
    pub kind: Option<PointPlacement>,
    /// Whether it interpolates its data.
    pub interpolating: bool,
    /// The order K of the sum rules.
    pub sum_rules: u32,
    /// The degree up to which polynomials are reproduced at the natural shift.
    pub reproduction: u32,
    /// The natural shift τ, the centre of mass of φ.
    pub shift: Vec<Rational>,
    /// C^m and the Hölder exponent.
    pub smoothness: LatticeSmoothness,
    /// φ at the integers where it is not 0, if the scheme is known to converge: the limit of data p at α is Σ_β φ(α − β)p_β.
    pub values: Option<BTreeMap<Point, Rational>>,
    /// σ with the points of level k at M^{−k}α, and at their natural places M^{−k}(α + τ); `None` in three dimensions with an M that is not diagonal.
    pub displacement: Option<[Rational; 2]>,
    /// T_1, T_2, …
    pub contraction: Vec<Rational>,
    /// Λ_1, Λ_2, …
    pub norm: Vec<Rational>,
}

impl LatticeFacts {
    /// The facts of a mask.
    #[must_use]
    pub fn of(mask: &LatticeMask) -> LatticeFacts {
        let (mut contraction, mut norm) = (Vec::new(), Vec::new());
        let mut constants = LatticeConstants::new(mask);
        for _ in 1..=MAX_LEVELS {
            if constants.next_count() > MAX_DIFFERENCES || constants.advance().is_err() {
                break;
            }
            let Ok(found) = constants.contraction() else { break };
            contraction.push(found.value);
            norm.push(constants.norm());
        }
        let shift = natural_shift(mask);
        let origin = vec![Rational::zero(); mask.dimension()];
        let [indexed, natural] = [&origin, &shift].map(|at| displacement(mask, at).ok().flatten());
        let smoothness = LatticeSmoothness::until(mask, &Stop::default());
        let values = (smoothness.converges == Some(true)).then(|| limit_values(mask, 0).ok());
        LatticeFacts {
            values: values.flatten().flatten(),
            displacement: indexed.zip(natural).map(|(indexed, natural)| [indexed, natural]),
            support: support(mask),
            symmetries: symmetries(mask).len(),
            kind: placement(mask),
            interpolating: is_interpolating(mask),
            sum_rules: sum_rules(mask),
            reproduction: reproduction(mask),
            shift,
            smoothness,
            contraction,
            norm,
            mask: mask.clone(),
        }
    }
}

/// Whether old points have the places of some new ones, at the natural shift, or stand half a step off from them in all coordinates: the mean m_1 of
/// the places, or m_1 + (½, …, ½), is integer.
#[must_use]
pub fn placement(mask: &LatticeMask) -> Option<PointPlacement> {
    let mean = mean(mask);
    let all = |shift: &Rational| mean.iter().all(|x| (x + shift).is_integer());
    if all(&Rational::zero()) {
        return Some(PointPlacement::Primal);
    }
    all(&Rational::new(1, 2)).then_some(PointPlacement::Dual)
}
