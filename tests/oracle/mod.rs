//! Reference values and checks for other programs' tests.

mod check;
mod local_rules;
mod refine;
mod values;
