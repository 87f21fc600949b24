//! Real numbers that are not rational.

pub(super) mod algebraic;
pub(super) mod comparable;
pub(super) mod cyclotomic;
pub(super) mod expression;
pub(super) mod number_field;
pub(super) mod roots;

pub(super) mod square;
