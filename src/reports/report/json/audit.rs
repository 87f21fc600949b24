//! An audit as JSON.

use super::claim::Claim;
use super::consistency::Contradiction;
use super::offset::BetterOffset;
use super::summary::Summary;
use super::{SCHEMA, counts};
use crate::audit::{self, PaperAudit, PromiseCounts, TableFinding, Word};
use crate::claim::Kind;
use crate::report::json::tables::reading::Search;
use crate::report::json::tables::recovered::{Fitting, Recovered};
use crate::report::told::told;
use serde::Serialize;
use std::collections::BTreeMap;

/// What `subcert audit` finds.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct AuditReport<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The papers.
    pub papers: Vec<Paper<'a>>,
}

/// What an audit finds in a paper.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Paper<'a> {
    /// The paper's key.
    pub key: &'a str,
    /// Its claims: the cells of its tables, its equations, closed forms, ranges, claims about smoothness
    /// and theorems.
    pub claims: Vec<Claim<'a>>,
    /// How many claims have each verdict.
    pub summary: BTreeMap<&'static str, usize>,
    /// Where its tables need different readings.
    pub contradictions: Vec<Contradiction<'a>>,
    /// The better offsets of schemes whose offset the claim file does not state; missing where there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub better_offsets: Vec<UnstatedOffset>,
    /// Its tables.
    pub tables: Vec<Table<'a>>,
    /// How many cells are in each standing.
    pub cells: Summary,
    /// How many printed bounds and depths keep their promise.
    pub promises: PromiseTally,
}

/// A scheme whose offset the claim file does not state, with a better one than 0.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct UnstatedOffset {
    /// The scheme, with the parameters of the first cell whose scheme it is.
    pub scheme: String,
    /// The better offset of its mask.
    #[serde(flatten)]
    pub better: BetterOffset,
}

impl UnstatedOffset {
    fn of(found: &audit::UnstatedOffset) -> UnstatedOffset {
        let better = BetterOffset::of(&found.better);
        UnstatedOffset { scheme: found.scheme.to_string(), better }
    }
}

/// A table, with the search for its reading.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Table<'a> {
    /// Its id within the paper.
    pub id: &'a str,
    /// Where in the paper it is.
    pub locus: &'a str,
    /// The formula that its cells are said to equal.
    pub value: &'a str,
    /// The parameters that the paper does not state and that were recovered; missing where there
    /// are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub recovered: Vec<Recovered<'a>>,
    /// Where nothing was recovered, the values that fit best, which may be luck; missing where none
    /// fit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fitting: Option<Fitting<'a>>,
    /// The search for a reading that explains its cells; null where none was needed.
    pub search: Option<Search<'a>>,
    /// The search for a reading that explains its cells with a parameter that the paper does not
    /// state; missing where a table has only one kind of cells.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub search_of_cells_with_assumptions: Option<Search<'a>>,
}

/// How many printed bounds and depths keep their promise for all control data.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PromiseTally {
    /// They do.
    pub kept: usize,
    /// They do not.
    pub broken: usize,
    /// It is not decided whether they do.
    pub open: usize,
}

impl<'a> AuditReport<'a> {
    /// The JSON form of these audits.
    #[must_use]
    pub fn of(audits: &'a [PaperAudit<'_>]) -> AuditReport<'a> {
        AuditReport { schema: SCHEMA, papers: audits.iter().map(Paper::of).collect() }
    }
}

impl<'a> Paper<'a> {
    fn of(audit: &'a PaperAudit<'_>) -> Paper<'a> {
        let claims = audit.findings().flat_map(|finding| told(finding).form(audit)).collect();
        let tally = audit.tally(Kind::ALL);
        let mut summary: BTreeMap<&str, usize> =
            Word::OF_CELLS.iter().map(|word| (word.name(), 0)).collect();
        summary.extend(counts(&tally));
        let PromiseCounts { kept, broken, open } = audit.promise_counts();
        Paper {
            key: &audit.paper.key,
            claims,
            summary,
            contradictions: Contradiction::all(audit),
            better_offsets: audit.unstated_offsets.iter().map(UnstatedOffset::of).collect(),
            tables: audit.tables.iter().map(Table::of).collect(),
            cells: Summary::of(&audit.cell_summary()),
            promises: PromiseTally { kept, broken, open },
        }
    }
}

impl<'a> Table<'a> {
    fn of(finding: &'a TableFinding<'_>) -> Table<'a> {
        let table = finding.table;
        Table {
            id: &table.id,
            locus: &table.locus,
            value: &table.value.text,
            recovered: finding.recovered.iter().map(Recovered::of).collect(),
            fitting: finding.fitting.as_ref().map(Fitting::of),
            search: finding.search.as_ref().map(|search| Search::of(table, search)),
            search_of_cells_with_assumptions: finding
                .assumed_search
                .as_ref()
                .map(|search| Search::of(table, search)),
        }
    }
}
