//! Functions of masks over any ordered field: of numbers, or of functions of a parameter at a place of it.

use super::common::{IRRATIONAL, converted, numbers};
use crate::exact::{FieldElement, QuotientAt, Real};
use crate::formula::{CallError, FormulaErrorKind, Value};
use crate::scheme::Mask;
use std::fmt::Display;

/// What is asked of masks: of one, or of several.
pub(super) trait Asked {
    /// Its value, with the numbers that it needs besides.
    fn value<F: Real + PartialEq + Display>(
        &self,
        masks: &[Mask<F>],
        numbers: &[F],
    ) -> Result<F, CallError>;
}

/// The value over the field of the coefficients, which are numbers or functions of one parameter.
pub(super) fn answered<V: Value>(
    asked: &impl Asked,
    masks: &[&Mask<V>],
    others: &[&V],
) -> Result<V, CallError> {
    let located: Option<Vec<Mask<QuotientAt>>> =
        masks.iter().map(|mask| converted(mask, V::at_place)).collect();
    let at_place: Option<Vec<QuotientAt>> = others.iter().map(|value| value.at_place()).collect();
    let in_field: Option<Vec<Mask<FieldElement>>> =
        masks.iter().map(|mask| converted(mask, V::element)).collect();
    let elements: Option<Vec<FieldElement>> = others.iter().map(|value| value.element()).collect();
    let found = if let (Some(masks), Some(others)) = (located, at_place) {
        V::of_place(asked.value(&masks, &others)?)
    } else if let (Some(masks), Some(others)) = (in_field, elements) {
        V::of_element(&asked.value(&masks, &others)?)
    } else {
        let masks = masks.iter().map(|mask| numbers(mask));
        let others = others.iter().map(|value| {
            let message = || CallError::Misuse(format!("a number is needed here, and not {value}"));
            value.number().ok_or_else(message)
        });
        let masks = masks.collect::<Result<Vec<_>, CallError>>()?;
        V::of_number(&asked.value(&masks, &others.collect::<Result<Vec<_>, CallError>>()?)?)
    };
    found.ok_or(CallError::Inner(FormulaErrorKind::Unsupported(IRRATIONAL)))
}
