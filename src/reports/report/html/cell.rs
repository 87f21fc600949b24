//! A cell of a table, and what is known of it.

use super::command;
use super::context::Context;
use super::filter::is_broken;
use super::picture::digits;
use super::sheet::facts;
use super::typeset::typeset;
use super::verdict::{BROKEN, Look, badge};
use crate::audit::CellFinding;
use crate::claim::Table;
use crate::report::papers::audit::below;
use crate::report::papers::explain::cell_facts;
use maud::{Markup, html};

/// The anchor of a cell: the table's id, the row and the column, counted from 1.
pub(super) fn anchor(table: &str, row: usize, column: usize) -> String {
    format!("{table}:{}:{}", row + 1, column + 1)
}

/// The cell at a place of a table; its panel is shown where the address ends with its anchor.
pub(super) fn cell(
    context: &Context<'_, '_>,
    table: &Table,
    (row, column): (usize, usize),
    cell: &CellFinding,
) -> Markup {
    let (table, promised) = (&table.id, table.promise.is_some());
    let anchor = anchor(table, row, column);
    if cell.is_blank() {
        return html! { td.cell id=(anchor) { (cell.shown()) } };
    }
    let look = Look::of(cell.verdict.word());
    let broken = if is_broken(cell) { BROKEN } else { "" };
    let link = format!("#{anchor}");
    html! {
        td.cell.(look.class).(broken) id=(anchor) {
            // First, so that the next stop of the keyboard is in the panel once it is open.
            div.panel role="group" aria-label=(cell.locus) {
                p.head {
                    strong { (typeset(&cell.locus)) }
                    " " a.close href={ "#" (table) } { "close" }
                }
                @if let Some(digits) = digits(cell) { (digits) }
                (facts(&cell_facts(cell)))
                (command::explain(context, &anchor))
            }
            a.open href=(link) {
                (cell.shown()) " " (badge(cell.verdict.word()))
                @if is_broken(cell) {
                    span.flag aria-hidden="true" { "⚑" }
                    span.hidden { ", promise broken" }
                }
                @for line in below(cell, promised) { small.exact { (line) } }
            }
        }
    }
}
