//! Rules around a vertex or on a face: rings.

pub(super) mod definition;
pub(super) mod every;
pub(super) mod file;
pub(super) mod formulas;
pub(super) mod rules;
pub(super) mod symmetry;
