//! Whether limits keep the sign of the m-th differences of data: positivity, monotonicity, convexity.
//!
//! With b(z) = a(z)/σ(z)^m, σ(z) = 1 + z + … + z^{n−1}, the m-th differences of data G(z) become c_j(z)G(z^{n^j}) in j
//! steps, c_j(z) = b(z)b(z^n)⋯b(z^{n^{j−1}}). Those of the limit, at the distance n^{−j}, are Φ(z)c_j(z)G(z^{n^j}), where Φ(z) =
//! Σ_i φ(i)z^i.

#![warn(clippy::arithmetic_side_effects)]

use super::call::Call;
use super::limits::{exists, piece_of, values};
use super::masks::{self, Mask};
use super::shape_on::{LENGTH, MAX_COEFFICIENTS, keeps_on};
use crate::numbers::{Meter, Q, Value, common_multiple};
use crate::schemes::{Library, Scheme};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{One as _, Signed as _, Zero as _};

/// The value of `positive`, `monotone` or `convex`.
pub fn of(call: &mut Call<'_>) -> Result<Value, Stop> {
    let m = ["positive", "monotone", "convex"].iter().position(|name| *name == call.function);
    let (scheme, m) = (call.scheme()?, m.unwrap_or(0));
    let keeps = match piece_of(&scheme, call.piece()) {
        None => keeps(call.library, &scheme, m)?,
        Some(piece) => keeps_on(call.library, &scheme, m, piece)?,
    };
    Ok(Value::int(keeps.into()))
}

/// Whether φ ≥ 0 is known.
pub fn is_positive(library: &Library<'_>, scheme: &Scheme) -> Result<bool, Stop> {
    match keeps(library, scheme, 0) {
        // What no level decides is not known. A meter that has run out stops what follows.
        Err(Stop::Capped(_)) => library.meter.spend(0).map(|()| false),
        found => found,
    }
}

/// Whether the limits of all data whose m-th differences are not negative have this property too.
fn keeps(library: &Library<'_>, scheme: &Scheme, m: usize) -> Result<bool, Stop> {
    let meter = library.meter;
    let mask = Mask::of_numbers(meter, scheme)?;
    let a = integers(meter, &mask.values)?;
    exists(library, scheme, None)?;
    let limit = || integers(meter, &values(library, scheme, None)?);
    let Some(b) = divided(meter, &a, mask.arity, m)? else {
        return bends(meter, (&a, mask.arity), &limit()?, m);
    };
    let mut differences = b.clone();
    loop {
        // If no c_j has a negative coefficient, nor have c_{2j}, c_{3j}, …, and the limit of these levels has the property.
        if !differences.iter().any(BigInt::is_negative) {
            return Ok(true);
        }
        if product(meter, (&differences, 1), &limit()?)?.iter().any(BigInt::is_negative) {
            return Ok(false);
        }
        // c_{j+1}(z) = c_j(z^n)b(z).
        differences = product(meter, (&differences, mask.arity), &b)?;
    }
}

/// What is known where σ² does not divide a(z). The limit of the data k is x and a function of period 1. Its second differences
/// at the distance n^{−j} sum to 0 over a period: if they are not all 0, some are negative. They are all 0 if and only if
/// σ(z)²σ(z^n)²⋯ divides a(z)a(z^n)⋯Φ(z), with j factors each. This is possible for all j, since the functions φ(x − i) need not
/// be independent.
fn bends(
    meter: &Meter,
    (a, n): (&[BigInt], usize),
    limit: &[BigInt],
    m: usize,
) -> Result<bool, Stop> {
    let (mut refined, mut classes) = (a.to_vec(), n);
    while divided(meter, &product(meter, (&refined, 1), limit)?, classes, m)?.is_some() {
        refined = product(meter, (&refined, n), a)?;
        classes = classes.saturating_mul(n);
    }
    Ok(false)
}

fn words(x: &BigInt) -> u64 {
    (x.bits() / 64).saturating_add(1)
}

/// A positive multiple of rational numbers that consists of integers.
fn integers(meter: &Meter, values: &[Value]) -> Result<Vec<BigInt>, Stop> {
    let rational: Option<Vec<Q>> = values.iter().map(Value::rational).collect();
    let rational = rational.ok_or(Stop::Capped("the shape of a mask that is not rational"))?;
    let square = |words: u64| words.saturating_mul(words);
    let mut over = BigInt::one();
    for x in &rational {
        meter.spend(square(words(&over).saturating_add(words(x.denom()))))?;
        over = common_multiple([&over, x.denom()])?;
    }
    let steps = (square(words(&over)) / 16).saturating_add(1);
    meter.spend(steps.saturating_mul(rational.len() as u64))?;
    Ok(rational.iter().map(|x| x.numer() * (&over / x.denom())).collect())
}

/// p/(1 + z + … + z^{n−1})^m, if that is a polynomial.
fn divided(meter: &Meter, p: &[BigInt], n: usize, m: usize) -> Result<Option<Vec<BigInt>>, Stop> {
    let p: Vec<Value> = p.iter().map(|c| Q::from_integer(c.clone()).into()).collect();
    let found = masks::divided(meter, &p, (n, m), None)?;
    found.map(|quotient| integers(meter, &quotient)).transpose()
}

/// p(z^s)q(z).
fn product(meter: &Meter, (p, s): (&[BigInt], usize), q: &[BigInt]) -> Result<Vec<BigInt>, Stop> {
    let last = |length: usize| length.saturating_sub(1);
    let length = last(p.len()).saturating_mul(s).saturating_add(q.len());
    if s > 1 && length > MAX_COEFFICIENTS {
        return Err(LENGTH);
    }
    let longest = q.iter().map(words).max().unwrap_or(1);
    let mut sums = vec![BigInt::zero(); length];
    for (place, x) in (0..).step_by(s).zip(p) {
        meter.spend(words(x).saturating_mul(longest).saturating_mul(q.len() as u64))?;
        for (sum, y) in sums.iter_mut().skip(place).zip(q) {
            *sum += x * y;
        }
    }
    Ok(sums)
}
