//! The types of values of formulas.

mod algebraic;
mod expression;
mod quotient;
pub(super) mod real;
pub(super) mod value;
