//! Two real numbers, and how they compare.

#![warn(clippy::arithmetic_side_effects)]

use super::evaluate::Reals;
use super::known::{Known, MOST};
use super::masks;
use crate::formulas::{Expr, Scope};
use crate::numbers::{Number, Q};
use crate::schemes::Library;
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::One as _;
use std::cmp::Ordering;

/// The binary digits that are tried first.
const FIRST: u64 = 192;

/// The values of two formulas.
pub struct Pair {
    pub left: Known,
    pub right: Known,
    /// How they compare; `None` if bounds do not decide it, of which there are no finer ones.
    pub order: Option<Ordering>,
    /// left − right is between these.
    pub difference: [Q; 2],
    /// left − right, if it is known to be a number of a field Q(2cos(2π/n)).
    pub number: Option<Number>,
}

/// The values of two formulas with as many digits as it takes.
pub fn pair(
    library: &Library<'_>,
    scope: &Scope<'_>,
    (left, right): (&Expr, &Expr),
) -> Result<Pair, Stop> {
    let mut bits = FIRST;
    loop {
        match pair_with(library, scope, (left, right), bits) {
            Ok((pair, None)) => return Ok(pair),
            // So many digits tell whether both are equal.
            Ok((_, Some(needed))) if needed <= MOST && needed > bits => bits = needed,
            Err(Stop::Undecided(_)) if bits < MOST => bits = bits.saturating_mul(4).min(MOST),
            Ok(_) => return Err(Stop::Undecided("whether two numbers are equal")),
            Err(stop) => return Err(stop),
        }
    }
}

/// The values with so many digits, and how many are needed to compare them, if these are not enough.
fn pair_with(
    library: &Library<'_>,
    scope: &Scope<'_>,
    (left, right): (&Expr, &Expr),
    bits: u64,
) -> Result<(Pair, Option<u64>), Stop> {
    let reals = Reals::new(library, scope, bits, masks::of);
    let (left, right) = (reals.value(left)?, reals.value(right)?);
    let difference = reals.digits().sum(&left, -1, &right)?;
    let ends = difference.ends();
    let number = difference.number.clone();
    let pair = |order| Pair { left, right, order, difference: ends, number };
    if let Some(number) = &difference.number {
        let order = number.sign()?.cmp(&0);
        return Ok((pair(Some(order)), None));
    }
    if let Some(sign) = difference.near.sign() {
        return Ok((pair(Some(sign.cmp(&0))), None));
    }
    let Some(size) = &difference.size else { return Ok((pair(None), None)) };
    let separation = size.separation();
    if separation > MOST {
        return Err(Stop::Capped("the digits that separate a number from 0"));
    }
    if difference.most() * Q::from_integer(BigInt::one() << separation) < Q::one() {
        return Ok((pair(Some(Ordering::Equal)), None));
    }
    // Digits are counted from the first one, which may stand far before the point.
    Ok((pair(None), Some(separation.saturating_add(128).max(bits.saturating_mul(2)))))
}
