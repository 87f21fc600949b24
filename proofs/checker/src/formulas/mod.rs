//! Formulas, and the scopes in which they have values.

pub mod definitions;
pub mod evaluate;
pub mod formula;
pub mod reading;
