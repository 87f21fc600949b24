//! The bound that is true: level by level, with exact constants.

use super::constants::{Constants, Operator};
use super::contraction::{ClassCap, Order};
use super::depth::{DepthError, MAX_DEPTH};
use super::displacement::{Terms, displacement};
use super::surface::surface_factor;
use crate::exact::Rational;

/// The sound block bound of a scheme, per unit of β = max|Δ^0|.
///
/// Level by level, ‖P^∞ − P^k‖_∞ ≤ σβ Σ_{m≥k} C_m, where C_m = T_m for a curve and
/// T_m Λ_m for a tensor product. C is submultiplicative, so wherever C_c < 1
///
/// ‖P^∞ − P^k‖_∞ ≤ σβ (U_k + … + U_{k+c−1}) / (1 − C_c),
///
/// with U_m = C_m up to the greatest level computed, and beyond it the least
/// C_j U_{m−j} over the computed j ≥ 1. The least of these over c is taken.
///
/// Hypotheses: an affine mask; σ at the mask's own offset; for a surface, β the
/// largest difference of the control net along either mesh direction.
#[derive(Clone, Debug)]
pub struct SoundBound {
    factor: Rational,
    /// C_0 = 1, C_1, …, C_c.
    exact: Vec<Rational>,
}

/// A depth with the block length that gives it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SoundDepth {
    /// The least level whose bound meets the tolerance.
    pub level: u32,
    /// The block length c of the bound that met it.
    pub block: u32,
}

impl SoundBound {
    /// The bound for curves, from T_1, …, T_`max_block`.
    ///
    /// # Errors
    /// When there are too many residue classes.
    pub fn curve(constants: &Constants, max_block: u32) -> Result<SoundBound, ClassCap> {
        let exact = (0..=max_block)
            .map(|c| constants.norm(Operator::Difference, c, Order::Adjoint))
            .collect::<Result<Vec<Rational>, ClassCap>>()?;
        Ok(SoundBound { factor: displacement(constants.mask(), Terms::Each), exact })
    }

    /// The bound for the tensor product of two schemes: the constants and the
    /// factor are the greater ones of the two directions.
    ///
    /// # Errors
    /// When there are too many residue classes.
    pub fn surface(
        first: &Constants,
        second: &Constants,
        max_block: u32,
    ) -> Result<SoundBound, ClassCap> {
        let along = |one: &Constants, other: &Constants, c| {
            Ok(one.norm(Operator::Difference, c, Order::Adjoint)?
                * other.norm(Operator::Scheme, c, Order::Adjoint)?)
        };
        let exact = (0..=max_block)
            .map(|c| Ok(along(first, second, c)?.max(along(second, first, c)?)))
            .collect::<Result<Vec<Rational>, ClassCap>>()?;
        Ok(SoundBound { factor: surface_factor(first.mask(), second.mask()), exact })
    }

    /// σ: the displacement of one refinement per unit of the largest difference.
    #[must_use]
    pub fn factor(&self) -> &Rational {
        &self.factor
    }

    /// C_0 = 1, C_1, …, C_c.
    #[must_use]
    pub fn constants(&self) -> &[Rational] {
        &self.exact
    }

    /// The bound on ‖P^∞ − P^k‖_∞/β for the levels k = 0, …, `last`, or `None`
    /// when no computed C_c is below 1.
    #[must_use]
    pub fn levels(&self, last: u32) -> Option<Vec<Rational>> {
        let mut tail = Tail::new(self);
        tail.contracts().then(|| (0..=last).map(|_| tail.next_level().0).collect())
    }

    /// The least level k whose bound times `spread` meets `tolerance`.
    ///
    /// # Errors
    /// When no computed C_c is below 1, an argument is not positive, or the
    /// level is beyond the cap.
    pub fn depth(&self, spread: &Rational, tolerance: &Rational) -> Result<SoundDepth, DepthError> {
        for (what, value) in [("the tolerance", tolerance), ("the spread", spread)] {
            if value.sign() <= 0 {
                return Err(DepthError::NotPositive { what, value: value.to_string() });
            }
        }
        let mut tail = Tail::new(self);
        if !tail.contracts() {
            let least = self.exact[1..]
                .iter()
                .min()
                .map_or_else(String::new, |least| crate::exact::format::short(least, 6));
            return Err(DepthError::NoContraction(least));
        }
        let allowed = tolerance / spread;
        for level in 0..=MAX_DEPTH {
            let (bound, block) = tail.next_level();
            if bound <= allowed {
                return Ok(SoundDepth { level, block });
            }
            if bound.bits() > MAX_BOUND_BITS {
                break;
            }
        }
        Err(DepthError::TooDeep)
    }
}

/// Where a depth is given up, in bits of the bound.
const MAX_BOUND_BITS: u64 = 20_000;

/// The bounds level after level.
struct Tail<'a> {
    bound: &'a SoundBound,
    /// U_k, …, U_{k+c−1} for the next level k.
    window: Vec<Rational>,
}

impl<'a> Tail<'a> {
    fn new(bound: &'a SoundBound) -> Tail<'a> {
        let blocks = bound.exact.len() - 1;
        Tail { bound, window: bound.exact[..blocks].to_vec() }
    }

    fn contracts(&self) -> bool {
        self.bound.exact[1..].iter().any(|constant| *constant < Rational::one())
    }

    /// The bound of the next level, and its block length. Some C_c is below 1.
    fn next_level(&mut self) -> (Rational, u32) {
        let mut sum = Rational::zero();
        let mut best: Option<(Rational, u32)> = None;
        for (c, (constant, next)) in (1..).zip(self.bound.exact[1..].iter().zip(&self.window)) {
            sum += next;
            if *constant >= Rational::one() {
                continue;
            }
            let value = &self.bound.factor * &sum / (Rational::one() - constant);
            if best.as_ref().is_none_or(|(least, _)| value < *least) {
                best = Some((value, c));
            }
        }
        self.advance();
        best.expect("some constant is below 1")
    }

    fn advance(&mut self) {
        // The window holds U_k, …, U_{k+c−1}; the next is U_{k+c}.
        let from_split = self.bound.exact[1..]
            .iter()
            .zip(self.window.iter().rev())
            .map(|(constant, earlier)| constant * earlier)
            .min()
            .expect("there is at least one block");
        self.window.remove(0);
        self.window.push(from_split);
    }
}
