//! Real numbers of the fields Q(2cos(2π/n)).

use super::decimal::Q;
use super::element::{Element, sign};
use super::field::{chebyshev, multiply};
use super::polynomial::signum;
use crate::text::Stop;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, ToPrimitive, Zero};
use std::cmp::Ordering;

/// The greatest n of a field Q(2cos(2π/n)).
const MAX_FIELD: u32 = 1_000;

/// A number. It has exactly one form, so that numbers are equal if their forms are.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Number {
    /// A fraction of machine integers in lowest terms, with a positive denominator. Most numbers
    /// have this form.
    Small(i64, i64),
    /// Any other number.
    Large(Box<Element>),
}

impl From<Q> for Number {
    fn from(value: Q) -> Number {
        let (top, bottom) = value.into();
        Number::lowest(1, vec![top], bottom)
    }
}

impl From<i128> for Number {
    fn from(value: i128) -> Number {
        fraction(value, 1)
    }
}

/// top/bottom, for a positive denominator.
fn fraction(top: i128, bottom: i128) -> Number {
    if let (Ok(top), Ok(bottom)) = (i64::try_from(top), i64::try_from(bottom)) {
        // A divisor of the denominator is a machine integer too.
        let common = if bottom == 1 { 1 } else { top.unsigned_abs().gcd(&bottom.unsigned_abs()) };
        let common = i64::try_from(common).unwrap_or(1);
        return Number::Small(top / common, bottom / common);
    }
    let common = if bottom == 1 { 1 } else { top.gcd(&bottom) };
    Number::lowest(1, vec![(top / common).into()], (bottom / common).into())
}

impl Number {
    /// A number of the field of n, from integers over a positive denominator.
    fn new(mut n: u32, mut top: Vec<BigInt>, mut bottom: BigInt) -> Number {
        if top[1..].iter().all(Zero::is_zero) {
            top.truncate(1);
            n = 1;
        }
        if !bottom.is_one() {
            let common = top.iter().fold(bottom.clone(), |a, b| match (a.to_u64(), b.to_i64()) {
                (Some(a), Some(b)) => a.gcd(&b.unsigned_abs()).into(),
                // The divisor may be far shorter.
                _ => a.gcd(&(b % &a)),
            });
            for coefficient in &mut top {
                *coefficient /= &common;
            }
            bottom /= common;
        }
        Number::lowest(n, top, bottom)
    }

    /// A number from integers and a denominator in lowest terms.
    fn lowest(n: u32, top: Vec<BigInt>, bottom: BigInt) -> Number {
        match (top[0].to_i64(), bottom.to_i64()) {
            (Some(top), Some(bottom)) if n == 1 => Number::Small(top, bottom),
            _ => Number::Large(Box::new(Element { n, top, bottom })),
        }
    }

    /// The coordinates of the number.
    fn element(&self) -> Element {
        match self {
            Number::Large(element) => (**element).clone(),
            &Number::Small(top, bottom) => {
                Element { n: 1, top: vec![top.into()], bottom: bottom.into() }
            }
        }
    }

    /// cos(2π·turn).
    pub fn cosine(turn: &Q) -> Result<Number, Stop> {
        let n = turn.denom().to_u32().filter(|n| *n <= MAX_FIELD);
        let n = n.ok_or(Stop::Capped("the field of the cosines"))?;
        let p = (turn - turn.floor()).numer().to_u32().unwrap_or(0);
        if n < 3 {
            return Ok(Number::Small(if p == 0 { 1 } else { -1 }, 1));
        }
        let double = chebyshev(n, p.min(n - p));
        Ok(Number::new(n, double, BigInt::from(2)))
    }

    /// Both numbers in one field.
    fn together(&self, other: &Number) -> Result<(Element, Element), Stop> {
        let (one, other) = (self.element(), other.element());
        let n = one.n.lcm(&other.n);
        if n > MAX_FIELD {
            return Err(Stop::Capped("the field of the cosines"));
        }
        Ok((one.lifted(n), other.lifted(n)))
    }

    /// self + factor·other.
    pub fn plus(&self, factor: i64, other: &Number) -> Result<Number, Stop> {
        if let (&Number::Small(a, b), &Number::Small(c, d)) = (self, other) {
            let [a, b, c, d] = [a, b, c, d].map(i128::from);
            let c = c * i128::from(factor);
            if b == d {
                return Ok(fraction(a + c, b));
            }
            if let Some(top) = c.checked_mul(b).and_then(|right| right.checked_add(a * d)) {
                return Ok(fraction(top, b * d));
            }
        }
        let (one, other) = self.together(other)?;
        let (p, q) = (&one.bottom, &other.bottom);
        let pairs = one.top.iter().zip(&other.top);
        let top = pairs.map(|(a, b)| if p == q { a + b * factor } else { a * q + b * p * factor });
        Ok(Number::new(one.n, top.collect(), if p == q { p.clone() } else { p * q }))
    }

    /// self · other.
    pub fn times(&self, other: &Number) -> Result<Number, Stop> {
        if let (&Number::Small(a, b), &Number::Small(c, d)) = (self, other) {
            let [a, b, c, d] = [a, b, c, d].map(i128::from);
            return Ok(fraction(a * c, b * d));
        }
        let (one, other) = self.together(other)?;
        let top = multiply(one.n, &one.top, &other.top);
        Ok(Number::new(one.n, top, one.bottom * other.bottom))
    }

