//! The functions whose values may be any real numbers.

#![warn(clippy::arithmetic_side_effects)]

use super::call::Call;
use super::real::Real;
use super::{exponent, limits, modulus, peaks, vertices};
use crate::formulas::{Asked, Scope};
use crate::schemes::Library;
use crate::text::Stop;

/// The value of such a function; `None` if the function is none of these.
pub fn real(library: &Library<'_>, scope: &Scope<'_>, of: Asked<'_>) -> Result<Option<Real>, Stop> {
    let mut call = Call::new(library, scope, of);
    for group in [exponent::real, peaks::real, limits::real, modulus::real, vertices::real] {
        if let Some(found) = group(&mut call)? {
            call.finished()?;
            return Ok(Some(found));
        }
    }
    Ok(None)
}
