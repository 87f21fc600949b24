//! Polynomials in an integer t, in h = cos(π/t) and in a few symbols, with rational coefficients.

#![warn(clippy::arithmetic_side_effects)]

use crate::numbers::{Meter, Q, bits, int};
use crate::text::Stop;
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One as _, Signed as _, Zero as _};
use std::collections::BTreeMap;

/// The places of the variables: t, h, a cosine of a multiple of 2π/t, an integer between 6 and t − 6, and π in an angle.
pub const T: usize = 0;
pub const H: usize = 1;
pub const COSINE: usize = 2;
pub const PLACE: usize = 3;
pub const PI: usize = 4;

/// The greatest exponents of the variables.
const MAX_DEGREES: Monomial = [256, 1_024, 1_024, 1_024, 1_024];

/// The most terms.
const MAX_TERMS: usize = 50_000;

/// The most binary digits of a coefficient.
const MAX_BITS: u64 = 50_000;

const SIZE: Stop = Stop::Capped("the size of a polynomial");

/// The exponents of the variables.
type Monomial = [u16; 5];

/// A polynomial. None of its coefficients is 0.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Polynomial(BTreeMap<Monomial, Q>);

impl From<Q> for Polynomial {
    fn from(value: Q) -> Polynomial {
        let mut terms = BTreeMap::new();
        if !value.is_zero() {
            terms.insert(Monomial::default(), value);
        }
        Polynomial(terms)
    }
}

impl Polynomial {
    /// An integer.
    pub fn int(value: i64) -> Polynomial {
        int(value).into()
    }

    /// A variable.
    pub fn variable(place: usize) -> Polynomial {
        let mut monomial = Monomial::default();
        if let Some(exponent) = monomial.get_mut(place) {
            *exponent = 1;
        }
        Polynomial(BTreeMap::from([(monomial, Q::one())]))
    }

    /// The terms.
    pub fn terms(&self) -> impl Iterator<Item = (&Monomial, &Q)> {
        self.0.iter()
    }

    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The number that it is, if it is one.
    pub fn number(&self) -> Option<Q> {
        match self.0.first_key_value() {
            None => Some(Q::zero()),
            Some((monomial, c)) if self.0.len() == 1 && *monomial == Monomial::default() => {
                Some(c.clone())
            }
            _ => None,
        }
    }

    /// The greatest exponent of a variable.
    pub fn degree(&self, place: usize) -> u16 {
        self.0.keys().filter_map(|monomial| monomial.get(place)).copied().max().unwrap_or(0)
    }

    /// The binary digits of its longest coefficient.
    fn longest(&self) -> u64 {
        self.0.values().map(bits).max().unwrap_or(0)
    }

    /// The steps of a sum or product with another polynomial, which are as many as terms that are met.
    fn cost(&self, other: &Polynomial, terms: usize) -> Result<u64, Stop> {
        let (own, others) = (self.longest(), other.longest());
        if own.saturating_add(others) > MAX_BITS || terms > MAX_TERMS.saturating_mul(8) {
            return Err(SIZE);
        }
        // Fractions need common divisors of their parts.
        let limbs = own.saturating_add(others) / 64;
        Ok((terms as u64).saturating_mul((limbs.saturating_mul(limbs) / 16).saturating_add(1)))
    }

    /// Adds factor·other.
    pub fn add(&mut self, meter: &Meter, factor: &Q, other: &Polynomial) -> Result<(), Stop> {
        meter.spend(self.cost(other, other.0.len())?)?;
        if !factor.is_zero() {
            for (monomial, c) in &other.0 {
                self.add_term(*monomial, c * factor);
            }
        }
        if self.0.len() > MAX_TERMS { Err(SIZE) } else { Ok(()) }
    }

    /// self + factor·other.
    pub fn plus(&self, meter: &Meter, factor: i64, other: &Polynomial) -> Result<Polynomial, Stop> {
        let mut sum = self.clone();
        sum.add(meter, &int(factor), other)?;
        Ok(sum)
    }

    fn add_term(&mut self, monomial: Monomial, term: Q) {
        let sum = self.0.entry(monomial).or_insert_with(Q::zero);
        *sum += term;
        if sum.is_zero() {
            self.0.remove(&monomial);
        }
    }

    /// self · factor.
    pub fn scaled(&self, factor: &Q) -> Polynomial {
        if factor.is_zero() {
            return Polynomial::default();
        }
        Polynomial(self.0.iter().map(|(monomial, c)| (*monomial, c * factor)).collect())
    }

    /// self · other.
    pub fn times(&self, meter: &Meter, other: &Polynomial) -> Result<Polynomial, Stop> {
        if let Some(number) = other.number() {
            meter.spend(self.cost(other, self.0.len())?)?;
            return Ok(self.scaled(&number));
        }
        let mut product = Polynomial::default();
        let pairs = self.0.len().saturating_mul(other.0.len());
        meter.spend(self.cost(other, pairs)?.saturating_add(1))?;
        for (left, a) in &self.0 {
            for (right, b) in &other.0 {
                product.add_term(joined(left, right)?, a * b);
            }
        }
        if product.0.len() > MAX_TERMS { Err(SIZE) } else { Ok(product) }
    }