    /// 1/self, for self ≠ 0.
    pub fn inverse(&self) -> Option<Number> {
        if let &Number::Small(top, bottom) = self {
            let [top, bottom] = [top, bottom].map(i128::from);
            return (top != 0).then(|| fraction(bottom * top.signum(), top.abs()));
        }
        let Element { n, top, bottom } = self.element().inverse()?;
        Some(Number::new(n, top, bottom))
    }

    /// The sign: −1, 0 or 1.
    pub fn sign(&self) -> Result<i8, Stop> {
        match self {
            Number::Small(top, _) => Ok(signum(top)),
            Number::Large(element) => sign(element.n, &element.top),
        }
    }

    /// How two numbers compare.
    pub fn compare(&self, other: &Number) -> Result<Ordering, Stop> {
        if let (&Number::Small(a, b), &Number::Small(c, d)) = (self, other) {
            return Ok((i128::from(a) * i128::from(d)).cmp(&(i128::from(c) * i128::from(b))));
        }
        let (one, other) = self.together(other)?;
        let pairs = one.top.iter().zip(&other.top);
        let off: Vec<BigInt> = pairs.map(|(a, b)| a * &other.bottom - b * &one.bottom).collect();
        Ok(sign(one.n, &off)?.cmp(&0))
    }

    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        *self == Number::Small(0, 1)
    }

    /// The rational number that this is; `None` if it is irrational.
    pub fn rational(&self) -> Option<Q> {
        match self {
            &Number::Small(top, bottom) => Some(Q::new_raw(top.into(), bottom.into())),
            Number::Large(element) if element.n > 1 => None,
            Number::Large(element) => {
                Some(Q::new_raw(element.top[0].clone(), element.bottom.clone()))
            }
        }
    }

    /// Whether it is a fraction of machine integers.
    pub fn is_small(&self) -> bool {
        matches!(self, Number::Small(..))
    }

    /// The machine integer that this is; `None` if it is no such integer.
    pub fn integer(&self) -> Option<i128> {
        match self {
            Number::Small(value, 1) => Some((*value).into()),
            Number::Large(element) if element.n == 1 && element.bottom.is_one() => {
                element.top[0].to_i128()
            }
            _ => None,
        }
    }

    /// The n of the field, and the rational coordinates on 1, x, x², …
    pub fn coordinates(&self) -> (u32, Vec<Q>) {
        let Element { n, top, bottom } = self.element();
        (n, top.into_iter().map(|c| Q::new(c, bottom.clone())).collect())
    }

    /// The denominator.
    pub fn bottom(&self) -> BigInt {
        self.element().bottom
    }

    /// The greatest integer that is not above it.
    pub fn floor(&self) -> Result<BigInt, Stop> {
        if let Some(value) = self.rational() {
            return Ok(value.floor().to_integer());
        }
        self.element().floor()
    }

    /// An estimate of the steps of a sum with it: those of the common divisors of its numerators and its denominator.
    pub fn cost_of_sum(&self) -> u64 {
        match self {
            Number::Large(element) if !element.bottom.is_one() => {
                let (limbs, bottom) = (self.bits() / 64, element.bottom.bits() / 64);
                1 + limbs * bottom / 16
            }
            _ => 0,
        }
    }

    /// An estimate of the steps of a quotient by it: linear equations for as many unknowns as the degree of its field.
    pub fn cost_of_inverse(&self) -> u64 {
        match self {
            Number::Large(element) if element.n > 1 => {
                let degree = element.top.len() as u64;
                degree.pow(3) * (1 + self.bits() / 1024)
            }
            _ => self.cost_of_sum(),
        }
    }

    /// How many coordinates it has.
    pub fn degree(&self) -> u64 {
        self.field().1
    }

    /// The n of its field, and how many coordinates it has there.
    fn field(&self) -> (u32, u64) {
        match self {
            Number::Small(..) => (1, 1),
            Number::Large(element) => (element.n, element.top.len() as u64),
        }
    }

    /// An estimate of the steps of a product in the common field: coordinates with coordinates, for the product and to take
    /// each number to this field.
    pub fn cost_in_field(&self, other: &Number) -> u64 {
        let (one, other) = (self.field(), other.field());
        if one.0 == other.0 {
            return if one.0 == 1 { 0 } else { one.1.saturating_mul(one.1) };
        }
        let n = u64::from(one.0.lcm(&other.0).min(MAX_FIELD));
        let degree = [one, other].into_iter().find(|(m, _)| u64::from(*m) == n);
        let degree = degree.map_or(n / 2, |(_, degree)| degree);
        let lifted = |(m, known): (u32, u64)| if m == 1 || u64::from(m) == n { 0 } else { known };
        let products = lifted(one).saturating_add(lifted(other)).saturating_add(1);
        degree.saturating_mul(degree).saturating_mul(products)
    }

    /// The size in binary digits.
    pub fn bits(&self) -> u64 {
        match self {
            Number::Small(top, bottom) => {
                (128 - top.unsigned_abs().leading_zeros() - bottom.leading_zeros()).into()
            }
            Number::Large(element) => {
                element.top.iter().map(BigInt::bits).sum::<u64>() + element.bottom.bits()
            }
        }
    }
}
