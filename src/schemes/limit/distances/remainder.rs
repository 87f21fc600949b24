//! Bounds of the limit between the parameters at which it is computed.

use super::cell::Sizes;
use super::fraction::Fraction;
use super::middles::Middles;
use crate::bound::SoundBound;
use crate::exact::{Integer, Rational};
use crate::limit::convergence::contraction_constants;
use crate::limit::error::LimitError;
use crate::limit::functional::Functional;
use crate::limit::value::Limit;
use crate::scheme::Mask;

/// Bounds on a cell, in terms of the differences Δ in its window and of their differences
/// ∇Δ.
///
/// Source: `proofs/THEOREMS.md`, 2, 6, 7 and 88.
#[derive(Clone, Debug)]
pub(super) struct Remainders {
    /// The bound of |P^∞ − P^j| in terms of max|Δ|.
    polygon: SoundBound,
    /// The bound of |P^∞ − P^j| in terms of |Δ_0| and max|∇Δ|.
    smooth_polygon: Option<SmoothBound>,
    /// The bound of the distance of P^∞ from its chord, in terms of max|Δ|.
    chord: Fraction,
    /// λ: at u in [0, 1] the distance of P^∞ from its chord is at most λ min(u, 1−u)
    /// max|∇Δ|.
    smooth_chord: Option<Fraction>,
}

/// |P^∞ − P^j| ≤ n^−j |τ||Δ_0| + (n^−j ρ + ς_j) max|∇Δ| for a scheme that takes every
/// line to the parallel line shifted by τΔ_0.
#[derive(Clone, Debug)]
struct SmoothBound {
    arity: Rational,
    /// |τ|.
    shift: Rational,
    /// ρ.
    turn: Rational,
    /// ς_j.
    rest: SoundBound,
}

/// A bound of |P^∞ − P^j|: the factor of max|Δ|, and the factors of |Δ_0| and max|∇Δ| if
/// they are finite.
pub(super) struct LevelBound {
    spread: Fraction,
    /// The factors of |Δ_0| and max|∇Δ|, over one denominator.
    smooth: Option<[Fraction; 2]>,
}

impl LevelBound {
    fn new(spread: &Rational, smooth: Option<&[Rational; 2]>) -> LevelBound {
        let smooth = smooth.map(|[own, turn]| {
            let (p, q) = (own.denominator(), turn.denominator());
            [
                Fraction { p: own.numerator() * &q, q: &p * &q },
                Fraction { p: turn.numerator() * &p, q: p * q },
            ]
        });
        LevelBound { spread: spread.into(), smooth }
    }

    /// The bound on a cell with these sizes.
    pub(super) fn over(&self, sizes: &Sizes) -> Fraction {
        let Fraction { p, q } = &self.spread;
        let bound = Fraction { p: p * &sizes.spread, q: q * sizes.scale };
        match &self.smooth {
            Some([own, turn]) => bound.min(Fraction {
                p: &own.p * &sizes.own + &turn.p * &sizes.turn,
                q: &own.q * sizes.scale,
            }),
            None => bound,
        }
    }
}

impl Remainders {
    /// The bounds for a shift, and for the [`middles`](super::middles::middles) of this
    /// shift.
    pub(super) fn new(
        limit: &Limit,
        shift: &Rational,
        middles: &[Middles],
    ) -> Result<Remainders, LimitError> {
        let displaced = displacements(limit, shift)?;
        let constants = limit.contraction();
        let chord = middles.iter().flat_map(|phase| norms(&phase.functionals));
        let chord = series(greatest(chord), constants).expect("some T_c is below 1");
        let polygon = SoundBound::of(greatest(norms(&displaced)), constants.to_vec());
        let chord = Fraction::from(&chord);
        let mut remainders =
            Remainders { polygon, smooth_polygon: None, chord, smooth_chord: None };
        if let Some(scaled) = second_contraction_constants(limit) {
            remainders.smooth_polygon = SmoothBound::new(limit, shift, &displaced, &scaled);
            let arity = limit.mask().arity();
            let middles = middles.iter().flat_map(|phase| (1..).zip(&phase.functionals));
            let slopes = middles.map(|(alpha, middle)| {
                second_norm(middle) * Rational::new(arity, alpha.min(arity - alpha))
            });
            remainders.smooth_chord =
                series(greatest(slopes), &scaled).map(|slope| Fraction::from(&slope));
        }
        Ok(remainders)
    }

    /// A bound of |P^∞ − P^k| on a cell from its values at both ends. Both values have
    /// the same denominator, which is `factor` times that of the sizes.
    pub(super) fn between(
        &self,
        [left, right]: &[Fraction; 2],
        factor: &Integer,
        sizes: &Sizes,
    ) -> Fraction {
        let ends = left.max(right);
        // sum/q + (p/q')·size over the product of both denominators.
        let plus = |sum: &Integer, chord: &Fraction, size: &Integer| Fraction {
            p: sum * &chord.q + &chord.p * size * factor,
            q: &ends.q * &chord.q,
        };
        let bound = plus(&ends.p, &self.chord, &sizes.spread);
        match &self.smooth_chord {
            Some(slope) => {
                let mut middle = plus(&(&left.p + &right.p), slope, &sizes.turn);
                middle.q = middle.q.shifted_left(1);
                bound.min(middle.max(ends.clone()))
            }
            None => bound,
        }
    }

