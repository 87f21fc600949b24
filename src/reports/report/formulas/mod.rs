//! Equations, closed forms and ranges of a parameter in words.

pub(super) mod equation;
pub(super) mod function;
