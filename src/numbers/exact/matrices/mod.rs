//! Matrices, and what is computed from them.

pub(super) mod adjugate;
pub(super) mod characteristic;
pub(super) mod elimination;
pub(super) mod linear;
pub(super) mod matrix;
pub(super) mod modular;
pub(super) mod short_echelon;
