//! What papers and programs claim, and whether it is so.
//!
//! | module | what it holds |
//! |---|---|
//! | [`literal`] | tables of numbers in the source files of programs |
//! | [`verdict`] | the words for verdicts, their marks and standings
//! | [`claim`] | what a paper asserts |
//! | [`shipped`] | tables of constants in programs: claim files about them, and verdicts |
//! | `evaluation` | from the formulas of claims to values, under a reading |
//! | `finding` | what the audit says of claims, as plain data |
//! | `judge` | verdicts, one file for each kind of claim |
//! | `digest` | what follows from findings: errata, coverage, contradictions |
//! | `evidence` | what certificates need beyond the findings |
//! | [`audit`] | the face of these five: from claims to verdicts |
//!
//! Rooms of the crates below have their names here too, so that `crate::exact` is the same
//! everywhere.

use subcert_numbers::{cap, cores, diagnostic, exact, formula, stop, suggestion};
use subcert_schemes::{
    bound, characteristic, facts, float, lattice, limit, scheme, smoothness, spectrum,
};

pub mod audit;
pub mod claim;
mod digest;
mod evaluation;
mod evidence;
mod finding;
mod judge;
pub mod literal;
pub mod shipped;
pub mod verdict;
