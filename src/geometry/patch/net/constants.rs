//! What is certain of one direction, whatever the points are.

use crate::bound::{Order, power_norm};
use crate::exact::Rational;
use crate::float::upper;
use crate::limit::{Functional, Limit, LimitError, second_contraction_constants};
use crate::net::NetError;

/// For the rounding of a few operations.
pub(super) const UP: f64 = 1.0 + 1e-9;

/// The most parameters at which functionals are looked at, if norms fall soon enough.
const SAMPLES: usize = 64;

/// The most in any case.
const MOST_SAMPLES: usize = 4_096;

/// The most levels after a piece for which its bounds are known.
pub(super) const MAX_LATER: u32 = 64;

/// Bounds of one direction in units of differences of the order q.
///
/// With l_t and p^k_t the limit and the polygon of level k at t, as functionals of the points, and
/// ‖·‖ the norm of a functional of q-th differences:
#[derive(Clone, Debug)]
pub(super) struct Constants {
    /// q: 2 where lines are kept and second differences fall, else 1.
    pub(super) order: usize,
    /// sup ‖l_t − p^0_t‖ over t.
    pub(super) error: f64,
    /// sup ‖l_t − (1 − t)l_0 − t l_1‖ over 0 ≤ t ≤ 1.
    pub(super) chord: f64,
    /// sup Σ|coefficients| of l_t.
    pub(super) limit: f64,
    /// The same of p^k_t, for all k.
    pub(super) polygon: f64,
    /// The same of one refinement.
    pub(super) refinement: f64,
    /// Bounds of the norms of the powers k, k + 1, … of the operator of q-th differences.
    falls: Vec<f64>,
}

impl Constants {
    pub(super) fn of(limit: &Limit, shift: &Rational) -> Result<Constants, NetError> {
        let (order, powers) = operator(limit);
        let arity = limit.mask().arity();
        let level = sampled_level(&powers, arity)?;
        let rest = Rational::one() - &powers[level as usize];
        let norm = |functional: Functional| norm(functional, order);
        let (mut error, mut chord) = (Rational::zero(), Rational::zero());
        let points = Rational::from(arity).pow(level.cast_signed());
        let minus = Rational::from(-1);
        let moved = |t: &Rational| -> Result<Rational, LimitError> {
            let fine = limit.polygon_from(level, t, shift)?;
            Ok(norm(fine.plus(&minus, &limit.polygon_from(0, t, shift)?)))
        };
        let ends = [limit.at(&Rational::zero())?, limit.at(&Rational::one())?];
        let count = u32::try_from(arity).unwrap_or(u32::MAX).saturating_pow(level);
        for j in 0..count {
            error = error.max(moved(&((Rational::from(j) + shift) / &points))?);
            let t = Rational::from(j) / &points;
            let off = limit.at(&t)?.plus(&(&t - Rational::one()), &ends[0]).plus(&-t, &ends[1]);
            chord = chord.max(norm(off));
        }
        let error = error.max(moved(shift)?) / &rest;
        let chord = chord / rest;
        let rules = limit.mask().rules();
        let falls = falls(&powers);
        let averages = rules.rows().iter().flatten().all(|entry| entry.sign() >= 0);
        let sum = |row: &Vec<Rational>| row.iter().map(Rational::abs).sum::<Rational>();
        let refinement = rules.rows().iter().map(sum).max().unwrap_or_else(Rational::one);
        let (mut norm, mut polygon) = (1.0, 1.0);
        let error = upper(&error);
        if !averages {
            let points = power_norm(rules, level, Order::Adjoint)
                .map_err(|error| NetError::TooMuch(error.to_string()))?;
            // Differences of the order q are at most 2^q where the points are at most 1.
            let unit = if order == 2 { 4.0 } else { 2.0 } * error * UP;
            norm = (upper(&points.value) + unit * upper(&powers[level as usize])) * UP;
            polygon = (norm + unit * falls[0]) * UP;
        }
        Ok(Constants {
            order,
            error,
            chord: upper(&chord),
            limit: norm,
            polygon,
            refinement: upper(&refinement),
            falls,
        })
    }

    /// A bound of ‖l_t − p^k_t‖ for the level k and all later ones.
    pub(super) fn error_at(&self, level: u32) -> f64 {
        let last = self.falls.len() - 1;
        self.error * self.falls[(level as usize).min(last)] * UP
    }

    /// A bound of Σ|coefficients| of p^k_t for the level k and all later ones.
    pub(super) fn polygon_at(&self, level: u32) -> f64 {
        if self.limit <= 1.0 {
            return 1.0;
        }
        let unit = if self.order == 2 { 4.0 } else { 2.0 };
        ((self.limit + unit * self.error_at(level)) * UP).min(self.polygon)
    }
}

/// The order of the differences, and the norms of the powers of their operator.
fn operator(limit: &Limit) -> (usize, Vec<Rational>) {
    let contracts = |powers: &Vec<Rational>| powers[1..].iter().any(|x| *x < Rational::one());
    let arity = Rational::from(limit.mask().arity());
    let second = second_contraction_constants(limit).map(|powers| {
        (0..).zip(&powers).map(|(c, norm)| norm / arity.pow(c)).collect::<Vec<Rational>>()
    });
    match second.filter(contracts) {
        Some(powers) => (2, powers),
        None => (1, limit.contraction().to_vec()),
    }
}

/// The level whose points are looked at: one after which differences are less.
fn sampled_level(powers: &[Rational], arity: usize) -> Result<u32, NetError> {
    let falls = |level: &u32| powers[*level as usize] < Rational::one();
    let count = |level: &u32| arity.checked_pow(*level).unwrap_or(usize::MAX);
    let levels = || 1..u32::try_from(powers.len()).unwrap_or(u32::MAX);
    let few = levels().take_while(|level| count(level) <= SAMPLES).filter(falls).last();
    let level = few.or_else(|| levels().find(falls).filter(|level| count(level) <= MOST_SAMPLES));
    level.ok_or_else(|| {
        NetError::TooMuch(format!(
            "the differences of this scheme fall too slowly: after levels with {MOST_SAMPLES} parts of a \
             cell or fewer they are not less"
        ))
    })
}

/// Upper bounds of the greatest norm of the powers k, k + 1, …, for k = 0, 1, ….
fn falls(powers: &[Rational]) -> Vec<f64> {
    let block = powers.iter().position(|x| *x < Rational::one()).unwrap_or(powers.len());
    let count = MAX_LATER as usize + 1;
    let exact: Vec<f64> = powers.iter().map(upper).collect();
    let mut norms = exact.clone();
    while norms.len() < count + block {
        let split = |j: usize| exact[j] * norms[norms.len() - j] * UP;
        let least = (1..exact.len()).map(split).fold(f64::INFINITY, f64::min);
        norms.push(least);
    }
    // After `block` levels each norm is less than the one before the block.
    (0..count).map(|k| norms[k..k + block.max(1)].iter().copied().fold(0.0, f64::max)).collect()
}

/// The norm of a functional of points as one of their differences of this order.
fn norm(functional: Functional, order: usize) -> Rational {
    let differences = (0..order).try_fold(functional, |f, _| f.on_differences());
    differences.expect("it is 0 at the data whose differences are 0").norm()
}
