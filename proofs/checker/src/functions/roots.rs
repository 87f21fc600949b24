//! Square roots of rational numbers as sums of cosines, and rational roots.

#![warn(clippy::arithmetic_side_effects)]

use crate::enclosures::{Interval, Sturm};
use crate::numbers::{Meter, Number, Q, Value};
use crate::text::Stop;
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One as _, Signed as _, ToPrimitive as _, Zero as _};

/// The greatest prime number under a root; the field of √p is that of p or 4p.
const MAX_PRIME: u32 = 1_000;

/// The binary digits to which roots are enclosed.
const DIGITS: u64 = 256;

const FIELD: Stop = Stop::Capped("the field of a square root");

/// √x, for a rational x ≥ 0: with x = s²t and t a product of different primes, s·Π√p.
pub fn square_root(meter: &Meter, x: &Q) -> Result<Number, Stop> {
    if x.is_negative() {
        return Err(Stop::Undefined("it is the square root of a negative number"));
    }
    let (mut rest, bottom) = (x.numer() * x.denom(), x.denom().clone());
    if rest.is_zero() {
        return Ok(Number::Small(0, 1));
    }
    let whole = rest.sqrt();
    if &whole * &whole == rest {
        return Ok(Q::new(whole, bottom).into());
    }
    let (mut factor, mut root) = (BigInt::one(), Number::Small(1, 1));
    for p in 2..=MAX_PRIME {
        meter.spend(1)?;
        let prime = BigInt::from(p);
        let mut odd = false;
        // What is left has no divisor below p, so that p is prime if it divides it.
        while rest.is_multiple_of(&prime) {
            rest /= &prime;
            odd = !odd;
            if !odd {
                factor *= &prime;
            }
        }
        if odd {
            meter.spend(u64::from(p).saturating_mul(64))?;
            root = root.times(&root_of_prime(p)?)?;
        }
    }
    let whole = rest.sqrt();
    if &whole * &whole != rest {
        return Err(FIELD);
    }
    root.times(&Q::new(factor * whole, bottom).into())
}

/// √p by Gauss's sum Σ (a/p) e^{2πia/p}, which is √p for p ≡ 1 mod 4, and i√p for p ≡ 3.
fn root_of_prime(p: u32) -> Result<Number, Stop> {
    let cosine = |top: i64, bottom: u32| Number::cosine(&Q::new(top.into(), bottom.into()));
    if p == 2 {
        return cosine(1, 8)?.times(&Number::Small(2, 1));
    }
    let p64 = u64::from(p);
    let is_square = |a: u64| (1..p64).any(|b| b.saturating_mul(b).checked_rem(p64) == Some(a));
    let mut sum = Number::Small(0, 1);
    for a in 1..p64 {
        let sign = if is_square(a) { 1 } else { -1 };
        let turn = Q::new(a.into(), p64.into());
        // sin t = cos(t − π/2).
        let turn = if p.rem_euclid(4) == 1 { turn } else { turn - Q::new(1.into(), 4.into()) };
        let n = turn.denom().to_u32();
        if n.is_none_or(|n| n > MAX_PRIME) {
            return Err(FIELD);
        }
        sum = sum.plus(sign, &Number::cosine(&turn)?)?;
    }
    Ok(sum)
}

/// The real root of this number, if it is rational, or ±√x of a rational x.
pub fn root(meter: &Meter, coefficients: &[Value], number: i64) -> Result<Value, Stop> {
    let rational: Option<Vec<Q>> = coefficients.iter().map(Value::rational).collect();
    let other = || Stop::OtherRoot;
    let rational = rational.ok_or_else(other)?;
    if let [c, b, a] = &rational[..]
        && b.is_zero()
        && !a.is_zero()
        && (c / a).is_negative()
        && matches!(number, 1 | 2)
    {
        let root: Value = square_root(meter, &-(c / a))?.into();
        return if number == 2 { Ok(root) } else { root.negated() };
    }
    let near: Result<Vec<Interval>, Stop> = rational.into_iter().map(Interval::point).collect();
    let root = Sturm::new(&near?, DIGITS, meter)?.root(number)?;
    root.exact().map(|root| root.clone().into()).ok_or_else(other)
}
