//! Whether a limit exists, and its values at the integers.

#![warn(clippy::arithmetic_side_effects)]

use super::integers::at_integers;
use crate::data::converges;
use crate::functions::masks::Mask;
use crate::numbers::Value;
use crate::schemes::{Library, Scheme};
use crate::text::Stop;
use std::rc::Rc;

/// Checks that a scheme is shown to converge.
pub fn exists(library: &Library<'_>, scheme: &Scheme) -> Result<(), Stop> {
    if scheme.limit.get().is_some() || converges(library, scheme)? {
        return Ok(());
    }
    Err(Stop::Capped("the levels up to which convergence is looked for"))
}

/// The values of φ at the integers of its support.
pub fn values(library: &Library<'_>, scheme: &Scheme) -> Result<Rc<[Value]>, Stop> {
    if let Some(known) = scheme.limit.get() {
        return Ok(Rc::clone(known));
    }
    let mask = Mask::of_numbers(library.meter, scheme)?;
    exists(library, scheme)?;
    let found: Rc<[Value]> = at_integers(library.meter, &mask)?.into();
    Ok(Rc::clone(scheme.limit.get_or_init(|| found)))
}