    /// The quotient by a divisor other than 0, if there is one.
    pub fn divided(&self, meter: &Meter, divisor: &Polynomial) -> Result<Option<Polynomial>, Stop> {
        let Some((lead, by)) = divisor.0.last_key_value() else { return Ok(None) };
        let (mut rest, mut quotient) = (self.clone(), Polynomial::default());
        while let Some((top, c)) = rest.0.last_key_value() {
            let Some(monomial) = apart(top, lead) else { return Ok(None) };
            let c = c / by;
            let term = Polynomial(BTreeMap::from([(monomial, c.clone())]));
            let taken = divisor.times(meter, &term)?;
            rest.add(meter, &int(-1), &taken)?;
            quotient.add_term(monomial, c);
        }
        Ok(Some(quotient))
    }

    /// The coefficients on the powers of a variable, the constant one first.
    pub fn coefficients(&self, place: usize) -> Vec<Polynomial> {
        let mut parts =
            vec![Polynomial::default(); usize::from(self.degree(place)).saturating_add(1)];
        for (monomial, c) in &self.0 {
            let mut rest = *monomial;
            let power = rest.get_mut(place).map_or(0, std::mem::take);
            if let Some(part) = parts.get_mut(usize::from(power)) {
                part.0.insert(rest, c.clone());
            }
        }
        parts
    }

    /// The value with a polynomial in place of a variable.
    pub fn with(&self, meter: &Meter, place: usize, x: &Polynomial) -> Result<Polynomial, Stop> {
        let mut sum = Polynomial::default();
        for c in self.coefficients(place).into_iter().rev() {
            sum = sum.times(meter, x)?;
            sum.add(meter, &Q::one(), &c)?;
        }
        Ok(sum)
    }

    /// A positive number and the polynomial, with integer coefficients without a common divisor, of which it is the product.
    pub fn primitive(&self, meter: &Meter) -> Result<(Q, Polynomial), Stop> {
        meter.spend(self.cost(self, self.0.len())?)?;
        let bottom = self.0.values().fold(BigInt::one(), |over, c| over.lcm(c.denom()));
        let whole = |c: &Q| c.numer() * (&bottom / c.denom());
        let top = self.0.values().fold(BigInt::zero(), |common, c| common.gcd(&whole(c)));
        if top.is_zero() {
            return Ok((Q::one(), Polynomial::default()));
        }
        let content = Q::new(top, bottom);
        let rest = self.scaled(&content.recip());
        Ok((content, rest))
    }

    /// The greatest power of a variable that divides it, and the quotient.
    pub fn without(&self, place: usize) -> (u16, Polynomial) {
        let least = self.0.keys().filter_map(|monomial| monomial.get(place)).copied().min();
        let least = least.unwrap_or(0);
        let lowered = |monomial: &Monomial| {
            let mut lower = *monomial;
            if let Some(exponent) = lower.get_mut(place) {
                *exponent = exponent.saturating_sub(least);
            }
            lower
        };
        let terms = self.0.iter().map(|(monomial, c)| (lowered(monomial), c.clone()));
        (least, Polynomial(terms.collect()))
    }

    /// A polynomial whose square this is.
    pub fn square_root(&self, meter: &Meter) -> Result<Option<Polynomial>, Stop> {
        let Some((lead, c)) = self.0.last_key_value() else { return Ok(Some(self.clone())) };
        let (Some(c), true) = (root(c), lead.iter().all(|exponent| exponent % 2 == 0)) else {
            return Ok(None);
        };
        let lead = lead.map(|exponent| exponent / 2);
        let twice = &c * int(2);
        let mut found = Polynomial(BTreeMap::from([(lead, c)]));
        let mut rest = self.plus(meter, -1, &found.times(meter, &found)?)?;
        // The terms of the root are found from the highest one on.
        let mut last = lead;
        while let Some((top, c)) = rest.0.last_key_value() {
            let Some(next) = apart(top, &lead).filter(|next| *next < last) else { return Ok(None) };
            let term = Polynomial(BTreeMap::from([(next, c / &twice)]));
            let sum = found.plus(meter, 1, &found)?.plus(meter, 1, &term)?;
            rest.add(meter, &int(-1), &sum.times(meter, &term)?)?;
            found.add(meter, &Q::one(), &term)?;
            last = next;
        }
        Ok(Some(found))
    }

    /// T_n(x), the Chebyshev polynomial of this degree.
    pub fn chebyshev(meter: &Meter, n: u64, x: &Polynomial) -> Result<Polynomial, Stop> {
        let twice = x.scaled(&int(2));
        let (mut value, mut next) = (Polynomial::int(1), x.clone());
        for _ in 0..n {
            let later = twice.times(meter, &next)?.plus(meter, -1, &value)?;
            value = std::mem::replace(&mut next, later);
        }
        Ok(value)
    }
}

/// The rational square root, if there is one.
fn root(x: &Q) -> Option<Q> {
    if x.is_negative() {
        return None;
    }
    let [top, bottom] = [x.numer(), x.denom()].map(BigInt::sqrt);
    let found = Q::new(top, bottom);
    (&found * &found == *x).then_some(found)
}

/// The product of two monomials.
fn joined(left: &Monomial, right: &Monomial) -> Result<Monomial, Stop> {
    let mut product = *left;
    for ((exponent, more), most) in product.iter_mut().zip(right).zip(MAX_DEGREES) {
        *exponent = exponent.saturating_add(*more);
        if *exponent > most {
            return Err(SIZE);
        }
    }
    Ok(product)
}

/// The quotient of two monomials, if there is one.
fn apart(top: &Monomial, by: &Monomial) -> Option<Monomial> {
    let mut quotient = *top;
    for (exponent, less) in quotient.iter_mut().zip(by) {
        *exponent = exponent.checked_sub(*less)?;
    }
    Some(quotient)
}
