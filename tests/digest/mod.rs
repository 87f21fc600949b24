//! What follows from findings.

mod coverage;
mod errata;
mod kernel;
mod luck;
