//! Where the tables of a paper need different readings.

use crate::audit::{self, PaperAudit};
use crate::report::papers::consistency::locus;
use serde::Serialize;

/// Tables that need different readings.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Contradiction<'a> {
    /// The choice or the parameter of which they need different values.
    pub about: &'a str,
    /// The sides of the contradiction.
    pub sides: Vec<Side<'a>>,
}

/// The tables, rows and columns that need the same.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Side<'a> {
    /// What they need.
    pub says: String,
    /// These tables, rows and columns.
    pub places: Vec<TablePart<'a>>,
}

/// A table, a row or a column, and the number of its cells that are explained.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct TablePart<'a> {
    /// The id of the table.
    pub table: &'a str,
    /// Where in the paper it is.
    pub locus: String,
    /// How many of its cells are explained with what this side needs.
    pub explained: usize,
    /// How many of its cells at most are explained with what another side needs.
    pub otherwise: usize,
}

impl<'a> Contradiction<'a> {
    /// All contradictions of a paper.
    pub(super) fn all(audit: &'a PaperAudit<'_>) -> Vec<Contradiction<'a>> {
        let part = |part: &'a audit::TablePart| TablePart {
            table: &part.table,
            locus: locus(audit, part),
            explained: part.explained,
            otherwise: part.otherwise,
        };
        let side = |side: &'a audit::Side| Side {
            says: side.needs.to_string(),
            places: side.places.iter().map(part).collect(),
        };
        let one = |contradiction: &'a audit::Contradiction| Contradiction {
            about: &contradiction.about,
            sides: contradiction.sides.iter().map(side).collect(),
        };
        audit.contradictions.iter().map(one).collect()
    }
}
