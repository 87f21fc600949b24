//! Quotients of polynomials. Their divisors are products of factors that are positive for all integers in question.

#![warn(clippy::arithmetic_side_effects)]

use super::polynomial::Polynomial;
use crate::numbers::{Meter, int};
use crate::text::Stop;
use std::collections::BTreeMap;

/// A quotient.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Quotient {
    /// The dividend.
    pub top: Polynomial,
    /// The factors of the divisor, with their exponents.
    pub bottom: BTreeMap<Polynomial, u32>,
}

impl From<Polynomial> for Quotient {
    fn from(top: Polynomial) -> Quotient {
        Quotient { top, bottom: BTreeMap::new() }
    }
}

impl Quotient {
    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        self.top.is_zero()
    }

    /// The same without the factors that divide the dividend.
    pub fn reduced(mut self, meter: &Meter) -> Result<Quotient, Stop> {
        if self.top.is_zero() {
            return Ok(Quotient::default());
        }
        for (factor, exponent) in &mut self.bottom {
            while *exponent > 0
                && let Some(quotient) = self.top.divided(meter, factor)?
            {
                self.top = quotient;
                *exponent = exponent.saturating_sub(1);
            }
        }
        self.bottom.retain(|_, exponent| *exponent > 0);
        Ok(self)
    }

    /// self + factor·other.
    pub fn plus(&self, meter: &Meter, factor: i64, other: &Quotient) -> Result<Quotient, Stop> {
        let mut bottom = self.bottom.clone();
        for (divisor, exponent) in &other.bottom {
            let known = bottom.entry(divisor.clone()).or_insert(0);
            *known = (*known).max(*exponent);
        }
        let mut top = self.over(meter, &bottom)?;
        top.add(meter, &int(factor), &other.over(meter, &bottom)?)?;
        Quotient { top, bottom }.reduced(meter)
    }

    /// The dividend with a divisor that is a multiple of this one.
    fn over(&self, meter: &Meter, bottom: &BTreeMap<Polynomial, u32>) -> Result<Polynomial, Stop> {
        let mut top = self.top.clone();
        for (factor, exponent) in bottom {
            let own = self.bottom.get(factor).copied().unwrap_or(0);
            for _ in own..*exponent {
                top = top.times(meter, factor)?;
            }
        }
        Ok(top)
    }

    /// self · other.
    pub fn times(&self, meter: &Meter, other: &Quotient) -> Result<Quotient, Stop> {
        let mut bottom = self.bottom.clone();
        for (factor, exponent) in &other.bottom {
            let sum = bottom.entry(factor.clone()).or_insert(0);
            *sum = sum.saturating_add(*exponent);
        }
        Quotient { top: self.top.times(meter, &other.top)?, bottom }.reduced(meter)
    }

    /// The product of the factors of the divisor.
    pub fn divisor(&self, meter: &Meter) -> Result<Polynomial, Stop> {
        Quotient::from(Polynomial::int(1)).over(meter, &self.bottom)
    }

    /// The value with a polynomial in place of a variable that is not in the divisor.
    pub fn with(&self, meter: &Meter, place: usize, x: &Polynomial) -> Result<Quotient, Stop> {
        let top = self.top.with(meter, place, x)?;
        Quotient { top, bottom: self.bottom.clone() }.reduced(meter)
    }
}
