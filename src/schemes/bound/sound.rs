//! The sound error bound: level by level, with exact constants.

use super::constants::{Constants, Operator};
use super::depth::{DepthError, MAX_DEPTH};
use super::displacement::{Terms, displacement};
use super::power::{ClassCap, Order};
use super::surface::surface_factor;
use crate::exact::{Integer, Rational, format};
use std::collections::VecDeque;

/// The sound block bound of a scheme, per unit of β = max|Δ^0|.
///
/// Level by level, `‖P^∞ − P^k‖_∞ ≤ σβ Σ_{m≥k} C_m`, where C_m = T_m for a curve and T_m
/// Λ_m for a tensor product. C is submultiplicative: C_{i+j} ≤ C_i C_j. So for every c
/// with C_c < 1
///
/// `‖P^∞ − P^k‖_∞ ≤ σβ (U_k + … + U_{k+c−1}) / (1 − C_c)`,
///
/// with U_m = C_m up to the greatest level computed, and beyond it the least C_j U_{m−j}
/// over the computed j ≥ 1. The bound is the least of these over c.
///
/// Hypotheses: an affine mask; σ at the mask's own offset; for a surface, β the
/// largest difference of the control net along either mesh direction.
#[derive(Clone, Debug)]
pub struct SoundBound {
    factor: Rational,
    /// C_0 = 1, C_1, …, C_c.
    exact: Vec<Rational>,
}

/// A depth, with the block length of its bound.
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
    /// As [`power_norm`](super::power_norm).
    pub fn curve(constants: &Constants, max_block: u32) -> Result<SoundBound, ClassCap> {
        let exact = (0..=max_block)
            .map(|c| constants.norm(Operator::Difference, c, Order::Adjoint))
            .collect::<Result<Vec<Rational>, ClassCap>>()?;
        Ok(SoundBound { factor: displacement(constants.mask(), Terms::Each), exact })
    }

    /// The bound for the tensor product of two schemes: the constants and the factor are
    /// the maxima over the two directions.
    ///
    /// # Errors
    /// As [`power_norm`](super::power_norm).
    pub fn surface(
        first: &Constants,
        second: &Constants,
        max_block: u32,
    ) -> Result<SoundBound, ClassCap> {
        let exact = (0..=max_block)
            .map(|c| Ok(first.tensor_with(second, c)?.max(second.tensor_with(first, c)?)))
            .collect::<Result<Vec<Rational>, ClassCap>>()?;
        Ok(SoundBound { factor: surface_factor(first.mask(), second.mask()), exact })
    }

    /// The bound for any factor σ and any submultiplicative constants C_0 = 1, C_1, …,
    /// C_c.
    #[must_use]
    pub fn of(factor: Rational, constants: Vec<Rational>) -> SoundBound {
        SoundBound { factor, exact: constants }
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
        let mut tail = Tail::new(&self.exact);
        let mut next = || {
            let bound = self.least(&tail)?.0;
            tail.advance();
            Some(bound)
        };
        (0..=last).map(|_| next()).collect()
    }

    /// The bound on ‖P^∞ − P^k‖_∞/β for the level k, and the block length c that gives
    /// it; `None` when no computed C_c is below 1.
    #[must_use]
    pub fn level(&self, k: u32) -> Option<(Rational, u32)> {
        let mut tail = Tail::new(&self.exact);
        self.least(&tail)?;
        (0..k).for_each(|_| tail.advance());
        self.least(&tail)
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
        let mut tail = Tail::new(&self.exact);
        if self.least(&tail).is_none() {
            let least = self.exact.iter().skip(1).min().unwrap_or(&self.exact[0]);
            return Err(DepthError::NoContraction(format::short(least, 6)));
        }
        // The bound of block c meets the tolerance when its sum, over D^{k+c−1},
        // is at most 1/t, t = σβ/(ε(1 − C_c)): sum·t/D^{c−1} ≤ D^k, in integers.
        let unit = spread / tolerance * &self.factor;
        let tests = self.contracting().map(|(c, constant)| {
            let places = Rational::from(tail.base.pow(c - 1));
            let test = &unit / (Rational::one() - constant) / places;
            (c as usize - 1, test.numerator(), test.denominator())
        });
        let tests: Vec<(usize, Integer, Integer)> = tests.collect();
        for level in 0..=MAX_DEPTH {
            let sums = tail.sums();
            if tests.iter().any(|(at, p, q)| &sums[*at] * p <= &tail.scale * q) {
                let block = self.least(&tail).map_or(1, |(_, block)| block);
                return Ok(SoundDepth { level, block });
            }
            if tail.scale.bits() > MAX_BOUND_BITS {
                break;
            }
            tail.advance();
        }
        Err(DepthError::TooDeep)
    }

    /// The block lengths c with C_c < 1, and their constants C_c.
    fn contracting(&self) -> impl Iterator<Item = (u32, &Rational)> {
        (1..).zip(&self.exact[1..]).filter(|(_, constant)| **constant < Rational::one())
    }

    /// The bound at the level that `tail` has reached, and its block length.
    fn least(&self, tail: &Tail) -> Option<(Rational, u32)> {
        let sums = tail.sums();
        let bounds = self.contracting().map(|(c, constant)| {
            let sum =
                Rational::new(sums[c as usize - 1].clone(), &tail.scale * tail.base.pow(c - 1));
            (&self.factor * sum / (Rational::one() - constant), c)
        });
        bounds.min()
    }
}

/// A depth is given up when D^k has more than this number of bits.
const MAX_BOUND_BITS: u64 = 200_000;

/// The numbers U_k, U_{k+1}, …, level after level, as integers. D is such that every
/// c_j = D^j C_j is an integer. Then U_m = u_m/D^m, where u_m is the least c_j u_{m−j}.
/// No fraction is reduced, so the time for level k is linear in k.
struct Tail {
    /// D.
    base: Integer,
    /// c_1, …, c_c.
    steps: Vec<Integer>,
    /// u_k, …, u_{k+c−1}.
    window: VecDeque<Integer>,
    /// D^k.
    scale: Integer,
}

impl Tail {
    /// The state at level k = 0, for the constants C_0 = 1, C_1, …, C_c.
    fn new(constants: &[Rational]) -> Tail {
        let scaled = |base: &Integer, (j, constant): (u32, &Rational)| {
            constant * Rational::from(base.pow(j))
        };
        let base = (1..).zip(&constants[1..]).fold(Integer::one(), |base, constant| {
            let rest = scaled(&base, constant).denominator();
            base * rest
        });
        let integers = (0..).zip(constants).map(|constant| scaled(&base, constant).numerator());
        let scaled: Vec<Integer> = integers.collect();
        let window = scaled[..scaled.len() - 1].iter().cloned().collect();
        Tail { steps: scaled[1..].to_vec(), window, scale: Integer::one(), base }
    }

    /// D^{k+c−1}(U_k + … + U_{k+c−1}) for c = 1, 2, ….
    fn sums(&self) -> Vec<Integer> {
        let add = |sum: &mut Integer, next: &Integer| {
            *sum = &*sum * &self.base + next;
            Some(sum.clone())
        };
        self.window.iter().scan(Integer::zero(), add).collect()
    }

    /// Advances to the next level: u_{k+c} enters the window, and u_k leaves it.
    fn advance(&mut self) {
        let splits = self.steps.iter().zip(self.window.iter().rev());
        let next = splits.map(|(step, earlier)| step * earlier).min();
        self.window.extend(next);
        self.window.pop_front();
        self.scale *= &self.base;
    }
}
