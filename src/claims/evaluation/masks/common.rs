//! What all functions of masks need: masks of numbers, and caps.

use crate::cap::Cap;
use crate::exact::{Rational, RealCyclotomic, Scalar};
use crate::formula::{CallError, Value};
use crate::scheme::Mask;

/// The greatest product of the numbers of coefficients of two masks.
pub(super) const MAX_PRODUCTS: usize = 1 << 22;

/// The greatest number of residue classes of T_c when a contraction below 1 is looked for.
pub(super) const MAX_CLASSES: u64 = 65_536;

pub(super) const IRRATIONAL: &str =
    "this value is irrational, where only rational numbers can be used";

/// The mask, whose coefficients are numbers.
pub(crate) fn numbers<V: Value>(mask: &Mask<V>) -> Result<Mask<RealCyclotomic>, CallError> {
    let all = mask.rules().rows().iter().flatten();
    if all.clone().all(|entry| entry.number().is_some()) {
        return Ok(mask.map(|entry| entry.number().unwrap_or_else(RealCyclotomic::zero)));
    }
    Err(CallError::Misuse(
        "this needs a mask of numbers, and this one has symbols in it".to_owned(),
    ))
}

/// The mask, whose coefficients are rational.
pub(crate) fn rational<V: Value>(mask: &Mask<V>) -> Result<Mask, CallError> {
    if let Some(mask) = as_rational(mask) {
        return Ok(mask);
    }
    numbers(mask)?;
    let what = "the degree of the coefficients of a mask whose limits are computed";
    Err(CallError::BeyondCap(Cap::new(what, 1)))
}

/// The mask, if its coefficients are rational.
pub(super) fn as_rational<V: Value>(mask: &Mask<V>) -> Option<Mask> {
    let all = mask.rules().rows().iter().flatten();
    let rational = all.clone().all(|entry| entry.as_rational().is_some());
    rational.then(|| mask.map(|entry| entry.as_rational().unwrap_or_else(Rational::zero)))
}

/// The greatest number of places at which an integral is summed.
pub(super) const MAX_PLACES: i64 = 256;

pub(super) fn check_size<F: Scalar>(first: &Mask<F>, second: &Mask<F>) -> Result<(), CallError> {
    let size = |mask: &Mask<F>| mask.arity() * mask.width();
    if size(first).saturating_mul(size(second)) > MAX_PRODUCTS {
        let what = "the number of coefficients of one mask times that of the other";
        return Err(CallError::BeyondCap(Cap::new(what, MAX_PRODUCTS as u64)));
    }
    Ok(())
}
