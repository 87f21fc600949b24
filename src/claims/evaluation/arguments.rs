//! Integers among the arguments of functions.

use crate::cap::Cap;
use crate::exact::Rational;
use crate::formula::{CallError, FormulaErrorKind, Value};
use std::ops::RangeInclusive;

pub(crate) fn level<V: Value>(value: &V) -> Result<u32, CallError> {
    let integer = value.as_rational().filter(Rational::is_integer);
    let level = integer.filter(|level| level.sign() >= 0).ok_or_else(|| {
        CallError::Misuse(format!("a number of levels is 0, 1, 2, …, and not {value}"))
    })?;
    let beyond = || CallError::BeyondCap(Cap::new("a number of levels", u32::MAX.into()));
    level.numerator().to_i64().and_then(|level| u32::try_from(level).ok()).ok_or_else(beyond)
}

/// The greatest absolute value of an index.
const MAX_INDEX: i64 = 1_000_000;

/// The value of a nonnegative index.
pub(crate) fn place<V: Value>(what: &'static str, value: &V) -> Result<i64, CallError> {
    match index(what, value)? {
        negative @ ..0 => Err(CallError::Misuse(format!("{what} is not negative, as {negative}"))),
        place => Ok(place),
    }
}

/// The value of an index, an integer.
pub(crate) fn index<V: Value>(what: &'static str, value: &V) -> Result<i64, CallError> {
    let integer = value.as_rational().filter(Rational::is_integer).ok_or_else(|| {
        CallError::Inner(FormulaErrorKind::NotAnInteger { what, value: value.to_string() })
    })?;
    let index = integer.numerator().within(MAX_INDEX);
    index.ok_or_else(|| CallError::BeyondCap(Cap::new(what, MAX_INDEX.unsigned_abs())))
}

/// An integer that has to be in `range`, whose end is a cap.
pub(crate) fn within<V: Value>(
    what: &'static str,
    value: &V,
    range: RangeInclusive<i64>,
) -> Result<usize, CallError> {
    let integer = index(what, value)?;
    let (first, last) = (*range.start(), *range.end());
    if integer > last {
        return Err(CallError::BeyondCap(Cap::new(what, last.unsigned_abs())));
    }
    let found = usize::try_from(integer).ok().filter(|_| integer >= first);
    found.ok_or_else(|| {
        CallError::Misuse(format!("{what} is from {first} to {last}, and not {integer}"))
    })
}

/// A number of convolutions, which is within a cap.
pub(crate) fn narrow(c: usize) -> u32 {
    u32::try_from(c).expect("capped")
}
