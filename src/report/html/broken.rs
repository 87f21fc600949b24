//! A promise of a table that is not kept, drawn.

use super::cell::anchor;
use super::picture::{Exceeding, levels, witness};
use crate::audit::{
    Broken, CellFinding, Kept, PaperAudit, TableFinding, depth_levels, promise_mask,
};
use crate::diagnostic::Diagnostic;
use maud::{Markup, html};

/// The first promise that is not kept, drawn: of a depth with the sound bound, of a polygon with its limit.
pub(super) fn broken(
    audit: &PaperAudit<'_>,
    finding: &TableFinding<'_>,
) -> Result<Markup, Diagnostic> {
    let Some((at, cell, broken)) = first_broken(finding) else { return Ok(html! {}) };
    let depth = depth_levels(audit.paper, finding, at)?;
    let depth = depth.and_then(|found| levels(&found, &cell.locus));
    let mask = promise_mask(audit.paper, finding, at)?;
    let drawing = witness(mask.as_slice(), &Exceeding::of_promise(broken));
    let anchor = anchor(&finding.table.id, at.0, at.1);
    Ok(html! {
        @if depth.is_some() || drawing.is_some() {
            p.remark { "The promise of " a href={ "#" (anchor) } { (cell.locus) } " is broken:" }
        }
        @if let Some(depth) = depth { (depth) }
        @if let Some(drawing) = drawing { (drawing) }
    })
}

/// The place of the first cell whose promise is broken, the cell, and the data.
fn first_broken<'f>(
    finding: &'f TableFinding<'_>,
) -> Option<((usize, usize), &'f CellFinding, &'f Broken)> {
    let rows = finding.cells.iter().enumerate();
    let mut cells = rows.flat_map(|(row, cells)| {
        cells.iter().enumerate().map(move |(column, cell)| ((row, column), cell))
    });
    cells.find_map(|(at, cell)| match &cell.kept {
        Some(Kept::No(broken)) => Some((at, cell, &**broken)),
        _ => None,
    })
}
