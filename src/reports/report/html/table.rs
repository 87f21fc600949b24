//! A table in its own shape.

use super::broken::broken;
use super::cell::cell;
use super::certified::certified;
use super::command;
use super::context::Context;
use super::math::formula;
use super::picture::{chart, figure as figure_of, readings};
use super::sheet::{SIGN, facts, is_wide, lines};
use super::statement::{definitions, is_long};
use super::typeset::typeset;
use super::verdict::{BROKEN, LOOKS, Look};
use crate::audit::{CellFinding, TableFinding};
use crate::diagnostic::Diagnostic;
use crate::report::papers::audit::remarks;
use crate::report::tables::headers;
use maud::{Markup, html};

/// The section of a table.
///
/// # Errors
/// When a formula of the claim file is wrong.
pub(crate) fn section(
    context: &Context<'_, '_>,
    finding: &TableFinding<'_>,
) -> Result<Markup, Diagnostic> {
    let table = finding.table;
    let broken = broken(context, finding)?;
    Ok(html! {
        section.claim id=(table.id) aria-labelledby={ "page:title-" (table.id) } {
            h3 id={ "page:title-" (table.id) } {
                a href={ "#" (table.id) } { (typeset(&table.locus)) } " " span.title { (typeset(&table.title)) }
            }
            (facts(&headers::schemes(table).into_iter().collect::<Vec<_>>()))
            dl.formulas {
                div.wide[is_long(&table.value)] { dt { "said to equal" } dd { (formula(&table.value.expr)) } }
                (definitions(context.audit, &table.value))
            }
            (grid(context, finding))
            (tally(finding))
            @if let Some(chart) = chart(finding) { (chart) }
            @for search in finding.searches() {
                @if let Some(maps) = readings(finding, search) { (maps) }
            }
            @for line in remarks(finding) { p.remark { (lines(&line)) } }
            (broken)
            @for figure in table.figures.iter().filter_map(|figure| figure_of(finding, figure)) { (figure) }
            @if let Some(note) = &table.note { p.note { (lines(note)) } }
            (certified(context, &table.id))
            (command::explain(context, &table.id))
        }
    })
}

fn grid(context: &Context<'_, '_>, finding: &TableFinding<'_>) -> Markup {
    let table = finding.table;
    let name = format!("{}: {}", table.locus, table.title);
    let header = table.columns.entries.iter().map(|entry| entry.printed.clone()).collect();
    let texts = |row: &Vec<CellFinding>| {
        row.iter().map(|cell| cell.printed.clone().unwrap_or_default()).collect::<Vec<String>>()
    };
    let rows = finding.cells.iter().map(texts);
    html! {
        div.scroll.wide[is_wide(std::iter::once(header).chain(rows), SIGN)] tabindex="0" role="group" aria-label=(name) {
            table.printed {
                thead {
                    tr {
                        th scope="col" {
                            @if let Some(rows) = &table.rows { (typeset(&rows.label)) " \\ " }
                            (typeset(&table.columns.label))
                        }
                        @for entry in &table.columns.entries { th scope="col" { (typeset(&entry.printed)) } }
                    }
                }
                tbody {
                    @for (row, cells) in finding.cells.iter().enumerate() {
                        tr {
                            th scope="row" {
                                @if let Some(rows) = &table.rows { (typeset(&rows.entries[row].printed)) }
                            }
                            @for (column, one) in cells.iter().enumerate() {
                                (cell(context, table, (row, column), one))
                            }
                        }
                    }
                }
            }
        }
    }
}

/// How many cells have which verdict.
fn tally(finding: &TableFinding<'_>) -> Markup {
    let count = |look: &Look| {
        finding.claiming().filter(|cell| Look::of(cell.verdict.word()).class == look.class).count()
    };
    let broken = finding.promise_counts().broken;
    html! {
        ul.tally {
            @for look in &LOOKS {
                @let count = count(look);
                @if count > 0 {
                    li { span class={ "sign " (look.class) } aria-hidden="true" { (look.sign()) } " " (count) " " (look.says) }
                }
            }
            @if broken > 0 {
                li { span class={ "sign " (BROKEN) } aria-hidden="true" { "⚑" } " " (broken) " promises broken" }
            }
        }
    }
}
