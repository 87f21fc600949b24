//! The family: one file for each choice.

mod contraction_terms;
mod decimal_rounding;
mod depth_rounding;
mod displacement_terms;
mod exponent;
mod header;
mod offset;
mod order;
mod recursion;
mod suprema;

use super::choice::Choice;
pub(in crate::audit) use decimal_rounding::DECIMAL_ROUNDING;
pub(in crate::audit) use depth_rounding::DEPTH_ROUNDING;
pub(in crate::audit) use header::HEADER;

/// Every choice.
pub const FAMILY: [&Choice; 10] = [
    &order::ORDER,
    &suprema::SUPREMA,
    &contraction_terms::CONTRACTION_TERMS,
    &displacement_terms::DISPLACEMENT_TERMS,
    &offset::OFFSET,
    &recursion::RECURSION,
    &exponent::EXPONENT,
    &DEPTH_ROUNDING,
    &DECIMAL_ROUNDING,
    &HEADER,
];
