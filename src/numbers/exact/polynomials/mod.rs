//! Polynomials in one variable, and their real roots.

pub(super) mod dense;
pub(super) mod descartes;
pub(super) mod factor;
pub(super) mod rational_polynomial;
pub(super) mod sign_at;
pub(super) mod sturm;
pub(super) mod univariate;
