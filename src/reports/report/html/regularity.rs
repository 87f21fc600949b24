//! A table of orders of smoothness and of exponents, in its own shape.

use super::sheet::{SIGN, is_wide, lines};
use super::typeset::typeset;
use super::verdict::{Look, badge};
use crate::audit::SmoothnessFinding;
use crate::report::smooth::regularity::{Regularity, printed};
use maud::{Markup, html};

/// The section of a table; each cell leads to its claim.
pub(super) fn section(regularity: &Regularity<'_, '_>) -> Markup {
    let Regularity { table, cells } = regularity;
    let name = format!("{}: {}", table.locus, table.title);
    let header = std::iter::once(&table.label).chain(&table.columns);
    let texts = |row: &Vec<Option<&SmoothnessFinding<'_>>>| {
        row.iter().map(|cell| cell.map_or("·", printed).to_owned()).collect::<Vec<String>>()
    };
    let rows = table.rows.iter().zip(cells);
    let rows = rows.map(|(header, row)| [std::slice::from_ref(header), &texts(row)].concat());
    let wide = is_wide(std::iter::once(header.cloned().collect()).chain(rows), SIGN);
    html! {
        section.claim id=(table.id) aria-labelledby={ "page:title-" (table.id) } {
            h3 id={ "page:title-" (table.id) } {
                a href={ "#" (table.id) } { (typeset(&table.locus)) } " " span.title { (typeset(&table.title)) }
            }
            div.scroll.wide[wide] tabindex="0" role="group" aria-label=(name) {
                table.printed {
                    thead {
                        tr {
                            th scope="col" { (typeset(&table.label)) }
                            @for column in &table.columns { th scope="col" { (typeset(column)) } }
                        }
                    }
                    tbody {
                        @for (header, cells) in table.rows.iter().zip(cells) {
                            tr {
                                th scope="row" { (typeset(header)) }
                                @for finding in cells { (cell(*finding)) }
                            }
                        }
                    }
                }
            }
            @if let Some(note) = &table.note { p.note { (lines(note)) } }
        }
    }
}

fn cell(finding: Option<&SmoothnessFinding<'_>>) -> Markup {
    let Some(finding) = finding else { return html! { td { "·" } } };
    let verdict = finding.verdict.word();
    html! {
        td.cell.(Look::of(verdict).class) {
            a.leads href={ "#" (finding.claim.id) } { (printed(finding)) " " (badge(verdict)) }
        }
    }
}
