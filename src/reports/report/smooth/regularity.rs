//! Tables of orders of smoothness and of exponents, in their own shape.

use crate::audit::{PaperAudit, SmoothnessFinding, SmoothnessVerdict};
use crate::claim::{RegularityTable, Target};
use crate::report::words::parts::titled;
use crate::report::words::sheet::{Grid, Sheet};
use std::collections::BTreeMap;
use std::sync::Arc;

/// A table with the finding of each cell; `None` where nothing is printed.
pub(crate) struct Regularity<'f, 'a> {
    pub(crate) table: &'f RegularityTable,
    pub(crate) cells: Vec<Vec<Option<&'f SmoothnessFinding<'a>>>>,
}

/// The tables of which an audit has judged cells.
pub(crate) fn tables<'f, 'a>(audit: &'f PaperAudit<'a>) -> Vec<Regularity<'f, 'a>> {
    let empty = |table: &'f Arc<RegularityTable>| Regularity {
        table,
        cells: vec![vec![None; table.columns.len()]; table.rows.len()],
    };
    let mut tables: BTreeMap<&str, Regularity<'f, 'a>> = BTreeMap::new();
    for finding in &audit.smoothness {
        let Some(cell) = &finding.claim.cell else { continue };
        let found = tables.entry(&cell.table.id).or_insert_with(|| empty(&cell.table));
        found.cells[cell.row][cell.column] = Some(finding);
    }
    audit.paper.regularity.iter().filter_map(|table| tables.remove(&table.id[..])).collect()
}

/// A cell as printed.
pub(crate) fn printed<'f>(finding: &SmoothnessFinding<'f>) -> &'f str {
    finding.claim.cell.as_ref().map_or("", |cell| &cell.printed)
}

/// The table that is named.
pub(crate) fn table_of<'f, 'a>(
    audit: &'f PaperAudit<'a>,
    id: Target<'_>,
) -> Option<Regularity<'f, 'a>> {
    let own = audit.paper.key == id.key && id.part.is_none();
    tables(audit).into_iter().find(|found| own && found.table.id == id.claim)
}

/// Appends the tables; without `all`, those that are not confirmed throughout.
pub(crate) fn section(sheet: &mut Sheet, audit: &PaperAudit<'_>, all: bool) {
    for found in tables(audit) {
        let Regularity { table, cells } = &found;
        let mut findings = cells.iter().flatten().flatten();
        if !all && findings.all(|finding| finding.verdict == SmoothnessVerdict::Confirmed) {
            continue;
        }
        sheet.heading(3, titled(&[&table.locus, &table.title, &table.id]));
        grid(sheet, &found);
    }
}

/// Appends the cells with their verdicts, and the note.
pub(crate) fn grid(sheet: &mut Sheet, Regularity { table, cells }: &Regularity<'_, '_>) {
    let cell = |finding: Option<&SmoothnessFinding<'_>>| {
        finding.map_or_else(
            || "·".to_owned(),
            |finding| format!("{} {}", printed(finding), finding.verdict.word().mark()),
        )
    };
    let row = |(header, cells): (&String, &Vec<Option<&SmoothnessFinding<'_>>>)| {
        [header.clone()].into_iter().chain(cells.iter().copied().map(cell)).collect()
    };
    let header = [table.label.clone()].into_iter().chain(table.columns.clone());
    sheet.grid(Grid::of(header, table.rows.iter().zip(cells).map(row), 1));
    if let Some(note) = &table.note {
        sheet.text(note.clone());
    }
}
