//! A table of orders of smoothness and of exponents, in its own shape.

use super::sheet::lines;
use super::verdict::{Look, badge};
use crate::audit::SmoothnessFinding;
use crate::report::smooth::regularity::{Regularity, printed};
use maud::{Markup, html};

/// The section of a table; each cell leads to its claim.
pub(super) fn section(regularity: &Regularity<'_, '_>) -> Markup {
    let Regularity { table, cells } = regularity;
    let name = format!("{}: {}", table.locus, table.title);
    html! {
        section.claim id=(table.id) aria-labelledby={ "page:title-" (table.id) } {
            h3 id={ "page:title-" (table.id) } {
                a href={ "#" (table.id) } { (table.locus) } " " span.title { (table.title) }
            }
            div.scroll tabindex="0" role="group" aria-label=(name) {
                table.printed {
                    thead {
                        tr {
                            th scope="col" { (table.label) }
                            @for column in &table.columns { th scope="col" { (column) } }
                        }
                    }
                    tbody {
                        @for (header, cells) in table.rows.iter().zip(cells) {
                            tr {
                                th scope="row" { (header) }
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
