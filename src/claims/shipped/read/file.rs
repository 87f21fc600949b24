//! A claim file of a project as TOML gives it.

use super::nested::Nested;
use serde::Deserialize;
use std::collections::BTreeMap;
use toml::Spanned;

/// A claim file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ProjectFile {
    pub(super) key: Spanned<String>,
    pub(super) project: ProjectTable,
    #[serde(default)]
    pub(super) define: BTreeMap<Spanned<String>, Spanned<String>>,
    #[serde(default)]
    pub(super) shipped: Vec<ShippedTable>,
}

/// `[project]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ProjectTable {
    pub(super) name: String,
    pub(super) repository: Option<String>,
    pub(super) commit: Option<Spanned<String>>,
    pub(super) licence: Option<String>,
    pub(super) note: Option<String>,
}

/// `[[shipped]]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ShippedTable {
    pub(super) id: Spanned<String>,
    pub(super) locus: String,
    #[serde(default)]
    pub(super) title: String,
    #[serde(rename = "type")]
    pub(super) kind: Spanned<String>,
    #[serde(default)]
    pub(super) indices: Vec<Spanned<String>>,
    pub(super) equals: Option<Spanned<String>>,
    pub(super) equals_cells: Option<Spanned<Vec<Spanned<Nested>>>>,
    pub(super) cells: Option<Spanned<Vec<Spanned<Nested>>>>,
    pub(super) cells_from: Option<Spanned<CellsFrom>>,
    pub(super) language: Option<Spanned<String>>,
    pub(super) tolerance: Option<Spanned<String>>,
    #[serde(default)]
    pub(super) convention: Vec<ConventionTable>,
    pub(super) note: Option<String>,
}

/// `cells_from`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CellsFrom {
    pub(super) file: Spanned<String>,
    pub(super) after: Spanned<String>,
    pub(super) shape: Option<Spanned<Vec<Spanned<String>>>>,
    pub(super) skip: Option<Spanned<String>>,
}

/// `[[shipped.convention]]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ConventionTable {
    pub(super) label: Spanned<String>,
    pub(super) equals: Option<Spanned<String>>,
    pub(super) equals_cells: Option<Spanned<Vec<Spanned<Nested>>>>,
}
