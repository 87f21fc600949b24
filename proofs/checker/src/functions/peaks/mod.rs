//! The greatest values of sums of shifts of φ: `overshoot` and `gibbs`.

#![warn(clippy::arithmetic_side_effects)]

mod cell;
mod fixed;
mod search;
mod sums;

use super::call::Call;
use super::limits::{exists, values};
use super::masks::Mask;
use super::real::Real;
use super::shape::is_positive;
use crate::numbers::{Q, Value};
use crate::schemes::{Library, Scheme};
use crate::text::Stop;
use fixed::Fixed;
use sums::Sum;

/// The value of such a function, if it is known; `None` if the call is none of them.
pub fn of(call: &mut Call<'_>) -> Result<Option<Value>, Stop> {
    real(call)?.map(Real::value).transpose()
}

/// The same as a real number.
pub fn real(call: &mut Call<'_>) -> Result<Option<Real>, Stop> {
    let sum = match (call.function, call.arguments) {
        ("overshoot", []) => Sum::Positive,
        ("gibbs", []) => Sum::Step,
        _ => return Ok(None),
    };
    greatest(call.library, &*call.scheme()?, sum).map(Some)
}

/// The supremum of such a sum. It is 1 if φ ≥ 0, since Σ_k φ(x − k) = 1.
fn greatest(library: &Library<'_>, scheme: &Scheme, sum: Sum) -> Result<Real, Stop> {
    exists(library, scheme, None)?;
    let meter = library.meter;
    let mask = Mask::of_numbers(meter, scheme)?;
    if is_nonnegative(&mask)? || is_positive(library, scheme)? {
        return Ok(Real::Exact(Value::int(1)));
    }
    let fixed = Fixed::new(meter, &mask, &values(library, scheme, None)?)?;
    let [low, high] = search::greatest(meter, &fixed, sum)?;
    Real::between(low.max(Q::from_integer(1.into())), high)
}

/// Whether no coefficient is negative; then φ ≥ 0.
fn is_nonnegative(mask: &Mask) -> Result<bool, Stop> {
    for a in &mask.values {
        if a.number()?.sign()? < 0 {
            return Ok(false);
        }
    }
    Ok(true)
}
