//! A claim file as TOML gives it.

use super::contents::UnclaimedTable;
use super::fields::{CommonFields, Formulas};
use super::kind::ClaimTable;
use super::regularity::RegularityFile;
use crate::claim::Bibliography;
use crate::scheme::{SchemeTable, Spanned};
use serde::Deserialize;

macro_rules! claim_file {
    ($($(#[$doc:meta])* $field:ident: $table:ty,)* .. $($(#[$last_doc:meta])* $last:ident: $last_table:ty,)*) => {
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
            $($(#[$doc])* #[serde(default)] pub(super) $field: Vec<$table>,)*
            /// Tables of orders of smoothness and of Hölder exponents.
            #[serde(default)]
            pub(super) regularity: Vec<RegularityFile>,
            $($(#[$last_doc])* #[serde(default)] pub(super) $last: Vec<$last_table>,)*
            /// What asserts nothing that could be checked.
            #[serde(default)]
            pub(super) unclaimed: Vec<UnclaimedTable>,
        }

        impl PaperFile {
            /// The claims, with the common fields of each.
            pub(super) fn claims(&self) -> impl Iterator<Item = (CommonFields<'_>, &dyn ClaimTable)> {
                let none = std::iter::empty();
                let all = none$(.chain(self.$field.iter().map(|table| (table.common(), table as &dyn ClaimTable))))*;
                all$(.chain(self.$last.iter().map(|table| (table.common(), table as &dyn ClaimTable))))*
            }
        }
    };
}

// The tables that state claims. `regularity` stands in the file before the last.
claim_file! {
    /// Tables of numbers.
    table: super::table::TableTable,
    /// Equations.
    equation: super::equation::EquationTable,
    /// Relations between formulas, and what is so of a scheme.
    relation: super::relation::RelationTable,
    /// Closed forms in a free parameter.
    function: super::function::FunctionTable,
    /// Ranges of a parameter in which a value is limited, or limits are smooth.
    range: super::function::RangeTable,
    /// Whether limits are C^m.
    smoothness: super::smoothness::SmoothnessTable,
    /// Hölder exponents.
    exponent: super::smoothness::ExponentTable,
    ..
    /// Bounds, depths, and statements of other kinds.
    theorem: super::theorem::TheoremTable,
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
