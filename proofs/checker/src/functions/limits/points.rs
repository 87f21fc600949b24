//! Values of a limit φ and its derivatives at points, and integrals between points.

#![warn(clippy::arithmetic_side_effects)]

use super::existing::{exists, values};
use super::integers::{PLACE, at_integers, window};
use super::related::{antiderivative, derived};
use crate::functions::call::number;
use crate::functions::masks::{Mask, signed};
use crate::functions::steps::{add, plus};
use crate::numbers::{Meter, Piece, Q, Value, int};
use crate::schemes::{Library, Scheme};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{ToPrimitive as _, Zero as _};
use std::rc::Rc;

/// The highest level of the points at which φ is evaluated.
const MAX_LEVEL: usize = 64;

/// The most binary digits of n^64, since n is at most 64.
const MAX_BITS: u64 = 385;

/// A point x = w + f: the integer w, and the digits of f to the base n.
type Point = (BigInt, Vec<i64>);

/// The values at f + m for the integers m from the first one on. They are 0 for all other m.
type Row = (i64, Vec<Value>);

/// φ^{(m)}(x) = Σ_{i≤m} (−1)^i binomial(m, i) ψ(x − i), where xn^k is an integer for some k up to a cap.
pub fn derivative(
    library: &Library<'_>,
    (scheme, piece): (&Rc<Scheme>, Option<&Piece<'_>>),
    x: &Value,
    order: usize,
) -> Result<Value, Stop> {
    exists(library, scheme, piece)?;
    let scheme = match order {
        0 => Rc::clone(scheme),
        _ => derived(library, (scheme, piece), order)?,
    };
    let known = values(library, &scheme, piece)?;
    let mask = Mask::on(library.meter, &scheme, piece)?;
    let (whole, row) = at(library.meter, &mask, &known, x)?;
    let (mut sum, mut place, mut factor) = (Value::int(0), whole, Value::int(1));
    for i in 0..=order {
        add(library.meter, &mut sum, &factor, &of(&row, &place))?;
        place -= 1;
        // −binomial(m, i)(m − i)/(i + 1).
        let rest = number(order.saturating_sub(i)).negated()?;
        factor = factor.times(&rest)?.over(&number(i.saturating_add(1)))?;
    }
    Ok(sum)
}

/// ∫_x^y φ(t) dt = Σ_{j≥0} (χ(y − j) − χ(x − j)).
pub fn integral(
    library: &Library<'_>,
    (scheme, piece): (&Scheme, Option<&Piece<'_>>),
    [x, y]: [&Value; 2],
) -> Result<Value, Stop> {
    exists(library, scheme, piece)?;
    let (meter, own) = (library.meter, Mask::on(library.meter, scheme, piece)?);
    let scheme = antiderivative(library, scheme, piece)?;
    let mask = Mask::on(meter, &scheme, piece)?;
    let below = |x: &Value| {
        if let Some(side) = beyond(meter, &own, x)?.filter(|_| piece.is_some()) {
            return Ok(side);
        }
        let known = match piece {
            None => values(library, &scheme, None)?,
            // As for numbers, its existence needs no levels of its own.
            Some(_) => at_integers(meter, &mask, piece)?.into(),
        };
        let (whole, (first, values)) = at(meter, &mask, &known, x)?;
        let count = whole - first + 1_i64;
        let count = if count < BigInt::zero() { 0 } else { count.to_usize().unwrap_or(usize::MAX) };
        let mut sum = Value::int(0);
        for value in values.iter().take(count) {
            plus(library.meter, &mut sum, value)?;
        }
        Ok::<Value, Stop>(sum)
    };
    below(y)?.minus(&below(x)?)
}

/// The integral over all numbers below x, if x is not between the ends of the support. It is 0 or 1, and needs no values at the integers.
fn beyond(meter: &Meter, mask: &Mask, x: &Value) -> Result<Option<Value>, Stop> {
    point(meter, x, mask.arity)?;
    let place = x.number()?.rational().ok_or(PLACE)? * int(signed(mask.arity)?.saturating_sub(1));
    let is_below = place <= int(mask.first);
    let is_above = place >= int(mask.last()?);
    Ok((is_below || is_above).then(|| Value::int(i64::from(!is_below))))
}

/// The value of a row at a place.
fn of((first, values): &Row, place: &BigInt) -> Value {
    let place = (place - first).to_usize();
    place.and_then(|place| values.get(place)).cloned().unwrap_or_else(|| Value::int(0))
}

/// The integer w below x, and the values at x − w + m.
fn at(meter: &Meter, mask: &Mask, known: &[Value], x: &Value) -> Result<(BigInt, Row), Stop> {
    let (whole, digits) = point(meter, x, mask.arity)?;
    // From the integer before the support on, where f = 0 at first.
    let first = window(mask)?.0.checked_sub(1).ok_or(PLACE)?;
    let mut level = [&[Value::int(0)], known].concat();
    for digit in digits.into_iter().rev() {
        level = coarser(meter, mask, (first, &level), digit)?;
    }
    Ok((whole, (first, level)))
}

/// Takes a point apart.
fn point(meter: &Meter, x: &Value, arity: usize) -> Result<Point, Stop> {
    let (n, x) = (BigInt::from(arity), x.number()?.rational().ok_or(PLACE)?);
    if x.denom().bits() > MAX_BITS {
        return Err(PLACE);
    }
    let whole = x.floor().to_integer();
    let (mut rest, mut digits) = (x - Q::from_integer(whole.clone()), Vec::new());
    while !rest.is_zero() {
        if digits.len() == MAX_LEVEL {
            return Err(PLACE);
        }
        meter.spend(1)?;
        rest *= &n;
        let digit = rest.floor().to_integer();
        digits.push(digit.to_i64().ok_or(PLACE)?);
        rest -= Q::from_integer(digit);
    }
    Ok((whole, digits))
}

/// The values at g + m, from those at f + m for ng = f + d: φ(g + m) = Σ_p a_{d+nm−p} φ(f + p).
fn coarser(
    meter: &Meter,
    mask: &Mask,
    (first, level): (i64, &[Value]),
    digit: i64,
) -> Result<Vec<Value>, Stop> {
    let n = signed(mask.arity)?;
    let value = |(m, _)| {
        let at = n.checked_mul(m).and_then(|at| at.checked_add(digit)).ok_or(PLACE)?;
        let mut sum = Value::int(0);
        for (p, value) in (first..).zip(level) {
            meter.spend(1)?;
            if let Some(a) = at.checked_sub(p).and_then(|k| mask.at(k)) {
                add(meter, &mut sum, a, value)?;
            }
        }
        Ok(sum)
    };
    (first..).zip(level).map(value).collect()
}
