//! What lines `limits` say of the limits of a mask.

#![warn(clippy::arithmetic_side_effects)]

use super::logarithm::{Logarithm, logarithm};
use crate::functions::real::Real;
use crate::numbers::{Q, Value, count, int};
use crate::radius::{Radius, has_independent_shifts};
use crate::schemes::{Library, Scheme};
use crate::text::Stop;
use std::rc::Rc;

const NONE: Stop = Stop::Capped("what no line `limits` shows");

/// What is known of a scheme, and whether the shifts of φ are linearly independent.
fn known(library: &Library<'_>, scheme: &Scheme) -> Result<(Vec<Rc<Radius>>, bool), Stop> {
    let radii = library.limits.of(&scheme.mask);
    let mask = Value::rationals(&scheme.mask).filter(|_| !radii.is_empty()).ok_or(NONE)?;
    Ok((radii, has_independent_shifts(&mask)?))
}

/// The greatest m for which all limits are C^m; −1 if the scheme diverges.
pub fn smoothness(library: &Library<'_>, scheme: &Scheme) -> Result<Real, Stop> {
    let (radii, independent) = known(library, scheme)?;
    if radii.iter().any(|radius| radius.not_continuous == Some(0)) {
        return Ok(Real::Exact(Value::int(-1)));
    }
    let low = radii.iter().filter_map(|radius| radius.continuous).max().ok_or(NONE)?;
    // Smoother limits need further sum rules, if the shifts are independent (THEOREMS.md, 109).
    let orders = radii.iter().filter_map(|radius| radius.order).filter(|_| independent);
    let others = radii.iter().filter_map(|radius| radius.not_continuous);
    let below = orders.chain(others).min().ok_or(NONE)?;
    Real::between(count(low), count(below) - int(1))
}

/// The Hölder exponent of the limits.
pub fn hoelder(library: &Library<'_>, scheme: &Scheme) -> Result<Real, Stop> {
    let (radii, independent) = known(library, scheme)?;
    let converges = radii.iter().any(|radius| radius.continuous.is_some());
    if !independent || !converges {
        return Err(NONE);
    }
    let n = scheme.arity();
    let exponent = |radius: &Radius, of: &Q, degree: usize| -> Option<Logarithm> {
        let log = logarithm(n, of)?;
        Some(log.scaled(&-count(degree).recip()).plus(&count(radius.order?)))
    };
    let least = radii.iter().filter(|radius| radius.continuous.is_some());
    let least = least.filter_map(|radius| exponent(radius, &radius.at_most, 1));
    let most = radii.iter().filter_map(|radius| {
        let (bound, degree) = radius.at_least.as_ref()?;
        exponent(radius, bound, *degree)
    });
    let least = least.max_by(|a, b| a.low.cmp(&b.low)).ok_or(NONE)?;
    let most = most.min_by(|a, b| a.high.cmp(&b.high)).ok_or(NONE)?;
    // The two enclosures overlap where the bounds are equal, and no rational number.
    Real::between(least.low, most.high)
}
