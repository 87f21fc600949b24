//! Functions whose values are real numbers of any kind: known exactly, or enclosed.

mod exponents;
mod vertices;

pub use exponents::Limits;
pub(crate) use exponents::{KnownReals, Used};
pub(crate) use vertices::of_ring;

use crate::formula::{Call, CallError, FormulaErrorKind, RealValue, Value};

/// The functions of masks among them.
const OF_MASKS: [&str; 10] = [
    "smoothness",
    "hoelder",
    "sobolev",
    "riesz_lower",
    "riesz_upper",
    "overshoot",
    "gibbs",
    "modulus",
    "modulus_lower",
    "modulus_upper",
];

/// The functions of rings.
const OF_RINGS: [&str; 5] =
    ["eigenvalue", "subdominant", "curvature", "limit_weight", "tangent_weight"];

/// What such a function is about.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum About {
    Mask,
    Ring,
}

/// Whether this is `eigenvalue(j)`, which is about masks too.
pub(crate) fn is_of_mask_too<V>(call: &Call<'_, V>) -> bool {
    call.function == "eigenvalue" && call.arguments.len() == 1
}

/// What the function of this name is about, if it is one of these.
pub(crate) fn about(function: &str) -> Option<About> {
    if OF_MASKS.contains(&function) {
        return Some(About::Mask);
    }
    OF_RINGS.contains(&function).then_some(About::Ring)
}

/// The value as one of another type.
///
/// # Errors
/// When the type has no such number.
pub(crate) fn as_value<V: Value>(function: &str, value: &RealValue) -> Result<V, CallError> {
    let number = value.number().and_then(|number| V::of_number(&number));
    number.ok_or_else(|| {
        CallError::Inner(FormulaErrorKind::OtherReal(format!("this value of `{function}`")))
    })
}
