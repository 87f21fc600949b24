//! Masks on Z^d with a dilation matrix.

pub(super) mod boxes;
pub(super) mod dilation;
mod file;
pub(super) mod formulas;
pub(super) mod integers;
pub(super) mod mask;
pub(super) mod matrices;
mod named;
pub(super) mod read;
