//! Polynomials in several variables.

pub(super) mod bivariate;
pub(super) mod monomial;
pub(super) mod one_variable;
pub(super) mod polynomial;
pub(super) mod vanishing;
