//! A claim file of a project as TOML gives it.

use super::nested::Nested;
use crate::scheme::Spanned;
use serde::Deserialize;
use std::collections::BTreeMap;

/// A claim file.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(super) struct ProjectFile {
    /// The name of the project in ids: letters, digits, `-`, `_` and `.`.
    pub(super) key: Spanned<String>,
    /// The project.
    pub(super) project: ProjectTable,
    /// Names with formulas.
    #[serde(default)]
    pub(super) define: BTreeMap<Spanned<String>, Spanned<String>>,
    /// Tables of constants.
    #[serde(default)]
    pub(super) shipped: Vec<ShippedTable>,
}

/// `[project]`.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(super) struct ProjectTable {
    /// Its name.
    pub(super) name: String,
    /// Its address.
    pub(super) repository: Option<String>,
    /// The commit that was read.
    pub(super) commit: Option<Spanned<String>>,
    /// Its licence.
    pub(super) licence: Option<String>,
    /// What a reader should know.
    pub(super) note: Option<String>,
}

/// `[[shipped]]`.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(super) struct ShippedTable {
    /// The name of the table, its own in the file.
    pub(super) id: Spanned<String>,
    /// Where it stands: file and line, or name.
    pub(super) locus: String,
    /// What it is.
    #[serde(default)]
    pub(super) title: String,
    /// The type of the numbers.
    #[serde(rename = "type")]
    pub(super) kind: Spanned<String>,
    /// The indices of the cells.
    #[serde(default)]
    pub(super) indices: Vec<Spanned<String>>,
    /// The formula that each cell is said to equal.
    pub(super) equals: Option<Spanned<String>>,
    /// In its place: the exact values, one for each cell.
    pub(super) equals_cells: Option<Spanned<Vec<Spanned<Nested>>>>,
    /// The numbers as written.
    pub(super) cells: Option<Spanned<Vec<Spanned<Nested>>>>,
    /// In their place: the source file that has them.
    pub(super) cells_from: Option<Spanned<CellsFrom>>,
    /// The programming language, which says how literals are read.
    pub(super) language: Option<Spanned<String>>,
    /// How far a number may be from its exact value.
    pub(super) tolerance: Option<Spanned<String>>,
    /// Other formulas that the numbers may follow.
    #[serde(default)]
    pub(super) convention: Vec<ConventionTable>,
    /// What a reader should know.
    pub(super) note: Option<String>,
}

/// `cells_from`.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(super) struct CellsFrom {
    /// The file, from the folder of the claim file.
    pub(super) file: Spanned<String>,
    /// The name of the table, or a list of names of which each has one number.
    pub(super) after: Spanned<Nested>,
    /// How many numbers in each direction.
    pub(super) shape: Option<Spanned<Vec<Spanned<String>>>>,
    /// How many numbers are left out first.
    pub(super) skip: Option<Spanned<String>>,
}

/// `[[shipped.convention]]`.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(super) struct ConventionTable {
    /// A few words for it.
    pub(super) label: Spanned<String>,
    /// The formula of a cell.
    pub(super) equals: Option<Spanned<String>>,
    /// In its place: one value for each cell.
    pub(super) equals_cells: Option<Spanned<Vec<Spanned<Nested>>>>,
}

/// The JSON schema of claim files about programs, from the types that are read.
#[cfg(feature = "schema")]
#[must_use]
pub fn project_schema() -> schemars::Schema {
    schemars::schema_for!(ProjectFile)
}
