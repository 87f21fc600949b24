//! Findings as certificates for a checker that trusts nothing of this, and as text and pages.
//!
//! | module | what it holds |
//! |---|---|
//! | [`certificate`] | verdicts as certificates, and as theorems of Coq |
//! | `report` | findings as text, Markdown, LaTeX and JSON, and as pages (feature `report`) |
//!
//! Rooms of the crates below have their names here too, so that `crate::exact` is the same
//! everywhere.

use subcert_claims::{audit, claim, shipped};
use subcert_numbers::{diagnostic, exact, formula, stop};
use subcert_schemes::{bound, characteristic, joint, lattice, limit, scheme, smoothness, spectrum};
#[cfg(feature = "report")]
use subcert_schemes::{facts, float};

#[cfg(feature = "report")]
use subcert_geometry::{net, patch};

pub mod certificate;
#[cfg(feature = "report")]
pub mod report;
