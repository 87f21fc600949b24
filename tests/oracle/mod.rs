//! Reference values and checks for other programs' tests.

mod check;
mod refine;
mod ring;
mod values;
