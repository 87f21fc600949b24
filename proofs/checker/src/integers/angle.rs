//! Cosines of 2π(α + β/t), and of 2π(α + rd/t) for places d.

#![warn(clippy::arithmetic_side_effects)]

use super::function::{Function, Functions};
use super::polynomial::{COSINE, H, PI, PLACE, Polynomial, T};
use super::sign::machine;
use crate::numbers::{Number, Q, int};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{One as _, Zero as _};

/// The greatest absolute value of 2β, and of r.
const MAX_BETA: u64 = 128;
pub const MAX_ORDER: u64 = 6;

/// The greatest denominator of a rational multiple of π of which a cosine is looked for.
const MAX_TURNS: u32 = 6;

const ANGLE: Stop = Stop::Integers("a cosine of another angle");

/// The cosine of a function that is a multiple of π.
pub fn cosine(functions: &Functions<'_>, angle: &Function) -> Result<Function, Stop> {
    let meter = functions.meter();
    let mut turns = angle.quotient().ok_or(ANGLE)?;
    let parts = turns.top.coefficients(PI);
    let wrong = || Stop::Wrong("`cos` takes one rational multiple of pi".into());
    turns.top = match &parts[..] {
        [none] if none.is_zero() => Polynomial::default(),
        [none, one] if none.is_zero() => one.clone(),
        _ => return Err(wrong()),
    };
    // The angle is π(a + b/t + cd/t).
    let turns = turns.times(meter, &Polynomial::variable(T).into())?;
    let (mut a, mut b, mut c) = (Q::zero(), Q::zero(), Q::zero());
    let known = [T, H, COSINE, PLACE, PI].map(|place| turns.top.degree(place));
    if !turns.bottom.is_empty() || known[0] > 1 || known[3] > 1 {
        return Err(ANGLE);
    }
    for (monomial, term) in turns.top.terms() {
        match monomial {
            [1, 0, 0, 0, 0] => a = term.clone(),
            [0, 0, 0, 0, 0] => b = term.clone(),
            [0, 0, 0, 1, 0] => c = term.clone(),
            _ => return Err(ANGLE),
        }
    }
    if b.is_zero() && c.is_zero() {
        return number(&a);
    }
    let half_turns = machine(&a).ok_or(ANGLE)?;
    let sign = if half_turns.rem_euclid(2) == 0 { Q::one() } else { -Q::one() };
    let order = |order: &Q, most| {
        machine(order).map(i64::unsigned_abs).filter(|order| *order <= most).ok_or(ANGLE)
    };
    let value = if c.is_zero() {
        Polynomial::chebyshev(meter, order(&b, MAX_BETA)?, &Polynomial::variable(H))?
    } else if b.is_zero() {
        let r = order(&(c / int(2)), MAX_ORDER)?;
        Polynomial::chebyshev(meter, r, &Polynomial::variable(COSINE))?
    } else {
        return Err(ANGLE);
    };
    Ok(value.scaled(&sign).into())
}

/// cos(aπ), if it is rational.
fn number(a: &Q) -> Result<Function, Stop> {
    if *a.denom() > BigInt::from(MAX_TURNS) {
        return Err(ANGLE);
    }
    let value = Number::cosine(&(a / int(2)))?.rational().ok_or(ANGLE)?;
    Ok(Polynomial::from(value).into())
}
