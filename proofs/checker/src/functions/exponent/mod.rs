//! Exponents of limits: printed ones, those that certificates of radii show, and those of Sobolev.

#![warn(clippy::arithmetic_side_effects)]

mod bounds;
mod characteristic;
mod euclid;
mod independent;
mod independent_on;
mod known;
mod logarithm;
mod norms;
mod printed;
mod sobolev;

use super::call::Call;
use super::masks::Mask;
use super::real::Real;
use crate::numbers::{Meter, Value};
use crate::schemes::{Library, Scheme};
use crate::text::Stop;

pub use bounds::{Bounded, bounded, is_call};
pub use characteristic::characteristic;
pub use printed::{Bound, LogSum};
pub use sobolev::sobolev;

/// The value of such a function; `None` if the call is none of them.
pub fn of(call: &mut Call<'_>) -> Result<Option<Value>, Stop> {
    real(call)?.map(Real::value).transpose()
}

/// The same as a real number.
pub fn real(call: &mut Call<'_>) -> Result<Option<Real>, Stop> {
    Ok(Some(match (call.function, call.arguments) {
        ("smoothness" | "hoelder", []) => {
            let scheme = call.scheme()?;
            shown(call.library, call.function, &scheme)?
        }
        ("independent", []) => {
            let (library, scheme) = (call.library, call.scheme()?);
            Real::Exact(match call.piece().filter(|_| scheme.numeric().is_err()) {
                None => independent(library.meter, &scheme)?,
                Some(piece) => {
                    let mask = Mask::on(library.meter, &scheme, Some(piece))?;
                    let is = independent_on::has_independent_shifts_on(library, &mask, piece)?;
                    Value::int(is.into())
                }
            })
        }
        ("sobolev", []) => sobolev(call.library, &*call.scheme()?)?,
        _ => return Ok(None),
    }))
}

/// Whether the shifts of φ are linearly independent.
pub fn independent(meter: &Meter, scheme: &Scheme) -> Result<Value, Stop> {
    let mask = Mask::of_numbers(meter, scheme)?;
    Ok(Value::int(independent::has_independent_shifts(meter, &mask)?.into()))
}

/// What lines `limits` show of one of the two functions of smoothness.
pub fn shown(library: &Library<'_>, function: &str, scheme: &Scheme) -> Result<Real, Stop> {
    let shown = if function == "hoelder" { known::hoelder } else { known::smoothness };
    shown(library, scheme)
}
