//! What follows from findings.

mod coverage;
mod errata;
