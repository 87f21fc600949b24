//! Formulas, and the scopes in which they have values.

mod definitions;
mod evaluate;
mod formula;
mod memory;
mod range;
mod reading;

pub use definitions::{Definitions, formula, formula_of, formulas, free, names};
pub use evaluate::{Asked, Functions, MAX_INTEGER, Scope, member};
pub use formula::{Expr, Head, MAX_LENGTH, is_name, number_of, parse};
pub use memory::{Indices, Memory};
pub use range::{Range, of_nothing, range};
pub use reading::{CHOICES, Reading};
