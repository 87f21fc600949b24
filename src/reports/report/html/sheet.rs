//! The blocks of a report as HTML.

use super::typeset::typeset;
use crate::diagnostic::wrap::width_of;
use crate::report::words::sheet::{Block, Grid, Sheet};
use maud::{Markup, html};

/// The longest value that is shown whole; a longer one can be unfolded.
const MAX_PLAIN: usize = 400;

/// The longest value that a page holds; the command below it shows the whole.
const MAX_HELD: usize = 4_000;

/// The blocks of a sheet; its headings are `deeper` levels deeper.
pub(super) fn blocks(sheet: &Sheet, deeper: u8) -> Markup {
    html! { @for block in &sheet.blocks { (one(block, deeper)) } }
}

fn one(block: &Block, deeper: u8) -> Markup {
    match block {
        Block::Heading(level, text) => match level + deeper {
            0..=2 => html! { h2 { (typeset(text)) } },
            3 => html! { h3 { (typeset(text)) } },
            _ => html! { h4 { (typeset(text)) } },
        },
        Block::Text(text) => html! { p { (lines(text)) } },
        Block::Facts(list) => facts(list),
        Block::Grid(grid) => self::grid(grid),
    }
}

/// Names with values.
pub(crate) fn facts(list: &[(String, String)]) -> Markup {
    html! {
        @if !list.is_empty() {
            dl {
                @for (name, value) in list {
                    div { dt { (lines(name)) } dd { (value_of(value)) } }
                }
            }
        }
    }
}

/// A value; a long one behind its beginning.
fn value_of(value: &str) -> Markup {
    let length = value.chars().count();
    if length <= MAX_PLAIN {
        return lines(value);
    }
    let part = |most: usize| value.chars().take(most).collect::<String>();
    html! {
        details.long {
            summary { (part(80)) "… (" (length) " characters)" }
            (lines(&part(MAX_HELD)))
            @if length > MAX_HELD { "… (the command below shows the rest)" }
        }
    }
}

/// A text with its line breaks.
pub(crate) fn lines(text: &str) -> Markup {
    html! {
        @for (place, line) in text.split('\n').enumerate() {
            @if place > 0 { br; }
            (typeset(line))
        }
    }
}

/// The characters that stand beside another column.
const HALF: usize = 56;

/// A longer text of a cell is broken into lines.
const LINE: usize = 24;

/// The characters of a sign with the space before it.
pub(super) const SIGN: usize = 3;

/// Whether a table with these rows needs the whole page; its cells have `more` characters each.
pub(super) fn is_wide(rows: impl Iterator<Item = Vec<String>>, more: usize) -> bool {
    let width = |cell: &String| {
        let longest = cell.split_whitespace().map(width_of).max().unwrap_or(0);
        let line = cell.lines().map(width_of).max().unwrap_or(0);
        longest.max(line.min(LINE)) + more + 2
    };
    let mut columns = Vec::new();
    for row in rows {
        columns.resize(columns.len().max(row.len()), 0);
        columns.iter_mut().zip(&row).for_each(|(column, cell)| *column = width(cell).max(*column));
    }
    columns.iter().sum::<usize>() > HALF
}

/// A table of texts.
pub(super) fn grid(grid: &Grid) -> Markup {
    let wide = is_wide(std::iter::once(grid.header.clone()).chain(grid.rows.iter().cloned()), 0);
    html! {
        div.scroll.wide[wide] tabindex="0" role="group" aria-label="table" {
            table {
                thead { tr { @for header in &grid.header { th scope="col" { (lines(header)) } } } }
                tbody {
                    @for row in &grid.rows {
                        tr {
                            @for (place, cell) in row.iter().enumerate() {
                                @if place == 0 {
                                    th scope="row" { (lines(cell)) }
                                } @else if place < grid.left_columns {
                                    td { (lines(cell)) }
                                } @else {
                                    td.number { (lines(cell)) }
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}

/// The counts of one paper: a table of one row as boxes, which wrap.
pub(super) fn counts(grid: &Grid) -> Markup {
    let boxes = |row: &Vec<String>| -> Vec<(String, String)> {
        grid.header.iter().cloned().zip(row.iter().cloned()).skip(1).collect()
    };
    html! {
        @for row in &grid.rows {
            dl.counts {
                @for (name, value) in boxes(row) { div { dt { (lines(&name)) } dd { (value) } } }
            }
        }
    }
}
