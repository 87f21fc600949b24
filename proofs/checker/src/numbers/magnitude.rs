//! Products of powers of positive numbers, compared with 1.

use super::decimal::Q;
use crate::text::Stop;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Pow, Signed};
use std::cmp::Ordering;

/// The binary digits of a mantissa.
const DIGITS: i64 = 256;

/// The greatest absolute value of an exponent.
const MAX_EXPONENT: u64 = 1 << 48;

/// The most binary digits of powers that are computed exactly.
const MAX_BITS: u64 = 1 << 20;

/// m·2^e, m > 0. Exponents of powers are at most 2^48 and numbers have fewer than 2^64 digits, so that e is far
/// below 2^127.
#[derive(Clone)]
struct Float(BigInt, i128);

/// Two floats, between which a number is.
#[derive(Clone)]
struct Magnitude([Float; 2]);

/// How Π x^e compares with 1, for x > 0 and integers e.
pub fn compare(powers: &[(Q, BigInt)]) -> Result<Ordering, Stop> {
    let mut product = Magnitude::of(&Q::one());
    let mut bits = 0_u64;
    for (x, exponent) in powers {
        let size = exponent.magnitude().try_into().ok().filter(|e| *e <= MAX_EXPONENT);
        let size: u64 = size.ok_or(Stop::Capped("the size of an exponent"))?;
        let base = if exponent.is_negative() { x.recip() } else { x.clone() };
        bits = bits.saturating_add(size.saturating_mul(x.numer().bits() + x.denom().bits()));
        product = product.times(&Magnitude::of(&base).power(size));
    }
    if let Some(order) = product.order() {
        return Ok(order);
    }
    if bits > MAX_BITS {
        return Err(Stop::Capped("the size of a power"));
    }
    let powers = powers.iter().map(|(x, exponent)| {
        let base = if exponent.is_negative() { x.recip() } else { x.clone() };
        let size = exponent.magnitude();
        Q::new(Pow::pow(base.numer(), size), Pow::pow(base.denom(), size))
    });
    Ok(powers.fold(Q::one(), |product, power| product * power).cmp(&Q::one()))
}

impl Magnitude {
    fn of(x: &Q) -> Magnitude {
        let bits = |x: &BigInt| i64::try_from(x.bits()).unwrap_or(i64::MAX);
        let places = DIGITS + bits(x.denom()) - bits(x.numer());
        let scaled = if places >= 0 {
            Q::new(x.numer() << places, x.denom().clone())
        } else {
            Q::new(x.numer().clone(), x.denom() << -places)
        };
        let ends = [scaled.floor(), scaled.ceil()];
        Magnitude(ends.map(|end| Float(end.to_integer(), i128::from(-places))))
    }

    fn times(&self, other: &Magnitude) -> Magnitude {
        let end = |i: usize| {
            let Float(m, e) = &self.0[i];
            let Float(n, f) = &other.0[i];
            let (product, exponent) = (m * n, e + f);
            let excess = i64::try_from(product.bits()).unwrap_or(i64::MAX) - DIGITS;
            if excess <= 0 {
                return Float(product, exponent);
            }
            // The lower end is rounded down, the upper one up.
            let unit = BigInt::one() << excess;
            let cut = if i == 0 { product.div_floor(&unit) } else { product.div_ceil(&unit) };
            Float(cut, exponent + i128::from(excess))
        };
        Magnitude([end(0), end(1)])
    }

    fn power(&self, mut exponent: u64) -> Magnitude {
        let (mut power, mut square) = (Magnitude::of(&Q::one()), self.clone());
        while exponent > 0 {
            if exponent % 2 == 1 {
                power = power.times(&square);
            }
            exponent /= 2;
            if exponent > 0 {
                square = square.times(&square);
            }
        }
        power
    }

    /// How the number compares with 1, where both ends say the same.
    fn order(&self) -> Option<Ordering> {
        let [low, high] = self.0.each_ref().map(|Float(m, e)| {
            let place = i128::from(m.bits()) + e;
            // m·2^e is from 2^(place − 1) to below 2^place.
            let one = place == 1 && *m == BigInt::one() << (m.bits() - 1);
            if one { Ordering::Equal } else { place.cmp(&1).then(Ordering::Greater) }
        });
        (low == high && low != Ordering::Equal).then_some(low)
    }
}
