//! Depths: logarithms that are rounded to integers.

use crate::numbers::{Meter, Value};
use crate::text::Stop;
use std::cmp::Ordering;

/// A depth is at most two to the power of this.
const MAX_LEVEL_BITS: usize = 14;

/// A numerator and a denominator, both without fractions.
type Ratio = (Value, Value);

fn ratio(value: &Value) -> Result<Ratio, Stop> {
    let bottom = Value::denominator([value])?;
    Ok((value.times(&bottom)?, bottom))
}

fn times((a, b): &Ratio, (c, d): &Ratio) -> Result<Ratio, Stop> {
    Ok((a.times(c)?, b.times(d)?))
}

fn compare((a, b): &Ratio, (c, d): &Ratio) -> Result<Ordering, Stop> {
    a.times(d)?.compare(&b.times(c)?)
}

/// The logarithm of x to the base r, at least 0 and rounded up (0), to the nearest integer (1)
/// or down (2).
pub fn depth(meter: &Meter, r: &Value, x: &Value, rounding: usize) -> Result<i64, Stop> {
    let one = Value::int(1);
    let between = r.sign(None)? > 0 && r.compare(&one)?.is_lt();
    if !between || x.sign(None)? <= 0 {
        let why = "the ratio of a depth is not between 0 and 1, or its number is not positive";
        return Err(Stop::Undefined(why));
    }
    let (r, x) = (ratio(r)?, ratio(x)?);
    // The powers r, r², r⁴, … that are above x, and the next one.
    let mut powers = vec![r.clone()];
    while let Some(last) = powers.last()
        && compare(last, &x)?.is_gt()
    {
        if powers.len() > MAX_LEVEL_BITS {
            return Err(Stop::Capped("the depth"));
        }
        meter.spend(last.0.cost(&last.0) + last.1.cost(&last.1))?;
        powers.push(times(last, last)?);
    }
    // The greatest k with r^k > x is found bit by bit. Then k + 1 is the logarithm rounded up.
    let (mut k, mut power) = (0_i64, (one.clone(), one));
    if compare(&power, &x)?.is_gt() {
        for (i, next) in powers.iter().enumerate().rev() {
            let next = times(&power, next)?;
            if compare(&next, &x)?.is_gt() {
                (k, power) = (k + (1 << i), next);
            }
        }
        (k, power) = (k + 1, times(&power, &r)?);
    }
    // ⌊t + 1/2⌋ for t = log(x) is k if r^(2k−1) ≥ x², that is t ≥ k − 1/2.
    let near = || compare(&times(&times(&x, &x)?, &r)?, &times(&power, &power)?);
    let kept =
        k == 0 || rounding == 0 || compare(&power, &x)?.is_eq() || rounding == 1 && near()?.is_le();
    Ok(if kept { k } else { k - 1 })
}
