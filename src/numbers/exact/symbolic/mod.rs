//! Polynomials in several variables.

pub(super) mod bivariate;
mod division;
pub(super) mod monomial;
pub(super) mod one_variable;
pub(super) mod polynomial;
pub(super) mod vanishing;
