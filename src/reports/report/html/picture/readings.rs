//! Cells explained against readings: a small map of the table for each of them.

use crate::audit::{CellFinding, Search, TableFinding, Verdict};
use crate::report::html::picture::plane::frame::WIDTH;
use maud::{Markup, html};

/// The most readings that are drawn.
const MAX_MAPS: usize = 4;

/// The side of a cell.
const SIDE: usize = 12;

/// The table as printed, and by each of the best readings: a filled square is a cell that is explained.
pub(crate) fn readings(finding: &TableFinding<'_>, search: &Search) -> Option<Markup> {
    search.best.first()?;
    let printed: Vec<Vec<bool>> =
        finding.cells.iter().map(|row| row.iter().map(is_confirmed).collect()).collect();
    let confirmed = printed.iter().flatten().filter(|is| **is).count();
    // Of other searches it is not known which cells these are.
    let as_printed =
        (confirmed == search.as_printed).then_some(("as printed".to_owned(), confirmed, printed));
    let named = search.best.iter().take(MAX_MAPS).map(|reading| {
        let name = reading.differs();
        let name = if name.is_empty() { "as printed".to_owned() } else { name };
        (name, reading.count(), reading.explained.clone())
    });
    let maps: Vec<(String, usize, Vec<Vec<bool>>)> = as_printed.into_iter().chain(named).collect();
    Some(html! {
        figure.maps {
            @for (name, count, explained) in &maps {
                div.map {
                    (map(finding, name, *count, explained))
                    p { (count) " of " (search.cells) ": " (name) }
                }
            }
            figcaption { "Cells that are explained, by readings: filled squares are." }
        }
    })
}

fn is_confirmed(cell: &CellFinding) -> bool {
    cell.verdict == Verdict::Confirmed
}

fn map(finding: &TableFinding<'_>, name: &str, count: usize, explained: &[Vec<bool>]) -> Markup {
    let (rows, columns) = (explained.len(), explained.iter().map(Vec::len).max().unwrap_or(0));
    let (width, height) = (columns * SIDE, rows * SIDE);
    // A wide table shrinks.
    let most = WIDTH / 2.0;
    html! {
        svg viewBox={ "0 0 " (width) " " (height) } width=(width) height=(height) style={ "max-width:" (most) "px" } role="img" {
            title { (finding.table.locus) ", " (name) }
            desc { (count) " cells are explained." }
            @for (row, cells) in explained.iter().enumerate() {
                @for (column, is) in cells.iter().enumerate() {
                    rect class=(if *is { "yes" } else { "no" }) x=(column * SIDE + 1) y=(row * SIDE + 1) width=(SIDE - 2) height=(SIDE - 2) {}
                }
            }
        }
    }
}
