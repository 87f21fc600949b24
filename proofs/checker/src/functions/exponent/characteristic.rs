//! The greatest real eigenvalue of a matrix all of whose other eigenvalues have at most this absolute value.

#![warn(clippy::arithmetic_side_effects)]

use super::logarithm::root;
use crate::functions::steps::{Values, add, times};
use crate::numbers::{self, Meter, Q, Value, gcd, roots_between, steps_of_gcd};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{One as _, Zero as _};

/// The most rows.
const MAX_SIZE: usize = 64;

/// The binary digits behind the point to which it is enclosed.
const DIGITS: u64 = 96;

/// The most binary digits of an upper bound.
const MAX_BITS: u64 = 1 << 16;

/// The eigenvalue: log_n of it, or two numbers between which it is.
pub enum Eigenvalue {
    Logarithm(Q),
    Between(Q, Q),
}

/// The characteristic polynomial of a matrix that is not too large.
pub fn characteristic(meter: &Meter, matrix: &[Vec<Value>]) -> Result<Vec<Value>, Stop> {
    if matrix.len() > MAX_SIZE {
        return Err(Stop::Capped("the size of a matrix"));
    }
    numbers::characteristic(&Values(meter), matrix)
}

/// The coefficients of p(x + y) in y, as far as none of them is negative; and whether all of them are positive. The constant one
/// comes first.
fn beyond(meter: &Meter, p: &[Value], x: &Value) -> Result<Side, Stop> {
    let mut rest = p.to_vec();
    let mut side = Side::Above;
    for i in 0..rest.len() {
        for j in (i..rest.len().saturating_sub(1)).rev() {
            let higher = rest[j.saturating_add(1)].clone();
            add(meter, &mut rest[j], &higher, x)?;
        }
        match rest[i].number()?.sign()? {
            -1 => return Ok(Side::Below),
            0 if i == 0 => side = Side::At,
            0 if side == Side::Above => return Ok(Side::Below),
            _ => {}
        }
    }
    Ok(side)
}

/// Where a number is: above the greatest real root, at it, or below or at it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Above,
    At,
    Below,
}

/// The eigenvalue. It is at least 1.
///
/// The roots of a derivative are in the convex hull of those of p. So beyond the greatest root, which no real part of a root
/// exceeds, p and its derivatives are positive; and where they are, there is no root, nor beyond. If p alone is 0 and no derivative
/// is negative, no root is beyond.
pub fn greatest(meter: &Meter, matrix: &[Vec<Value>], arity: usize) -> Result<Eigenvalue, Stop> {
    // A multiple of the matrix has integers, and an eigenvalue whose integer part tells enough.
    let denominator = Value::denominator(matrix.iter().flatten())?;
    let unit = denominator.rational().unwrap_or_else(Q::one);
    let fine = Q::from_integer(BigInt::one() << DIGITS) * &unit;
    let scaled = |x: &Value| times(meter, x, &denominator);
    let rows = matrix.iter().map(|row| row.iter().map(scaled).collect());
    let rows = rows.collect::<Result<Vec<Vec<Value>>, Stop>>()?;
    let of_rows = characteristic(meter, &rows)?;
    // The roots of p are 2^DIGITS times those.
    let mut p = Vec::new();
    for (place, c) in (0_u64..).zip(of_rows.iter().rev()) {
        let factor = BigInt::one() << DIGITS.saturating_mul(place);
        p.push(times(meter, c, &Q::from_integer(factor).into())?);
    }
    p.reverse();
    let at = |x: &BigInt| beyond(meter, &p, &Q::from_integer(x.clone()).into());
    let mut low = fine.to_integer();
    let mut high = &low * 2_u8;
    while at(&high)? != Side::Above {
        if high.bits() > MAX_BITS {
            return Err(Stop::Capped("the size of an eigenvalue"));
        }
        high *= 2_u8;
    }
    while &high - &low > BigInt::one() {
        let middle: BigInt = (&low + &high) >> 1_u8;
        if at(&middle)? == Side::Above { high = middle } else { low = middle }
    }
    let [low, high] = [low, high].map(|end| Q::from_integer(end) / &fine);
    let exact = power(meter, (&of_rows, &unit), [&low, &high], arity)?;
    Ok(exact.map_or(Eigenvalue::Between(low, high), Eigenvalue::Logarithm))
}

/// log_n of the eigenvalue between two numbers, if it is t/(eq) for n = r^e and some small q: the q-th root of r^t.
fn power(
    meter: &Meter,
    (p, unit): (&[Value], &Q),
    [low, high]: [&Q; 2],
    arity: usize,
) -> Result<Option<Q>, Stop> {
    let (r, e) = root(arity);
    let r = BigInt::from(r);
    for q in 1_u8..=4 {
        let [least, most] = [low, high].map(|end| end.pow(i32::from(q)));
        let (mut value, mut t) = (BigInt::one(), 0_usize);
        while Q::from_integer(value.clone()) < least {
            value *= &r;
            t = t.saturating_add(1);
        }
        if Q::from_integer(value.clone()) > most {
            continue;
        }
        let found = if q == 1 {
            let x = Q::from_integer(value) * unit;
            beyond(meter, p, &x.into())? == Side::At
        } else {
            is_root(meter, p, (value, q), [&(low * unit), &(high * unit)], unit)?
        };
        if found {
            return Ok(Some(number_of(t) / (number_of(e) * Q::from_integer(q.into()))));
        }
    }
    Ok(None)
}

fn number_of(count: usize) -> Q {
    Q::from_integer(count.into())
}

/// Whether the q-th root of an integer, times the unit, is the greatest root of p, which is between two numbers. Others are not
/// looked for if there may be several roots there, or coefficients are irrational.
fn is_root(
    meter: &Meter,
    p: &[Value],
    (value, q): (BigInt, u8),
    [low, high]: [&Q; 2],
    unit: &Q,
) -> Result<bool, Stop> {
    let Some(p) = p.iter().map(Value::rational).collect::<Option<Vec<Q>>>() else {
        return Ok(false);
    };
    let mut other = vec![Q::zero(); usize::from(q).saturating_add(1)];
    other[0] = -Q::from_integer(value) * unit.pow(i32::from(q));
    other[usize::from(q)] = Q::one();
    meter.spend(steps_of_gcd(&p, &other).saturating_mul(2))?;
    let common = gcd(&p, &other);
    let off = |x: &Q| !numbers::at(&p, x).is_zero() && !numbers::at(&other, x).is_zero();
    let one = off(low) && off(high) && roots_between(&p, low, high) == 1;
    Ok(one && common.len() > 1 && roots_between(&common, low, high) == 1)
}
