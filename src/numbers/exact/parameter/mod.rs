//! Functions of one free parameter, and sets of parameters.

pub(super) mod interval;
pub(super) mod interval_set;
pub(super) mod parametric;
pub(super) mod piecewise;
pub(super) mod quotient_at;
