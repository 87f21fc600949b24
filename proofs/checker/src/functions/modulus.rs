//! The absolute values of a(z) for |z| = 1.

#![warn(clippy::arithmetic_side_effects)]

use super::call::{Call, wrong};
use super::extremes::extreme;
use super::masks::{Mask, correlations};
use super::real::Real;
use super::roots::square_root;
use super::steps::{add, plus};
use crate::numbers::{Meter, Number, Q, Value, count, int};
use crate::text::Stop;
use num_traits::ToPrimitive as _;
use std::collections::BTreeMap;

/// The greatest denominator of t, since fields end there.
const MAX_DENOMINATOR: usize = 1_000;

/// The value of such a function, if it is known as a number of a field; `None` if the call is none of them.
pub fn of(call: &mut Call<'_>) -> Result<Option<Value>, Stop> {
    real(call)?.map(Real::value).transpose()
}

/// The same as a real number.
pub fn real(call: &mut Call<'_>) -> Result<Option<Real>, Stop> {
    let meter = call.library.meter;
    let upper = match (call.function, call.arguments) {
        ("modulus", [t]) => {
            let mask = Mask::of_numbers(meter, &*call.scheme()?)?;
            let Some(t) = t.rational() else { return wrong("`modulus` takes a rational number") };
            return at(meter, &mask, &t).map(Some);
        }
        ("modulus_lower", []) => false,
        ("modulus_upper", []) => true,
        _ => return Ok(None),
    };
    let mask = Mask::of_numbers(meter, &*call.scheme()?)?;
    // Σ_k g_k cos(kξ) is |a(z)|² at z = e^{iξ}.
    let g = doubled(correlations(meter, &mask.values)?)?;
    root(meter, extreme(meter, (0, &g), upper)?).map(Some)
}

/// The same numbers, twice but for the first one.
fn doubled(mut g: Vec<Value>) -> Result<Vec<Value>, Stop> {
    for c in g.iter_mut().skip(1) {
        *c = c.plus(1, c)?;
    }
    Ok(g)
}

/// √x, as a number of a field if it is one that is known.
fn root(meter: &Meter, x: Real) -> Result<Real, Stop> {
    if let Real::Exact(value) = &x
        && let Some(value) = value.rational()
    {
        match square_root(meter, &value) {
            // Not all square roots are numbers of the fields. A meter that has run out stays so.
            Err(Stop::Capped(_)) => meter.spend(0)?,
            found => return found.map(|root| Real::Exact(root.into())),
        }
    }
    Ok(Real::SquareRoot(Box::new(x)))
}

/// |a(e^{2πit})|.
fn at(meter: &Meter, mask: &Mask, t: &Q) -> Result<Real, Stop> {
    let n = t.denom().to_usize().filter(|n| *n <= MAX_DENOMINATOR);
    let n = n.ok_or(Stop::Capped("the field of the cosines"))?;
    match of_symmetric(meter, mask, t) {
        Ok(Some(value)) => return Ok(Real::Exact(value)),
        Err(Stop::Capped(_)) => meter.spend(0)?,
        found => _ = found?,
    }
    // Powers of z with the same place mod n are equal.
    let mut sums = vec![Value::int(0); n];
    for (place, a) in mask.values.iter().enumerate() {
        if let Some(sum) = place.checked_rem(n).and_then(|place| sums.get_mut(place)) {
            plus(meter, sum, a)?;
        }
    }
    let g = doubled(correlations(meter, &sums)?)?;
    let square = cosines(meter, g.iter().enumerate().map(|(k, g)| (count(k) * t, g)))?;
    root(meter, Real::Exact(square))
}

/// |a(e^{2πit})|, if a_{l+K−k} = ±a_k: with the power of z in the middle divided out, a(z) is a sum of cosines, or i times one of sines.
fn of_symmetric(meter: &Meter, mask: &Mask, t: &Q) -> Result<Option<Value>, Stop> {
    let mut signs = [true; 2];
    for (a, b) in mask.values.iter().zip(mask.values.iter().rev()) {
        signs[0] &= a.equals(b)?;
        signs[1] &= a.plus(1, b)?.is_zero();
    }
    let [symmetric, opposite] = signs;
    if !symmetric && !opposite {
        return Ok(None);
    }
    let half = count(mask.values.len().saturating_sub(1)) / int(2);
    // The sine is the cosine of an angle that is a quarter less.
    let less = if symmetric { int(0) } else { int(1) / int(4) };
    let terms = mask.values.iter().enumerate();
    let sum = cosines(meter, terms.map(|(k, a)| ((count(k) - &half) * t - &less, a)))?;
    sum.abs(None).map(Some)
}

/// Σ g cos(2πx) for these x and g.
fn cosines<'g>(meter: &Meter, terms: impl Iterator<Item = (Q, &'g Value)>) -> Result<Value, Stop> {
    let mut sums = BTreeMap::<Q, Value>::new();
    for (turn, g) in terms {
        meter.spend(1)?;
        if g.is_zero() {
            continue;
        }
        // Both x and 1 − x have this cosine.
        let part = &turn - turn.floor();
        let part = part.clone().min(int(1) - part);
        plus(meter, sums.entry(part).or_insert_with(|| Value::int(0)), g)?;
    }
    let mut total = Value::int(0);
    for (turn, g) in &sums {
        let n = turn.denom().to_u64().map_or(1_000, |n| n.min(1_000));
        meter.spend(n.saturating_mul(n) / 16)?;
        add(meter, &mut total, g, &Number::cosine(turn)?.into())?;
    }
    Ok(total)
}
