//! The exponent s of Sobolev: the supremum of the numbers for which |ξ|^s φ̂(ξ) is square integrable away from 0.

#![warn(clippy::arithmetic_side_effects)]

use super::characteristic::{Eigenvalue, greatest};
use super::independent::has_independent_shifts;
use super::logarithm::logarithm;
use crate::functions::call::number;
use crate::functions::masks::{Mask, correlations, quotient, signed};
use crate::functions::real::Real;
use crate::functions::steps::{plus, times};
use crate::numbers::{Meter, Q, Value, count, int};
use crate::schemes::{Library, Scheme};
use crate::text::Stop;

/// K − log_n(ρ)/2: ρ is the spectral radius of f ↦ Σ_j nc_{nk−j}f_j, for |a/n|² = |σ/n|^{2K}·Σ_k c_k z^k on the unit circle.
pub fn sobolev(library: &Library<'_>, scheme: &Scheme) -> Result<Real, Stop> {
    let (meter, mask) = (library.meter, Mask::of_numbers(library.meter, scheme)?);
    if !has_independent_shifts(meter, &mask)? {
        return Err(Stop::Capped("shifts that may be linearly dependent"));
    }
    let (n, mut rest, mut order) = (mask.arity, mask.values, 0_usize);
    while let Some(next) = quotient(meter, &rest, n, None)? {
        rest = next;
        order = order.saturating_add(1);
    }
    let exponent = |log: &Q| count(order) - log / int(2);
    match greatest(meter, &matrix(meter, &rest, (n, order))?, n)? {
        Eigenvalue::Logarithm(log) => Ok(Real::Exact(exponent(&log).into())),
        Eigenvalue::Between(low, high) => {
            let ends = logarithm(n, &low).zip(logarithm(n, &high));
            let (low, high) = ends.ok_or(Stop::Undefined("a logarithm"))?;
            Real::between(exponent(&high.high), exponent(&low.low))
        }
    }
}

/// The matrix on sequences with f_j = f_{−j}, 0 ≤ j ≤ J = ⌊L/(n − 1)⌋.
fn matrix(meter: &Meter, b: &[Value], (n, order): (usize, usize)) -> Result<Vec<Vec<Value>>, Stop> {
    // nc_k = n^{2K−1}Σ_i B_{i+k}B_i
    let exponent = signed(order)?.saturating_mul(2).saturating_sub(1);
    let factor = number(n).power(exponent)?;
    let products = correlations(meter, b)?;
    let products = products.iter().map(|sum| times(meter, sum, &factor));
    let products = products.collect::<Result<Vec<Value>, Stop>>()?;
    let at = |k: i64| {
        let place = usize::try_from(k.unsigned_abs()).ok();
        place.and_then(|place| products.get(place)).cloned().unwrap_or_else(|| Value::int(0))
    };
    let last = b.len().saturating_sub(1).checked_div(n.saturating_sub(1)).unwrap_or(0);
    let (n, last) = (signed(n)?, signed(last)?);
    let mut rows = Vec::new();
    for k in 0..=last {
        let mut row = Vec::new();
        for j in 0..=last {
            meter.spend(1)?;
            let place = n.saturating_mul(k);
            let mut entry = at(place.saturating_sub(j));
            if j > 0 {
                plus(meter, &mut entry, &at(place.saturating_add(j)))?;
            }
            row.push(entry);
        }
        rows.push(row);
    }
    Ok(rows)
}