    /// A bound of |P^∞ − P^k| for all polygons with max|Δ| ≤ 1.
    pub(super) fn of_all(&self, level: u32) -> Rational {
        let scale = Integer::one();
        let [spread, own, turn] = [1, 1, 2].map(Integer::from);
        let sizes = Sizes { spread, own, turn, scale: &scale };
        self.levels(level)[level as usize].over(&sizes).reduced()
    }

    /// The bounds of |P^∞ − P^j| for j = 0, …, k.
    pub(super) fn levels(&self, level: u32) -> Vec<LevelBound> {
        let spreads = self.polygon.levels(level).expect("some T_c is below 1");
        let smooth = self.smooth_polygon.as_ref().and_then(|smooth| smooth.levels(level));
        let bound = |(j, spread): (usize, Rational)| {
            LevelBound::new(&spread, smooth.as_ref().map(|smooth| &smooth[j]))
        };
        spreads.into_iter().enumerate().map(bound).collect()
    }
}

impl SmoothBound {
    /// The bound from the displacements and the norms ‖(nD_2)^c‖. `None` when the norms give no
    /// finite bound, or when the shift is not 0 and lines are not reproduced with it.
    fn new(
        limit: &Limit,
        shift: &Rational,
        displaced: &[Functional],
        scaled: &[Rational],
    ) -> Option<SmoothBound> {
        let arity = Rational::from(limit.mask().arity());
        // ε: the displacement where Δ = 1 everywhere. It is the same for all
        // displacements.
        let step = displaced[0].apply(|_| Rational::one());
        if !shift.is_zero() && !step.is_zero() {
            return None;
        }
        let straight = Functional::new(0, [step.clone()]);
        let last = displaced[0].shifted(1);
        let rests = displaced.iter().chain([&last]).map(|f| f.plus(&Rational::from(-1), &straight));
        let factor = greatest(rests.map(|rest| second_norm(&rest)));
        let plain = (0..).zip(scaled).map(|(c, norm)| norm / arity.pow(c)).collect();
        let rows = (0..).zip(limit.difference().rows()).map(|(alpha, _)| {
            let row = Functional::point(alpha).after(limit.difference());
            second_norm(&row.plus(&-arity.recip(), &Functional::point(0)))
        });
        let shift = (&step * &arity / (&arity - Rational::one())).abs();
        let turn = if shift.is_zero() {
            Rational::zero()
        } else {
            series(&shift * &arity * greatest(rows), scaled)?
        };
        Some(SmoothBound { arity, shift, turn, rest: SoundBound::of(factor, plain) })
    }

    fn levels(&self, level: u32) -> Option<Vec<[Rational; 2]>> {
        let rests = (0..).zip(self.rest.levels(level)?);
        let bound = |(j, rest): (i32, Rational)| {
            let scale = self.arity.pow(-j);
            [&self.shift * &scale, &self.turn * &scale + rest]
        };
        Some(rests.map(bound).collect())
    }
}

/// P^1 − P^0 as functionals of Δ, at the parameters of points of both levels: (α + s)/n for
/// α = 0, …, n − 1, and s.
fn displacements(limit: &Limit, shift: &Rational) -> Result<Vec<Functional>, LimitError> {
    let arity = Rational::from(limit.mask().arity());
    let at = |t: Rational| {
        let new = limit.polygon_from(1, &t, shift)?;
        let moved = new.plus(&Rational::from(-1), &limit.polygon_from(0, &t, shift)?);
        Ok(moved.on_differences().expect("both are affine combinations"))
    };
    let fine = (0..limit.mask().arity()).map(|alpha| (shift + Rational::from(alpha)) / &arity);
    // If (n − 1)s is an integer, the parameters of level 0 are among those of level 1.
    let aligned = ((&arity - Rational::one()) * shift).is_integer();
    let coarse = (!aligned).then(|| shift.clone());
    fine.chain(coarse).map(at).collect()
}

/// ‖(nD_2)^c‖ for c = 0, 1, …, where D_2 takes ∇Δ to the next level. `None` unless the
/// rows of nD sum to 1. If they do, nD_2 is the difference operator of the scheme nD.
#[must_use]
pub fn second_contraction_constants(limit: &Limit) -> Option<Vec<Rational>> {
    let arity = Rational::from(limit.mask().arity());
    let derived = limit.difference().map(|entry| entry * &arity);
    let derived = Mask::new(derived.rows().to_vec(), derived.offset()).ok()?;
    Some(contraction_constants(&derived.difference()))
}

/// The least factor·(C_0 + … + C_{c−1})/(1 − C_c) over all c with C_c < 1: an upper bound
/// of factor·Σ_j C_j. `None` when no C_c is below 1.
fn series(factor: Rational, constants: &[Rational]) -> Option<Rational> {
    SoundBound::of(factor, constants.to_vec()).levels(0)?.pop()
}

fn norms(functionals: &[Functional]) -> impl Iterator<Item = Rational> {
    functionals.iter().map(Functional::norm)
}

/// The norm of a functional of Δ, written as a functional of ∇Δ.
fn second_norm(functional: &Functional) -> Rational {
    functional.on_differences().expect("it is 0 where Δ is constant").norm()
}

fn greatest(norms: impl Iterator<Item = Rational>) -> Rational {
    norms.max().unwrap_or_else(Rational::zero)
}
