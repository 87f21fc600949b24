//! The types of values of formulas.

mod algebraic;
mod expression;
pub(super) mod half_planes;
mod integer_function;
mod quotient;
pub(super) mod real;
pub(super) mod value;
