//! The zeros of a(z): at 1, and in the left half of the plane.

#![warn(clippy::arithmetic_side_effects)]

use super::call::{Call, number, wrong};
use super::masks::Mask;
use super::steps::{add, plus, times};
use crate::numbers::{Meter, Piece, Value};
use crate::schemes::Scheme;
use crate::text::Stop;

/// The value of such a function; `None` if the call is none of them.
pub fn of(call: &mut Call<'_>) -> Result<Option<Value>, Stop> {
    let (meter, piece) = (call.library.meter, call.piece());
    Ok(Some(match (call.function, call.arguments) {
        ("vanishing_moments", []) => number(moments(meter, Mask::called(call)?.values, piece)?),
        ("hurwitz", []) => {
            Value::int(is_hurwitz(meter, &Mask::called(call)?.values, piece)?.into())
        }
        _ => return Ok(None),
    }))
}

/// Whether all zeros of the symbol of a scheme have negative real parts.
pub fn hurwitz(meter: &Meter, scheme: &Scheme) -> Result<Value, Stop> {
    let mask = Mask::of_numbers(meter, scheme)?;
    Ok(Value::int(is_hurwitz(meter, &mask.values, None)?.into()))
}

/// How often 1 − z divides a polynomial p ≠ 0. The coefficients of p/(1 − z) are the sums of the first coefficients of p, and the
/// sum of all of them has to be 0.
fn moments(meter: &Meter, mut rest: Vec<Value>, piece: Option<&Piece<'_>>) -> Result<usize, Stop> {
    let mut order = 0_usize;
    while !rest.is_empty() {
        let (mut sum, mut sums) = (Value::int(0), Vec::with_capacity(rest.len()));
        for c in &rest {
            plus(meter, &mut sum, c)?;
            sums.push(sum.clone());
        }
        if !sum.is_zero_on(piece)? {
            return Ok(order);
        }
        sums.pop();
        rest = sums;
        order = order.saturating_add(1);
    }
    wrong("the symbol is 0")
}

/// Whether all zeros of a polynomial have negative real parts, by the scheme of Routh: with a positive leading coefficient, all
/// numbers at the beginnings of its rows have to be positive.
///
/// The row k, times the product of the numbers at the beginnings of those from 1 to k − 1, consists of minors M_{k,i} of the matrix of Hurwitz,
/// which are polynomials in the coefficients. From the rule of Routh, M_{k+1,i}M_{k−2,0} = M_{k,0}M_{k−1,i+1} − M_{k−1,0}M_{k,i+1},
/// with 1 in place of M_{k−2,0} for k ≤ 2. So no row needs fractions.
fn is_hurwitz(meter: &Meter, p: &[Value], piece: Option<&Piece<'_>>) -> Result<bool, Stop> {
    let Some((leading, rest)) = p.split_last() else { return wrong("the symbol is 0") };
    let sign = leading.sign(piece)?;
    let signed = p.iter().map(|c| if sign < 0 { c.negated() } else { Ok(c.clone()) });
    let p = signed.collect::<Result<Vec<Value>, Stop>>()?;
    let every_other = |from| p.iter().rev().skip(from).step_by(2).cloned().collect();
    let (mut above, mut row): (Vec<Value>, Vec<Value>) = (every_other(0), every_other(1));
    // M_{k−2,0} and M_{k−1,0}.
    let (mut divisor, mut next_divisor) = (Value::int(1), Value::int(1));
    for _ in rest {
        let zero = Value::int(0);
        let [start, pivot] = [&above, &row].map(|row| row.first().unwrap_or(&zero));
        // One that is 0 or negative shows a zero that is not in the left half.
        if pivot.sign(piece)? <= 0 {
            return Ok(false);
        }
        let (minus, mut next) = (start.negated()?, Vec::with_capacity(row.len()));
        for (i, a) in above.iter().enumerate().skip(1) {
            let mut minor = times(meter, pivot, a)?;
            if let Some(b) = row.get(i) {
                add(meter, &mut minor, &minus, b)?;
            }
            next.push(minor.share_of(&divisor, piece, meter)?);
        }
        divisor = std::mem::replace(&mut next_divisor, pivot.clone());
        (above, row) = (row, next);
    }
    Ok(true)
}
