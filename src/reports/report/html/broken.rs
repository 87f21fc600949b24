//! Promises of a table that are not kept, drawn.

use super::cell::anchor;
use super::context::Context;
use super::picture::{Exceeding, levels, witness};
use crate::audit::{Broken, CellFinding, Kept, TableFinding, depth_levels, promise_refiner};
use crate::diagnostic::Diagnostic;
use maud::{Markup, html};

/// The first promise of a table that is not kept, drawn.
///
/// # Errors
/// When a formula of the claim file is wrong.
pub(super) fn broken(
    context: &Context<'_, '_>,
    finding: &TableFinding<'_>,
) -> Result<Markup, Diagnostic> {
    let rows = finding.cells.iter().enumerate();
    let mut places =
        rows.flat_map(|(row, cells)| (0..cells.len()).map(move |column| (row, column)));
    let first = places.find(|(row, column)| promise(&finding.cells[*row][*column]).is_some());
    let Some(at) = first else { return Ok(html! {}) };
    let drawn = of_cell(context, finding, at)?;
    let anchor = anchor(&finding.table.id, at.0, at.1);
    let locus = &finding.cells[at.0][at.1].locus;
    Ok(html! {
        @if !drawn.is_empty() {
            p.remark { "The promise of " a href={ "#" (anchor) } { (locus) } " is broken:" }
        }
        @for drawing in &drawn { (drawing) }
    })
}

/// The broken promise of a cell: of a depth the sound bound against the level, and the data with their limit.
///
/// # Errors
/// When a formula of the claim file is wrong.
pub(super) fn of_cell(
    context: &Context<'_, '_>,
    finding: &TableFinding<'_>,
    at: (usize, usize),
) -> Result<Vec<Markup>, Diagnostic> {
    let (paper, cell) = (context.audit.paper, &finding.cells[at.0][at.1]);
    let Some(broken) = promise(cell) else { return Ok(Vec::new()) };
    let depth = depth_levels(paper, finding, at)?;
    let depth = depth.and_then(|found| levels(&found, &cell.locus));
    let refiner = promise_refiner(paper, finding, at)?;
    let drawing = refiner.and_then(|refiner| witness(&refiner, &Exceeding::of_promise(broken)));
    Ok(depth.into_iter().chain(drawing).collect())
}

/// The data for which a cell does not keep its promise.
fn promise(cell: &CellFinding) -> Option<&Broken> {
    match &cell.kept {
        Some(Kept::No(broken)) => Some(broken),
        _ => None,
    }
}
