//! What follows from findings.

mod coverage;
mod errata;
mod luck;
