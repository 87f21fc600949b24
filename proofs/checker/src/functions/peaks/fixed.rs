//! A mask and values of its limit in integers, times a power of 2.
//!
//! With x = (i + y)/n^j, 0 ≤ y < 1, φ(x − k) = Σ_q d_q φ(y − q), where q runs through the window of the integers with φ(y − q) ≠ 0
//! for some y. The part with the digit e has y = (e + y')/n, and d'_{q'} = Σ_q a_{q'+e−nq} d_q.

#![warn(clippy::arithmetic_side_effects)]

use crate::functions::limits::window;
use crate::functions::masks::{Mask, signed};
use crate::numbers::{Meter, Q, Value};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{One as _, Signed as _, ToPrimitive as _, Zero as _};

/// The binary digits behind the point.
pub const DIGITS: u64 = 256;

const PLACE: Stop = Stop::Capped("the places of a limit function");

/// A coefficient of a sum, with its place in the window.
type Term = (usize, BigInt);

/// The mask and φ at integers. Each integer is less than 1 below the number that it stands for.
pub struct Fixed {
    /// The first integer of the window.
    pub first: i64,
    /// The size of the window.
    pub size: usize,
    /// For each digit and each q' the terms of the sum.
    pub terms: Vec<Vec<Vec<Term>>>,
    /// The number of all terms.
    pub count: u64,
    /// The φ(−q).
    pub values: Vec<BigInt>,
    /// A bound of the Σ_q |a_{q'+e−nq}|, and the most terms of a sum.
    pub norm: BigInt,
    pub most: usize,
}

/// 1 in these integers.
pub fn one() -> BigInt {
    BigInt::one() << DIGITS
}

/// The integer below x·2^DIGITS.
fn fixed(meter: &Meter, x: &Value) -> Result<BigInt, Stop> {
    let unit = Value::from(Q::from_integer(one()));
    meter.spend(x.steps(&unit))?;
    let scaled = x.times(&unit)?;
    // The integer below an irrational number is found by halving.
    if scaled.rational().is_none() {
        meter.spend(scaled.steps(&scaled).saturating_mul(DIGITS))?;
    }
    scaled.floor()
}

impl Fixed {
    /// The mask with these values of φ at the integers of its support.
    pub fn new(meter: &Meter, mask: &Mask, known: &[Value]) -> Result<Fixed, Stop> {
        let n = signed(mask.arity)?;
        let (start, end) = window(mask)?;
        // φ(y − q) = 0 unless l/(n − 1) < y − q < K/(n − 1), where 0 ≤ y < 1.
        let below = n.checked_sub(1).ok_or(PLACE)?;
        let ends = |place: i64| place.checked_rem(below) == Some(0);
        let first = end.checked_neg().ok_or(PLACE)?;
        let first = if ends(mask.last()?) { first.checked_add(1).ok_or(PLACE)? } else { first };
        // The greatest q below 1 − l/(n − 1): `start` is the integer above l/(n − 1).
        let last = start.checked_neg().ok_or(PLACE)?;
        let last = if ends(mask.first) { last } else { last.checked_add(1).ok_or(PLACE)? };
        let mut coefficients = Vec::new();
        for a in &mask.values {
            coefficients.push(fixed(meter, a)?);
        }
        let (mut terms, mut count, mut most) = (Vec::new(), 0_u64, 0);
        let mut norm = BigInt::zero();
        for digit in 0..n {
            let mut of_digit = Vec::new();
            for q in first..=last {
                let mut sum = Vec::new();
                for (place, p) in (first..=last).enumerate() {
                    meter.spend(1)?;
                    let k = n.checked_mul(p).and_then(|from| q.checked_sub(from));
                    let k = k.and_then(|k| k.checked_add(digit)?.checked_sub(mask.first));
                    let a = k.and_then(|k| coefficients.get(usize::try_from(k).ok()?));
                    sum.extend(a.filter(|a| !a.is_zero()).map(|a| (place, a.clone())));
                }
                count = count.saturating_add(sum.len() as u64);
                most = most.max(sum.len());
                norm = norm.max(sum.iter().map(|(_, a)| a.abs() + 1_u8).sum());
                of_digit.push(sum);
            }
            terms.push(of_digit);
        }
        let mut values = Vec::new();
        for q in first..=last {
            let place = q.checked_neg().and_then(|x| x.checked_sub(start)).ok_or(PLACE)?;
            let value = place.to_usize().and_then(|place| known.get(place));
            values.push(value.map_or(Ok(BigInt::zero()), |value| fixed(meter, value))?);
        }
        let size = values.len();
        Ok(Fixed { first, size, terms, count, values, norm, most })
    }

    /// The last integer of the window.
    pub fn last(&self) -> i64 {
        let size = i64::try_from(self.size).unwrap_or(i64::MAX);
        self.first.saturating_add(size).saturating_sub(1)
    }
}
