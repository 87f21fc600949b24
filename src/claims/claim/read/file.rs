//! A claim file as TOML gives it.

use super::contents::UnclaimedTable;
use super::equation::EquationTable;
use super::fields::{CommonFields, Formulas};
use super::function::{FunctionTable, RangeTable};
use super::regularity::RegularityFile;
use super::smoothness::{ExponentTable, SmoothnessTable};
use super::table::TableTable;
use super::theorem::TheoremTable;
use crate::claim::Bibliography;
use crate::scheme::SchemeTable;
use serde::Deserialize;
use toml::Spanned;

/// A claim file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PaperFile {
    pub(super) key: Spanned<String>,
    pub(super) paper: BibliographyTable,
    #[serde(default)]
    pub(super) define: Formulas,
    #[serde(default)]
    pub(super) alternative: Vec<AlternativeTable>,
    #[serde(default)]
    pub(super) given: Formulas,
    #[serde(default)]
    pub(super) scheme: Vec<SchemeTable>,
    #[serde(default)]
    pub(super) table: Vec<TableTable>,
    #[serde(default)]
    pub(super) equation: Vec<EquationTable>,
    #[serde(default)]
    pub(super) function: Vec<FunctionTable>,
    #[serde(default)]
    pub(super) range: Vec<RangeTable>,
    #[serde(default)]
    pub(super) smoothness: Vec<SmoothnessTable>,
    #[serde(default)]
    pub(super) exponent: Vec<ExponentTable>,
    #[serde(default)]
    pub(super) regularity: Vec<RegularityFile>,
    #[serde(default)]
    pub(super) theorem: Vec<TheoremTable>,
    #[serde(default)]
    pub(super) unclaimed: Vec<UnclaimedTable>,
}

/// `[paper]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct BibliographyTable {
    #[serde(default)]
    authors: Vec<String>,
    title: String,
    #[serde(default)]
    venue: String,
    year: String,
    doi: Option<String>,
    note: Option<String>,
    #[serde(default)]
    pub(super) numbered: Vec<Spanned<String>>,
}

/// `[[alternative]]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct AlternativeTable {
    pub(super) of: Spanned<String>,
    pub(super) label: Spanned<String>,
    pub(super) value: Spanned<String>,
}

impl BibliographyTable {
    pub(super) fn bibliography(&self) -> Bibliography {
        Bibliography {
            authors: self.authors.clone(),
            title: self.title.clone(),
            venue: self.venue.clone(),
            year: self.year.clone(),
            doi: self.doi.clone(),
            note: self.note.clone(),
        }
    }
}

impl PaperFile {
    /// The common fields of the claims of every kind.
    pub(super) fn claims(&self) -> impl Iterator<Item = CommonFields<'_>> {
        let tables = self.table.iter().map(TableTable::common);
        let equations = self.equation.iter().map(EquationTable::common);
        let functions = self.function.iter().map(FunctionTable::common);
        let ranges = self.range.iter().map(RangeTable::common);
        let smoothness = self.smoothness.iter().map(SmoothnessTable::common);
        let exponents = self.exponent.iter().map(ExponentTable::common);
        let theorems = self.theorem.iter().map(TheoremTable::common);
        let claims = tables.chain(equations).chain(functions).chain(ranges);
        claims.chain(smoothness).chain(exponents).chain(theorems)
    }
}
