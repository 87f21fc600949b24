//! Integers among the arguments of functions.

use crate::exact::Rational;
use crate::formula::{CallError, FormulaErrorKind, Value};

pub(crate) fn level<V: Value>(value: &V) -> Result<u32, CallError> {
    let integer = value.as_rational().filter(Rational::is_integer);
    let level = integer.and_then(|level| u32::try_from(level.numerator().to_i64()?).ok());
    level.ok_or_else(|| {
        CallError::Misuse(format!("a number of levels is 0, 1, 2, …, and not {value}"))
    })
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
    let cap = MAX_INDEX.unsigned_abs();
    index.ok_or(CallError::Inner(FormulaErrorKind::TooLarge { what, cap }))
}
