//! Numbers of the fields Q(2cos(2π/n)) as roots of polynomials.

#![warn(clippy::arithmetic_side_effects)]

use super::decimal::Q;
use super::meter::Meter;
use super::number::Number;
use super::root::Root;
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{One as _, Zero as _};

/// The greatest degree of a polynomial.
const MAX_DEGREE: usize = 64;

/// The binary digits of the bounds that are tried.
const DIGITS: [u32; 8] = [4, 8, 16, 32, 64, 128, 256, 512];

impl Root {
    /// The root that a number is.
    pub fn of(number: &Number, meter: &Meter) -> Result<Root, Stop> {
        if let Some(value) = number.rational() {
            return Ok(value.into());
        }
        // It has no rational roots, so that no bound is a root.
        let polynomial = minimal(number, meter)?;
        for digits in DIGITS {
            let unit = BigInt::one() << digits;
            let low = number.times(&Q::from_integer(unit.clone()).into())?.floor()?;
            let high: BigInt = &low + BigInt::one();
            let ends = [low, high].map(|end| Q::new(end, unit.clone()));
            if let Some(root) = Root::between(polynomial.clone(), ends, meter)? {
                return Ok(root);
            }
        }
        Err(Stop::Capped("the digits that separate the roots of a polynomial"))
    }
}

/// The minimal polynomial of a number: the first of its powers that is a combination of those before it.
fn minimal(number: &Number, meter: &Meter) -> Result<Vec<Q>, Stop> {
    let size = number.coordinates().1.len();
    // Coordinates of combinations of powers, and these combinations. Each is 0 at the pivots of those before it.
    let mut known: Vec<(usize, Vec<Q>, Vec<Q>)> = Vec::new();
    let mut power = Number::Small(1, 1);
    for degree in 0..=MAX_DEGREE {
        let mut place = power.coordinates().1;
        place.resize(size, Q::zero());
        let mut combination = vec![Q::zero(); degree];
        combination.push(Q::one());
        for (pivot, other, by) in &known {
            meter.spend(size as u64)?;
            let (Some(top), Some(bottom)) = (place.get(*pivot), other.get(*pivot)) else {
                continue;
            };
            let factor = top / bottom;
            for (value, other) in place.iter_mut().zip(other).chain(combination.iter_mut().zip(by))
            {
                *value -= &factor * other;
            }
        }
        let Some(pivot) = place.iter().position(|value| !value.is_zero()) else {
            return Ok(combination);
        };
        known.push((pivot, place, combination));
        meter.spend(power.cost_in_field(number))?;
        power = power.times(number)?;
    }
    Err(Stop::Capped("the degree of a number"))
}
