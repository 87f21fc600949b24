//! What a radius shows of the limits of a mask on Z^d that converges. THEOREMS.md, 149.

#![warn(clippy::arithmetic_side_effects)]

use super::similar::root;
use crate::functions::exponent::{Bound, LogSum};
use crate::numbers::{Q, int};
use crate::radius::Radius;
use crate::schemes::Dilation;
use crate::text::{Checked, Stop};
use num_bigint::BigInt;
use num_traits::Pow;
use std::cmp::Ordering;

/// The most binary digits of a power.
const MAX_BITS: u64 = 1 << 16;

/// A power of an integer above 1.
fn power(base: &BigInt, exponent: usize) -> Result<BigInt, Stop> {
    let bits = base.bits().saturating_mul(exponent as u64);
    if bits > MAX_BITS {
        return Err(Stop::Capped("the size of a power"));
    }
    Ok(Pow::pow(base, exponent))
}

/// Bounds of the radius ϱ of the operators on U'.
pub struct Shown {
    /// d.
    d: usize,
    /// m.
    arity: u64,
    /// K'.
    accuracy: usize,
    /// ϱ is at most this.
    at_most: Q,
    /// ϱ^l is at least this, and l.
    at_least: Option<(Q, usize)>,
    /// The base of logarithms, and the power of a number that has the logarithm to the base m^{1/d}.
    base: (usize, usize),
}

impl Shown {
    /// What bounds of the radius of the matrices fT_g show.
    pub fn new(
        dilation: &Dilation,
        accuracy: usize,
        radius: Radius,
        factor: &BigInt,
    ) -> Result<Shown, Stop> {
        let base = |n: u64| usize::try_from(n).unwrap_or(usize::MAX);
        let lower = |(bound, degree): (Q, usize)| Ok((bound / power(factor, degree)?, degree));
        let at_least: Option<Result<(Q, usize), Stop>> = radius.at_least.map(lower);
        Ok(Shown {
            d: dilation.d,
            arity: dilation.arity(),
            accuracy,
            at_most: radius.at_most / factor,
            at_least: at_least.transpose()?,
            base: root(dilation).map_or((base(dilation.arity()), dilation.d), |n| (base(n), 1)),
        })
    }

    /// How x^d compares with m^{−k}.
    fn compared(&self, x: &Q, k: usize) -> Result<Ordering, Stop> {
        let scale = power(&self.arity.into(), k)?;
        let [numerator, denominator] = [x.numer(), x.denom()].map(|x| Pow::pow(x, self.d));
        Ok((numerator * scale).cmp(&denominator))
    }

    /// Whether all limits are C^k, k > 0.
    pub fn continuous(&self, k: usize) -> bool {
        let below = || self.compared(&self.at_most, k).is_ok_and(Ordering::is_lt);
        k < self.accuracy && below()
    }

    /// Whether not all limits are C^k.
    pub fn not_continuous(&self, k: usize) -> bool {
        let reaches = |(bound, degree): &(Q, usize)| {
            self.compared(bound, k.saturating_mul(*degree)).is_ok_and(Ordering::is_ge)
        };
        k >= self.accuracy || self.at_least.as_ref().is_some_and(reaches)
    }

    /// −log_s of a number to the power 1/l, and a rational number more.
    fn compare(
        &self,
        (order, radius, degree): (usize, &Q, usize),
        value: &LogSum,
    ) -> Result<Ordering, Stop> {
        let (arity, power) = self.base;
        let radius = Pow::pow(radius, power);
        Bound { order, arity, radius: &radius, degree }.compare(value)
    }

    /// Whether the exponent is at least this number; with `strictly`, greater.
    pub fn at_least(&self, value: &LogSum, strictly: bool) -> Checked<bool> {
        let found = self.compare((0, &self.at_most, 1), value)?;
        Ok(if strictly { found.is_gt() } else { found.is_ge() })
    }

    /// Whether the exponent is at most this number; with `strictly`, less.
    pub fn at_most(&self, value: &LogSum, strictly: bool) -> Checked<bool> {
        let accuracy = (self.accuracy, &int(1), 1);
        let lower = self.at_least.as_ref().map(|(bound, degree)| (0, bound, *degree));
        for bound in [Some(accuracy), lower].into_iter().flatten() {
            let found = self.compare(bound, value)?;
            if if strictly { found.is_lt() } else { found.is_le() } {
                return Ok(true);
            }
        }
        Ok(false)
    }
}
