//! What all functions of masks need: masks of numbers, and caps.

use crate::cap::Cap;
use crate::exact::{RealCyclotomic, Scalar};
use crate::formula::{CallError, Value};
use crate::scheme::Mask;

/// The greatest product of the numbers of coefficients of two masks.
const MAX_PRODUCTS: usize = 1 << 22;

/// The greatest number of residue classes of T_c when a contraction below 1 is looked for.
const MAX_CLASSES: u64 = 65_536;

pub(super) const IRRATIONAL: &str =
    "this value is irrational, where only rational numbers can be used";

/// The mask with other coefficients, if all of them are such.
pub(super) fn converted<V: Value, T: Scalar>(
    mask: &Mask<V>,
    of: impl Fn(&V) -> Option<T>,
) -> Option<Mask<T>> {
    let all = mask.rules().rows().iter().flatten().map(of).collect::<Option<Vec<T>>>()?;
    let mut all = all.into_iter();
    Some(mask.map(|_| all.next().unwrap_or_else(T::zero)))
}

/// The mask, whose coefficients are numbers.
pub(crate) fn numbers<V: Value>(mask: &Mask<V>) -> Result<Mask<RealCyclotomic>, CallError> {
    converted(mask, V::number).ok_or_else(|| {
        let other = if converted(mask, V::element).is_some() {
            "this needs a mask of numbers of a field Q(2cos(2π/n)), and this one has other roots in it"
        } else {
            "this needs a mask of numbers, and this one has symbols in it"
        };
        CallError::Misuse(other.to_owned())
    })
}

/// The mask, whose coefficients are rational.
pub(crate) fn rational<V: Value>(mask: &Mask<V>) -> Result<Mask, CallError> {
    if let Some(mask) = as_rational(mask) {
        return Ok(mask);
    }
    if converted(mask, V::element).is_none() {
        numbers(mask)?;
    }
    let what = "the degree of the coefficients of a mask whose limits are computed";
    Err(CallError::BeyondCap(Cap::new(what, 1)))
}

/// The mask, if its coefficients are rational.
pub(super) fn as_rational<V: Value>(mask: &Mask<V>) -> Option<Mask> {
    converted(mask, V::as_rational)
}

/// No contraction constant below 1 is found.
pub(super) fn not_shown() -> CallError {
    let what = "limits are not shown to exist (of a parameter, take an interval where they do): the number of residue classes";
    CallError::BeyondCap(Cap::new(what, MAX_CLASSES))
}

/// The greatest number of places at which an integral is summed.
pub(super) const MAX_PLACES: i64 = 256;

/// An error unless two masks have one arity, and are not too long together.
pub(super) fn check_pair<F: Scalar>(first: &Mask<F>, second: &Mask<F>) -> Result<(), CallError> {
    if first.arity() != second.arity() {
        let message = format!("the arities differ: {} and {}", first.arity(), second.arity());
        return Err(CallError::Misuse(message));
    }
    check_size(first, second)
}

pub(super) fn check_size<F: Scalar>(first: &Mask<F>, second: &Mask<F>) -> Result<(), CallError> {
    let size = |mask: &Mask<F>| mask.arity() * mask.width();
    if size(first).saturating_mul(size(second)) > MAX_PRODUCTS {
        let what = "the number of coefficients of one mask times that of the other";
        return Err(CallError::BeyondCap(Cap::new(what, MAX_PRODUCTS as u64)));
    }
    Ok(())
}
