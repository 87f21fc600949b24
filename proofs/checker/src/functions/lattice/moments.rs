//! Sum rules, and the polynomials that rules reproduce.

#![warn(clippy::arithmetic_side_effects)]

use crate::numbers::{Meter, Q, common_multiple};
use crate::schemes::{Dilation, Lattice, Vector};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::Zero as _;
use std::collections::BTreeMap;

/// The greatest number of sum rules.
const MAX_ORDER: u32 = 64;

/// The coefficients of a mask, as integers over one denominator.
pub(super) struct Moments<'l> {
    meter: &'l Meter,
    dilation: &'l Dilation,
    /// The places with their classes and coefficients.
    terms: Vec<(Vector, Vector, BigInt)>,
    /// The denominator.
    over: BigInt,
}

impl Moments<'_> {
    /// The moments of a mask of rational numbers.
    pub(super) fn new<'l>(meter: &'l Meter, lattice: &'l Lattice) -> Result<Moments<'l>, Stop> {
        Moments::of(meter, &lattice.dilation, &lattice.rational()?)
    }

    /// Those of coefficients of which each class has the same sum.
    pub(super) fn of<'l>(
        meter: &'l Meter,
        dilation: &'l Dilation,
        rational: &[(Vector, Q)],
    ) -> Result<Moments<'l>, Stop> {
        let over = common_multiple(rational.iter().map(|(_, a)| a.denom()))?;
        let term = |(place, a): &(Vector, Q)| {
            let class = dilation.class(*place)?;
            Ok((*place, class, a.numer() * (&over / a.denom())))
        };
        let terms = rational.iter().map(term).collect::<Result<Vec<_>, Stop>>()?;
        Ok(Moments { meter, dilation, terms, over })
    }

    /// K.
    pub(super) fn sum_rules(&self) -> Result<usize, Stop> {
        // All sums of coefficients alone are the same.
        for degree in 1..MAX_ORDER {
            for powers in exponents(self.dilation.d, degree) {
                let sums = self.sums(powers, |place| place.map(BigInt::from))?;
                // A class without coefficients has the sum 0.
                let missing = (sums.len() as u64) < self.dilation.arity();
                let zero = missing.then(BigInt::zero);
                let mut sums = sums.values().chain(&zero);
                let first = sums.next();
                if !sums.all(|sum| Some(sum) == first) {
                    return Ok(degree as usize);
                }
            }
        }
        Ok(MAX_ORDER as usize)
    }

    /// The greatest k < K for which the sums of a(α)(α − m_1)^μ are 0 for all μ from 1 to k.
    pub(super) fn reproduction(&self) -> Result<usize, Stop> {
        let rules = self.sum_rules()?;
        // With a(α) = A(α)/q, mq(α − m_1) = mqα − Σ A(α)α.
        let mut mean = [0; 3].map(BigInt::from);
        for (place, _, a) in &self.terms {
            for (sum, x) in mean.iter_mut().zip(place) {
                *sum += a * x;
            }
        }
        let unit = &self.over * self.dilation.arity();
        let shifted = |place: Vector| {
            let mut rest = mean.clone().map(|sum| -sum);
            for (sum, x) in rest.iter_mut().zip(place) {
                *sum += &unit * x;
            }
            rest
        };
        for degree in 1..u32::try_from(rules).unwrap_or(MAX_ORDER) {
            for powers in exponents(self.dilation.d, degree) {
                let sums = self.sums(powers, shifted)?;
                if !sums.values().sum::<BigInt>().is_zero() {
                    return Ok((degree as usize).saturating_sub(1));
                }
            }
        }
        Ok(rules.saturating_sub(1))
    }

    /// Σ A(α)x(α)^μ over the α of each class.
    fn sums(
        &self,
        powers: [u32; 3],
        at: impl Fn(Vector) -> [BigInt; 3],
    ) -> Result<BTreeMap<Vector, BigInt>, Stop> {
        let mut sums = BTreeMap::new();
        for (place, class, a) in &self.terms {
            let x = at(*place);
            let bits = x.iter().zip(powers).map(|(x, e)| x.bits().saturating_mul(e.into()));
            let limbs = bits.fold(a.bits(), u64::saturating_add) / 64;
            self.meter.spend((limbs.saturating_mul(limbs) / 16).saturating_add(1))?;
            let power = x.iter().zip(powers).fold(a.clone(), |power, (x, e)| power * x.pow(e));
            *sums.entry(*class).or_insert_with(BigInt::zero) += power;
        }
        Ok(sums)
    }
}

/// The d exponents with this sum.
pub fn exponents(d: usize, degree: u32) -> Vec<[u32; 3]> {
    let of = |i: u32| {
        let rest = degree.saturating_sub(i);
        let last = if d == 2 { 0..=0 } else { 0..=rest };
        last.map(move |j| [i, rest.saturating_sub(j), j])
    };
    (0..=degree).flat_map(of).collect()
}
