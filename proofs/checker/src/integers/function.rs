//! Functions of an integer: Σ_S f_S Π_{s∈S} √d_s with quotients f_S and polynomials d_s > 0.

#![warn(clippy::arithmetic_side_effects)]

use super::polynomial::{COSINE, H, PI, PLACE, Polynomial, T};
use super::quotient::Quotient;
use super::sign::{Signs, machine};
use crate::numbers::{Meter, Q, int};
use crate::text::Stop;
use std::cell::RefCell;
use std::collections::BTreeMap;

const NORM: Stop = Stop::Integers("a divisor is a sum of square roots that may be 0");
pub const UNKNOWN: Stop = Stop::Integers("a divisor or a number under a root depends on a place");

/// A function. The bits of a key say which square roots stand in a term, of which none is 0.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Function(pub(super) BTreeMap<u8, Quotient>);

impl From<Quotient> for Function {
    fn from(value: Quotient) -> Function {
        let mut parts = BTreeMap::new();
        if !value.is_zero() {
            parts.insert(0, value);
        }
        Function(parts)
    }
}

impl From<Polynomial> for Function {
    fn from(value: Polynomial) -> Function {
        Quotient::from(value).into()
    }
}

impl Function {
    /// An integer.
    pub fn int(value: i64) -> Function {
        Polynomial::int(value).into()
    }

    /// The quotient that it is, if it has no square roots.
    pub fn quotient(&self) -> Option<Quotient> {
        match self.0.first_key_value() {
            None => Some(Quotient::default()),
            Some((0, value)) if self.0.len() == 1 => Some(value.clone()),
            Some(_) => None,
        }
    }

    /// The polynomial that it is, if it is one.
    pub fn polynomial(&self) -> Option<Polynomial> {
        self.quotient().filter(|value| value.bottom.is_empty()).map(|value| value.top)
    }

    /// The number that it is, if it is seen to be one.
    pub fn number(&self) -> Option<Q> {
        self.polynomial()?.number()
    }

    /// The integer that it is, if it is seen to be one.
    pub fn integer(&self) -> Option<i64> {
        machine(&self.number()?)
    }

    /// The greatest exponent of a variable in its dividends.
    pub fn degree(&self, place: usize) -> u16 {
        self.0.values().map(|value| value.top.degree(place)).max().unwrap_or(0)
    }

    /// The coefficients on the powers of a variable that is in no divisor, the constant one first.
    pub fn coefficients(&self, place: usize) -> Vec<Function> {
        let count = usize::from(self.degree(place)).saturating_add(1);
        let mut parts = vec![Function::default(); count];
        for (key, value) in &self.0 {
            for (part, top) in parts.iter_mut().zip(value.top.coefficients(place)) {
                if !top.is_zero() {
                    part.0.insert(*key, Quotient { top, bottom: value.bottom.clone() });
                }
            }
        }
        parts
    }

    /// The function without the terms of a square root, and with them, without it.
    fn parted(&self, bit: u8) -> (Function, Function) {
        let (mut rest, mut with) = (Function::default(), Function::default());
        for (key, value) in &self.0 {
            if key & bit == 0 {
                rest.0.insert(*key, value.clone());
            } else {
                with.0.insert(key ^ bit, value.clone());
            }
        }
        (rest, with)
    }
}

/// Arithmetic of functions.
pub struct Functions<'m> {
    pub signs: Signs<'m>,
    /// The radicands.
    pub(super) roots: RefCell<Vec<Polynomial>>,
}

impl<'m> Functions<'m> {
    /// Functions of all integers from this one on.
    pub fn new(meter: &'m Meter, from: i64) -> Result<Functions<'m>, Stop> {
        Ok(Functions { signs: Signs::new(meter, from)?, roots: RefCell::default() })
    }

    /// The meter of the claim.
    pub fn meter(&self) -> &'m Meter {
        self.signs.meter
    }

    /// The number of square roots.
    pub fn roots(&self) -> usize {
        self.roots.borrow().len()
    }

    /// Forgets the square roots from this number on. No function with them is used afterwards.
    pub fn forget(&self, from: usize) {
        self.roots.borrow_mut().truncate(from);
    }

    /// one + factor·other.
    pub fn sum(&self, one: &Function, factor: i64, other: &Function) -> Result<Function, Stop> {
        let mut sum = one.clone();
        for (key, value) in &other.0 {
            let known = sum.0.remove(key).unwrap_or_default();
            let found = known.plus(self.meter(), factor, value)?;
            if !found.is_zero() {
                sum.0.insert(*key, found);
            }
        }
        Ok(sum)
    }

    /// −x.
    pub fn negated(&self, x: &Function) -> Result<Function, Stop> {
        self.sum(&Function::default(), -1, x)
    }

