//! The sum rules of a family: how often cyclotomic polynomials divide its symbols.

#![warn(clippy::arithmetic_side_effects)]

use crate::functions::call::number;
use crate::functions::steps::{add, plus};
use crate::numbers::{Meter, Value, cyclotomic};
use crate::schemes::{Factor, Family};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{One as _, Zero as _};

const EXACT: Stop = Stop::Family("a cyclotomic polynomial may divide a factor more often");
const LEAST: Stop = Stop::Family("no cyclotomic polynomial divides the symbol least often");
const NONE: Stop = Stop::Family("a symbol has no sum rule");

/// The number of sum rules, which is 1 at least.
pub fn sum_rules(meter: &Meter, family: &Family) -> Result<Value, Stop> {
    if let Some(known) = family.sum_rules.get() {
        return Ok(known.clone());
    }
    let divisors = (2..=family.arity).filter(|d| family.arity.is_multiple_of(*d));
    let orders = divisors.map(|d| order(meter, family, d)).collect::<Result<Vec<Value>, Stop>>()?;
    let least = least(meter, family, &orders)?;
    if !family.integers.never_negative(meter, &least.minus(&Value::int(1))?)? {
        return Err(NONE);
    }
    Ok(family.sum_rules.get_or_init(|| least).clone())
}

/// The one of these that is greater than no other.
fn least(meter: &Meter, family: &Family, orders: &[Value]) -> Result<Value, Stop> {
    for one in orders {
        let mut is_least = true;
        for other in orders {
            let more = other.minus(one)?;
            is_least = is_least && family.integers.never_negative(meter, &more)?;
        }
        if is_least {
            return Ok(one.clone());
        }
    }
    Err(LEAST)
}

/// How often the d-th cyclotomic polynomial divides the symbols.
fn order(meter: &Meter, family: &Family, d: usize) -> Result<Value, Stop> {
    let phi = cyclotomic(u32::try_from(d).map_err(|_| LEAST)?);
    let mut sum = Value::int(0);
    for factor in family.factors.iter().filter(|factor| factor.has_several()) {
        let times = multiplicity(meter, family, factor, &phi)?;
        add(meter, &mut sum, &factor.exponent(&family.integers), &number(times))?;
    }
    Ok(sum)
}

/// How often a cyclotomic polynomial divides a factor, for all values of the index.
fn multiplicity(
    meter: &Meter,
    family: &Family,
    factor: &Factor,
    phi: &[BigInt],
) -> Result<usize, Stop> {
    let (mut rest, mut times) = (factor.dense(), 0_usize);
    loop {
        let (quotient, remainder) = divided(meter, rest, phi)?;
        if remainder.iter().all(Value::is_zero) {
            (rest, times) = (quotient, times.saturating_add(1));
            continue;
        }
        // Not even for one value of the index it divides once more.
        for c in remainder.iter().filter(|c| !c.is_zero()) {
            if matches!(family.integers.never_zero(meter, c), Ok(true)) {
                return Ok(times);
            }
        }
        return Err(EXACT);
    }
}

/// The quotient and the remainder, by a divisor with the leading coefficient 1. The constant coefficients come first.
fn divided(
    meter: &Meter,
    mut p: Vec<Value>,
    divisor: &[BigInt],
) -> Result<(Vec<Value>, Vec<Value>), Stop> {
    let degree = divisor.len().saturating_sub(1);
    let mut quotient = Vec::new();
    for at in (0..p.len().saturating_sub(degree)).rev() {
        let Some(top) = p.pop() else { break };
        let below = p.iter_mut().skip(at).zip(divisor);
        for (c, by) in below.filter(|(_, by)| !by.is_zero()) {
            let by = if by.is_one() { top.negated()? } else { top.times(&value(&-by))? };
            plus(meter, c, &by)?;
        }
        quotient.push(top);
    }
    quotient.reverse();
    Ok((quotient, p))
}

fn value(integer: &BigInt) -> Value {
    crate::numbers::Q::from_integer(integer.clone()).into()
}
