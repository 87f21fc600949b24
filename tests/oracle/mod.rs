//! Reference values and checks for other programs' tests.

mod check;
mod languages;
mod lattice;
mod local_rules;
mod refine;
mod values;