    /// one · other.
    pub fn product(&self, one: &Function, other: &Function) -> Result<Function, Stop> {
        let mut sum = Function::default();
        for (a, x) in &one.0 {
            for (b, y) in &other.0 {
                let mut term = x.times(self.meter(), y)?;
                for (place, root) in self.roots.borrow().iter().enumerate() {
                    if a & b & (1 << place) != 0 {
                        term = term.times(self.meter(), &root.clone().into())?;
                    }
                }
                let term = Function(BTreeMap::from([(a ^ b, term)]));
                sum = self.sum(&sum, 1, &term)?;
            }
        }
        sum.0.retain(|_, value| !value.is_zero());
        Ok(sum)
    }

    /// x · factor.
    pub fn scaled(&self, x: &Function, factor: &Q) -> Result<Function, Stop> {
        self.product(x, &Polynomial::from(factor.clone()).into())
    }

    /// one / other.
    pub fn quotient(&self, one: &Function, other: &Function) -> Result<Function, Stop> {
        self.product(one, &self.inverse(other)?)
    }

    /// 1/x, where x is 0 for none of the integers.
    fn inverse(&self, x: &Function) -> Result<Function, Stop> {
        if self.sign(x)? == 0 {
            return Err(Stop::Undefined("division by zero"));
        }
        let Some(bit) = self.last(x) else {
            let Some(value) = x.quotient() else { return Err(NORM) };
            if [COSINE, PLACE, PI].iter().any(|place| value.top.degree(*place) > 0) {
                return Err(UNKNOWN);
            }
            return self.turned(&value).map(Function::from);
        };
        // 1/(p + q√d) = (p − q√d)/(p² − q²d).
        let (norm, (rest, with)) = (self.norm(x, bit)?, x.parted(bit));
        if self.sign(&norm)? == 0 {
            return Err(NORM);
        }
        let mut other = self.negated(&with)?.0;
        other = other.into_iter().map(|(key, value)| (key | bit, value)).collect();
        let conjugate = self.sum(&rest, 1, &Function(other))?;
        self.product(&conjugate, &self.inverse(&norm)?)
    }

    /// The inverse of a quotient that has a sign.
    fn turned(&self, value: &Quotient) -> Result<Quotient, Stop> {
        let meter = self.meter();
        let mut top = value.divisor(meter)?;
        let mut bottom = BTreeMap::new();
        let (content, rest) = value.top.primitive(meter)?;
        top = top.scaled(&content.recip());
        let (t, rest) = rest.without(T);
        let (h, rest) = rest.without(H);
        for (place, exponent) in [(T, t), (H, h)] {
            if exponent > 0 {
                bottom.insert(Polynomial::variable(place), u32::from(exponent));
            }
        }
        if let Some(number) = rest.number() {
            top = top.scaled(&number.recip());
        } else {
            let sign = int(i64::from(self.signs.of(&rest)?));
            top = top.scaled(&sign);
            bottom.insert(rest.scaled(&sign), 1);
        }
        Quotient { top, bottom }.reduced(meter)
    }

    /// The bit of the last square root in a function.
    fn last(&self, x: &Function) -> Option<u8> {
        let all = x.0.keys().fold(0, |all, key| all | key);
        (0..self.roots()).rev().map(|place| 1 << place).find(|bit| all & bit != 0)
    }

    /// p² − q²d for p + q√d.
    fn norm(&self, x: &Function, bit: u8) -> Result<Function, Stop> {
        let (rest, with) = x.parted(bit);
        let place = usize::try_from(bit.trailing_zeros()).unwrap_or(usize::MAX);
        let root = self.roots.borrow().get(place).cloned().ok_or(NORM)?;
        let square = self.product(&self.product(&with, &with)?, &root.into())?;
        self.sum(&self.product(&rest, &rest)?, -1, &square)
    }

    /// The sign, if it is the same for all integers.
    pub fn sign(&self, x: &Function) -> Result<i8, Stop> {
        let Some(bit) = self.last(x) else {
            return x.quotient().map_or(Err(NORM), |value| self.signs.of(&value.top));
        };
        let (rest, with) = x.parted(bit);
        let (p, q) = (self.sign(&rest)?, self.sign(&with)?);
        if p == 0 || q == 0 || p == q {
            return Ok(if p == 0 { q } else { p });
        }
        // p and q have opposite signs.
        Ok(match self.sign(&self.norm(x, bit)?)? {
            0 => 0,
            1 => p,
            _ => q,
        })
    }

    /// The sign of left − right.
    pub fn compare(&self, left: &Function, right: &Function) -> Result<i8, Stop> {
        self.sign(&self.sum(left, -1, right)?)
    }

    /// Whether it is 0 for all integers.
    pub fn is_zero(&self, x: &Function) -> Result<bool, Stop> {
        if x.0.is_empty() {
            return Ok(true);
        }
        // Polynomials that are not 0 are not 0 for all integers.
        Ok(self.last(x).is_some() && self.sign(x)? == 0)
    }

    /// The value with a polynomial in place of a variable that is in no divisor.
    pub fn with(&self, x: &Function, place: usize, y: &Polynomial) -> Result<Function, Stop> {
        let mut sum = Function::default();
        for (key, value) in &x.0 {
            let value = value.with(self.meter(), place, y)?;
            if !value.is_zero() {
                sum.0.insert(*key, value);
            }
        }
        Ok(sum)
    }
}
