//! Polynomials at all integers from one on.

#![warn(clippy::arithmetic_side_effects)]

use super::decimal::{Q, common_multiple, int};
use super::meter::Meter;
use super::value::Value;
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive as _, Zero};
use std::cmp::Ordering;

/// The most integers at which a polynomial is compared.
const MAX_TRIED: usize = 10_000;

/// The greatest degree of a polynomial in an index.
const MAX_DEGREE: u32 = 256;

/// An index whose values are all integers from one on.
#[derive(Clone)]
pub struct Integers {
    /// Its name.
    pub index: String,
    /// The first value.
    pub least: i64,
}

impl Integers {
    /// The polynomial in the index with these coefficients, the constant one first.
    pub fn polynomial(&self, coefficients: Vec<Q>) -> Value {
        Value::polynomial(&self.index, coefficients)
    }

    /// Whether a value is a polynomial in the index with rational coefficients.
    pub fn has(&self, value: &Value) -> bool {
        value.univariate(&self.index).is_some()
    }

    /// Whether a polynomial in the index is shown to be 0 for none of its values.
    pub fn never_zero(&self, meter: &Meter, value: &Value) -> Result<bool, Stop> {
        self.all(meter, value, Ordering::is_ne)
    }

    /// Whether a polynomial in the index is shown to be negative for none of its values.
    pub fn never_negative(&self, meter: &Meter, value: &Value) -> Result<bool, Stop> {
        self.all(meter, value, Ordering::is_ge)
    }

    /// Whether the order of d(t) and 0 is shown to fit for all values t of the index. The roots are below 1 + max |c_i/c_g|.
    pub fn all(
        &self,
        meter: &Meter,
        value: &Value,
        fits: impl Fn(Ordering) -> bool,
    ) -> Result<bool, Stop> {
        if let Ok(number) = value.number() {
            return Ok(fits(number.sign()?.cmp(&0)));
        }
        let mut powers = value.all().flat_map(|(monomial, _)| monomial);
        if powers.any(|(_, power)| *power > MAX_DEGREE) {
            return Err(Stop::Capped("the degree of a polynomial in an index"));
        }
        let Some(coefficients) = value.univariate(&self.index) else { return Ok(false) };
        // A positive multiple with integer coefficients.
        let over = common_multiple(coefficients.iter().map(Q::denom))?;
        let whole: Vec<BigInt> =
            coefficients.iter().map(|c| c.numer() * (&over / c.denom())).collect();
        let Some((leading, lower)) = whole.split_last().filter(|(leading, _)| !leading.is_zero())
        else {
            return Ok(false);
        };
        let greatest = lower.iter().map(|c| Q::new(c.abs(), leading.abs())).max();
        let bound =
            (greatest.unwrap_or_else(Q::zero) + Q::one()).ceil().to_integer() + BigInt::one();
        let at_end = if leading.is_positive() { Ordering::Greater } else { Ordering::Less };
        if !fits(at_end) {
            return Ok(false);
        }
        let count = (bound - int(self.least).to_integer() + BigInt::one()).max(BigInt::zero());
        let count = count.to_usize().filter(|count| *count <= MAX_TRIED);
        let count = count.ok_or(Stop::Capped("the integers at which a polynomial is compared"))?;
        let longest = whole.iter().map(BigInt::bits).max().unwrap_or(0) / 64;
        let terms = whole.len() as u64;
        let steps = terms.saturating_mul((longest.saturating_add(terms) / 16).saturating_add(1));
        for t in (self.least..).take(count) {
            meter.spend(steps)?;
            let value = whole.iter().rev().fold(BigInt::zero(), |sum, c| sum * t + c);
            if !fits(value.cmp(&BigInt::zero())) {
                return Ok(false);
            }
        }
        Ok(true)
    }
}
