//! Quotients of polynomials in t and h.

use super::sign::sign_from;
use crate::exact::{Polynomial, Rational, RealCyclotomic};
use std::cmp::Ordering;

/// p/q, where q is 0 for no integer t that counts.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Quotient {
    pub(super) numerator: Polynomial,
    /// With 1 as the leading coefficient.
    pub(super) denominator: Polynomial,
}

impl From<Polynomial> for Quotient {
    fn from(numerator: Polynomial) -> Quotient {
        Quotient { numerator, denominator: Polynomial::constant(1) }
    }
}

impl Quotient {
    pub(super) fn constant(value: &Rational) -> Quotient {
        Quotient::from(Polynomial::constant(value.clone()))
    }

    /// p/q without a common monomial, and a polynomial where q divides p. The caller knows that q is 0 for no t that counts.
    pub(super) fn new(numerator: &Polynomial, denominator: &Polynomial) -> Quotient {
        if let Some(whole) = numerator.exactly_over(denominator) {
            return Quotient::from(whole);
        }
        let common = Polynomial::common_monomial([numerator, denominator]);
        let scale = &Polynomial::constant(denominator.leading_coefficient()) * &common;
        let over = |p: &Polynomial| p.exactly_over(&scale).unwrap_or_else(|| p.clone());
        Quotient { numerator: over(numerator), denominator: over(denominator) }
    }

    pub(super) fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    pub(super) fn as_constant(&self) -> Option<Rational> {
        self.denominator.as_constant()?;
        self.numerator.as_constant()?.as_rational().cloned()
    }

    pub(super) fn term_count(&self) -> usize {
        self.numerator.term_count() + self.denominator.term_count()
    }

    pub(super) fn sign_from(&self, first: i64) -> Option<Ordering> {
        let denominator = sign_from(&self.denominator, first)?;
        let numerator = sign_from(&self.numerator, first)?;
        match denominator {
            Ordering::Greater => Some(numerator),
            Ordering::Less => Some(numerator.reverse()),
            Ordering::Equal => None,
        }
    }

    pub(super) fn plus(&self, other: &Quotient) -> Quotient {
        let (p, q) = (&self.numerator, &self.denominator);
        let (r, s) = (&other.numerator, &other.denominator);
        if q == s {
            return Quotient::new(&(p + r), q);
        }
        if let Some(factor) = s.exactly_over(q) {
            return Quotient::new(&(&(p * &factor) + r), s);
        }
        if let Some(factor) = q.exactly_over(s) {
            return Quotient::new(&(p + &(r * &factor)), q);
        }
        Quotient::new(&(&(p * s) + &(r * q)), &(q * s))
    }

    pub(super) fn times(&self, other: &Quotient) -> Quotient {
        let [first, second] = [(self, other), (other, self)]
            .map(|(one, two)| Quotient::new(&one.numerator, &two.denominator));
        Quotient::new(
            &(&first.numerator * &second.numerator),
            &(&first.denominator * &second.denominator),
        )
    }

    pub(super) fn negated(&self) -> Quotient {
        let minus = Polynomial::constant(RealCyclotomic::from(-1));
        Quotient { numerator: &self.numerator * &minus, denominator: self.denominator.clone() }
    }

    /// 1/self, if this is shown to be 0 for no t ≥ `first`.
    pub(super) fn inverse_from(&self, first: i64) -> Option<Quotient> {
        self.sign_from(first).filter(|sign| sign.is_ne())?;
        Some(Quotient::new(&self.denominator, &self.numerator))
    }
}
