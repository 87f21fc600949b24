//! Functions of masks over any ordered field: of numbers, or of functions of a parameter at a place of it.

use super::common::{IRRATIONAL, converted, numbers};
use crate::exact::{QuotientAt, Real};
use crate::formula::{CallError, FormulaErrorKind, Value};
use crate::scheme::Mask;
use std::fmt::Display;

/// What is asked of masks: of one, or of several.
pub(super) trait Asked {
    /// Its value.
    fn value<F: Real + PartialEq + Display>(&self, masks: &[Mask<F>]) -> Result<F, CallError>;
}

/// The value over the field of the coefficients, which are numbers or functions of one parameter.
pub(super) fn answered<V: Value>(asked: &impl Asked, masks: &[&Mask<V>]) -> Result<V, CallError> {
    let located: Option<Vec<Mask<QuotientAt>>> =
        masks.iter().map(|mask| converted(mask, V::at_place)).collect();
    let found = if let Some(masks) = located {
        V::of_place(asked.value(&masks)?)
    } else {
        let masks = masks.iter().map(|mask| numbers(mask));
        V::of_number(&asked.value(&masks.collect::<Result<Vec<_>, CallError>>()?)?)
    };
    found.ok_or(CallError::Inner(FormulaErrorKind::Unsupported(IRRATIONAL)))
}
