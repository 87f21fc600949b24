//! Why a number has no value of a smaller type.

use super::Rational;

/// A number that the type asked for does not hold.
///
/// ```
/// use subcert::exact::{Integer, Rational};
///
/// let error = Integer::try_from(Rational::new(1, 2)).unwrap_err();
/// assert_eq!(error.to_string(), "1/2 does not fit into Integer");
/// ```
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{value} does not fit into {target}")]
pub struct ConversionError {
    /// The number.
    pub value: Rational,
    /// The name of the type.
    pub target: &'static str,
}

impl ConversionError {
    pub(super) fn new(value: impl Into<Rational>, target: &'static str) -> ConversionError {
        ConversionError { value: value.into(), target }
    }
}
