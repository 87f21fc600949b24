//! What `subcert explain KEY` writes.

use serde::Serialize;

/// The claims of a paper.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Listing<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The paper's key.
    pub key: &'a str,
    /// Its claims.
    pub claims: Vec<Claim<'a>>,
}

/// A claim that can be explained.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Claim<'a> {
    /// Its id within the paper.
    pub id: &'a str,
    /// `table`, `equation`, `function`, `range` or `theorem`.
    pub kind: &'static str,
    /// Where in the paper it is.
    pub locus: &'a str,
    /// What it is.
    pub title: &'a str,
}
