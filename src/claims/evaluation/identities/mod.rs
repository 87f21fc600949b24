//! What the functions of formulas are in relations: of real numbers of any kind, and for all integers.

pub(crate) mod families;
pub(crate) mod integer_functions;
pub(crate) mod real_formulas;
