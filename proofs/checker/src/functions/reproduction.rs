//! Up to which degree the rules of a mask reproduce polynomials.

#![warn(clippy::arithmetic_side_effects)]

use super::call::{number, wrong};
use super::steps::{add, over, times};
use crate::numbers::{Meter, Piece, Q, Value, count, int};
use crate::schemes::Scheme;
use crate::text::Stop;

/// The greatest degree of polynomials that the rules take to themselves, with the points at i + s and (i + s)/n.
pub fn reproduction(
    meter: &Meter,
    scheme: &Scheme,
    indexed: bool,
    piece: Option<&Piece<'_>>,
) -> Result<usize, Stop> {
    if piece.is_none() {
        scheme.numeric()?;
    }
    let n = number(scheme.arity());
    let shift = if indexed { Some(Value::int(0)) } else { natural_shift(meter, scheme, piece)? };
    let Some(shift) = shift else { return Ok(0) };
    let points =
        (0..scheme.width()).map(|j| shift.plus(1, &(int(scheme.offset) + count(j)).into()));
    let points = points.collect::<Result<Vec<Value>, Stop>>()?;
    let places = (0..scheme.arity()).map(|alpha| over(meter, &shift.plus(1, &number(alpha))?, &n));
    let places = places.collect::<Result<Vec<Value>, Stop>>()?;
    let ones = |of: &[Value]| vec![Value::int(1); of.len()];
    let (mut of_points, mut of_places) = (ones(&points), ones(&places));
    // The place (α + s)/n of one α at least is no o + j + s: two of them differ by 1/n. There, N + 1 different points have
    // weights whose sums with all powers up to N cannot be 0.
    for degree in 0..scheme.width() {
        raise(meter, &mut of_points, &points)?;
        raise(meter, &mut of_places, &places)?;
        for (rule, place) in scheme.mask.iter().zip(&of_places) {
            let mut sum = Value::int(0);
            for (a, point) in rule.iter().zip(&of_points) {
                add(meter, &mut sum, a, point)?;
            }
            if !sum.minus(place)?.is_zero_on(piece)? {
                return Ok(degree);
            }
        }
    }
    wrong("the rules reproduce all polynomials")
}

/// Multiplies powers by their bases.
fn raise(meter: &Meter, powers: &mut [Value], bases: &[Value]) -> Result<(), Stop> {
    for (power, base) in powers.iter_mut().zip(bases) {
        *power = times(meter, power, base)?;
    }
    Ok(())
}

/// (α − n(m_α + o))/(n − 1), if it is the same number for all α.
fn natural_shift(
    meter: &Meter,
    scheme: &Scheme,
    piece: Option<&Piece<'_>>,
) -> Result<Option<Value>, Stop> {
    let (n, mut found) = (count(scheme.arity()), None::<Value>);
    for (alpha, rule) in scheme.mask.iter().enumerate() {
        let mut mean = Value::from(int(scheme.offset));
        for (j, a) in rule.iter().enumerate() {
            add(meter, &mut mean, a, &number(j))?;
        }
        let off = number(alpha).minus(&times(meter, &mean, &n.clone().into())?)?;
        let shift = over(meter, &off, &Value::from(&n - Q::from_integer(1.into())))?;
        match &found {
            Some(known) if !known.minus(&shift)?.is_zero_on(piece)? => return Ok(None),
            _ => found = Some(shift),
        }
    }
    Ok(found)
}
