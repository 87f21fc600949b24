//! What a kind of claim is to the checker.

use super::table::recovered::Recovered;
use crate::claims::Paper;
use crate::text::{Block, Checked, Toml};

/// A kind of claim.
pub struct Kind {
    /// The name of its tables in a claim file, and of its blocks in a certificate.
    pub name: &'static str,
    /// The fields of its tables, and of the tables that only these contain (claims/shape.rs).
    pub fields: &'static str,
    /// The names that a claim defines.
    pub names: for<'a> fn(&'a Toml) -> Vec<&'a str>,
    /// Checks a block that is about a claim.
    pub check: for<'a> fn(&'a Paper<'a>, &'a Toml, &mut Block<'_>) -> Checked<Proof>,
}

/// What a valid certificate gives besides the verdict that it states.
pub enum Proof {
    /// Nothing.
    Other,
    /// A theorem is proved or refuted by a statement of THEOREMS.md.
    Cited(Citation),
    /// A table rests on recovered values, or gives them to others.
    Recovers(Recovered),
}

/// A statement of THEOREMS.md that decides a claim, if some claims hold.
pub struct Citation {
    /// The statement.
    pub statement: String,
    /// The ids of the claims.
    pub uses: Vec<String>,
}
