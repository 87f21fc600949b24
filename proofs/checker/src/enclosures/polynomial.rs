//! Polynomials with enclosed coefficients. The constant one comes first.

#![warn(clippy::arithmetic_side_effects)]

use super::interval::Interval;
use crate::numbers::Q;
use crate::text::Stop;
use std::cmp::Ordering;

/// p(x).
pub fn at(p: &[Interval], x: &Interval, bits: u64) -> Result<Interval, Stop> {
    let sum = Interval::from(0);
    p.iter().rev().try_fold(sum, |sum, c| sum.times(x, bits)?.plus(c, bits))
}

/// The quotient of p by x − λ, of which the enclosed λ is a root.
pub fn without(p: &[Interval], root: &Interval, bits: u64) -> Result<Vec<Interval>, Stop> {
    let mut quotient: Vec<Interval> = Vec::new();
    for c in p.iter().skip(1).rev() {
        let next = match quotient.last() {
            Some(last) => last.times(root, bits)?.plus(c, bits)?,
            None => c.clone(),
        };
        quotient.push(next);
    }
    quotient.reverse();
    Ok(quotient)
}

/// Whether all complex roots are certainly below r in absolute value (Schur and Cohn).
pub fn is_within(mut p: Vec<Interval>, r: &Q, bits: u64) -> Result<bool, Stop> {
    let (radius, mut scale) = (Interval::point(r.clone())?, Interval::from(1));
    for c in &mut p {
        *c = c.times(&scale, bits)?;
        scale = scale.times(&radius, bits)?;
    }
    while let [first, .., last] = &p[..] {
        if first.absolute().compare(&last.absolute()) != Some(Ordering::Less) {
            return Ok(false);
        }
        let pairs = p.iter().skip(1).zip(p.iter().rev().skip(1));
        let next = pairs
            .map(|(up, down)| last.times(up, bits)?.minus(&first.times(down, bits)?, bits))
            .collect::<Result<Vec<_>, Stop>>()?;
        p = next;
    }
    Ok(true)
}
