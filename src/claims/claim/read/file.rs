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
use crate::scheme::{SchemeTable, Spanned};
use serde::Deserialize;

/// A claim file.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(super) struct PaperFile {
    /// The name of the paper in ids: letters, digits, `-`, `_` and `.`.
    pub(super) key: Spanned<String>,
    /// The paper.
    pub(super) paper: BibliographyTable,
    /// Names with formulas: the definitions of the paper, in its own notation.
    #[serde(default)]
    pub(super) define: Formulas,
    /// Other formulas for definitions, which readings may put in their place.
    #[serde(default)]
    pub(super) alternative: Vec<AlternativeTable>,
    /// Names with closed formulas: values that the paper states for everything.
    #[serde(default)]
    pub(super) given: Formulas,
    /// Schemes of the paper's own.
    #[serde(default)]
    pub(super) scheme: Vec<SchemeTable>,
    /// Tables of numbers.
    #[serde(default)]
    pub(super) table: Vec<TableTable>,
    /// Equations.
    #[serde(default)]
    pub(super) equation: Vec<EquationTable>,
    /// Closed forms in a free parameter.
    #[serde(default)]
    pub(super) function: Vec<FunctionTable>,
    /// Ranges of a parameter in which a value is limited, or limits are smooth.
    #[serde(default)]
    pub(super) range: Vec<RangeTable>,
    /// Whether limits are C^m.
    #[serde(default)]
    pub(super) smoothness: Vec<SmoothnessTable>,
    /// Hölder exponents.
    #[serde(default)]
    pub(super) exponent: Vec<ExponentTable>,
    /// Tables of orders of smoothness and of Hölder exponents.
    #[serde(default)]
    pub(super) regularity: Vec<RegularityFile>,
    /// Bounds, depths, and statements of other kinds.
    #[serde(default)]
    pub(super) theorem: Vec<TheoremTable>,
    /// What asserts nothing that could be checked.
    #[serde(default)]
    pub(super) unclaimed: Vec<UnclaimedTable>,
}

/// `[paper]`.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(super) struct BibliographyTable {
    /// The authors.
    #[serde(default)]
    authors: Vec<String>,
    /// The title.
    title: String,
    /// Where it has appeared.
    #[serde(default)]
    venue: String,
    /// The year.
    year: String,
    /// The DOI.
    doi: Option<String>,
    /// What a reader should know.
    note: Option<String>,
    /// What the paper numbers: `["(1)-(4)", "Table 1-3", "Theorem 1"]`.
    #[serde(default)]
    pub(super) numbered: Vec<Spanned<String>>,
}

/// `[[alternative]]`.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(super) struct AlternativeTable {
    /// The definition.
    pub(super) of: Spanned<String>,
    /// A few words for it.
    pub(super) label: Spanned<String>,
    /// The other formula.
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
