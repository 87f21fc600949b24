//! The index of the pages of several papers.

use super::page::legend;
use crate::audit::PaperAudit;
use crate::report::html::document::document;
use crate::report::html::sheet::{blocks, grid};
use crate::report::html::typeset::typeset;
use crate::report::papers::headline::headline;
use crate::report::papers::overview::overview_sheet;
use crate::report::words::sheet::{Block, Sheet};
use maud::html;

/// The index over all papers audited: a link to the page of each, `KEY.html` beside it, and what its
/// claims come to; `more` stands below, such as what the checker says of certificates.
#[must_use]
pub fn index_page(audits: &[PaperAudit<'_>], more: &Sheet) -> String {
    let overview = overview_sheet(audits);
    let main = html! {
        header {
            h1 { "Audits of papers about subdivision schemes" }
            p { "Every claim that can be checked, against exact values. Each paper has a page with its tables, cell by cell." }
        }
        main.index id="page:main" tabindex="-1" {
            ul.papers {
                @for audit in audits {
                    li id=(audit.paper.key) {
                        h2 { a href={ (audit.paper.key) ".html" } { (audit.paper.bibliography.short()) } }
                        p.title { (audit.paper.bibliography.title_and_venue()) }
                        p { (typeset(&headline(audit))) }
                    }
                }
            }
            h2 { "Counts" }
            @for block in &overview.blocks {
                @if let Block::Grid(counts) = block { (grid(counts)) }
            }
            (blocks(more, 1))
            (legend())
        }
    };
    document("Audits by subcert", &main)
}
