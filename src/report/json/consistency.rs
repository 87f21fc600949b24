//! Where the tables of a paper need different readings.

use crate::audit::{self, PaperAudit};
use crate::report::consistency::locus;
use serde::Serialize;

/// Tables that need different readings.
#[derive(Debug, Serialize)]
pub struct Contradiction<'a> {
    /// What they differ in.
    pub about: &'a str,
    /// What they say of it.
    pub sides: Vec<Side<'a>>,
}

/// The tables that say the same.
#[derive(Debug, Serialize)]
pub struct Side<'a> {
    /// What they say.
    pub says: String,
    /// Those tables, rows and columns.
    pub places: Vec<TablePart<'a>>,
}

/// A table, a row or a column, and what explains it.
#[derive(Debug, Serialize)]
pub struct TablePart<'a> {
    /// The id of the table.
    pub table: &'a str,
    /// Where in the paper it is.
    pub locus: String,
    /// How many cells are explained by what it says.
    pub explained: usize,
    /// How many are explained by what another side says.
    pub otherwise: usize,
}

impl<'a> Contradiction<'a> {
    /// All those of a paper.
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
