//! Pages about constants that programs ship.

use crate::report::html::command::quoted;
use crate::report::html::document::document;
use crate::report::html::sheet::{blocks, facts, grid};
use crate::report::html::typeset::typeset;
use crate::report::html::verdict::Look;
use crate::report::shipped::{counts, facts_of, headline, rows, sentence, shown};
use crate::report::words::sheet::Sheet;
use crate::shipped::{Outcome, Project, ProjectAudit, ShippedFinding};
use maud::{Markup, html};

/// The page of a project, in one file that loads nothing: what is found, then table by table, each with all of its
/// numbers, and the command that shows them again. A table has the anchor of its id.
#[must_use]
pub fn project_page(audit: &ProjectAudit<'_>) -> String {
    let Project { name, note, .. } = audit.project;
    let main = html! {
        header {
            h1 { "Constants in " (name) }
            (source(audit.project))
            @if let Some(note) = note { p.note { (typeset(note)) } }
        }
        main id="page:main" tabindex="-1" {
            section {
                p.headline { strong { (typeset(&sentence(audit))) } }
                (grid(&counts(std::slice::from_ref(audit))))
            }
            @for finding in &audit.findings { (table(audit.project, finding)) }
            (legend())
        }
    };
    document(&format!("{name} · audit by subcert"), &main)
}

/// The index over the pages of projects, `KEY.html` beside it; `more` stands below, such as what the checker says of
/// certificates.
#[must_use]
pub fn projects_page(audits: &[ProjectAudit<'_>], more: &Sheet) -> String {
    let main = html! {
        header {
            h1 { "Audits of constants that programs ship" }
            p { "Tables in the source of programs, against their exact values. Each project has a page with its tables, number by number." }
        }
        main id="page:main" tabindex="-1" {
            ul.papers {
                @for audit in audits {
                    li id=(audit.project.key) {
                        h2 { a href={ (audit.project.key) ".html" } { (audit.project.name) } }
                        (source(audit.project))
                        p { (typeset(&sentence(audit))) }
                    }
                }
            }
            h2 { "Counts" }
            (grid(&counts(audits)))
            (blocks(more, 1))
            (legend())
        }
    };
    document("Audits by subcert", &main)
}

/// Where the source of a project is.
fn source(project: &Project) -> Markup {
    html! {
        p.title {
            @for (i, word) in project.source_words().iter().enumerate() {
                @if i > 0 { ", " }
                @if word.starts_with("https://") { a href=(word) { (word) } } @else { (word) }
            }
        }
    }
}

fn table(project: &Project, finding: &ShippedFinding<'_>) -> Markup {
    let claim = finding.claim;
    let all: Vec<usize> = (0..finding.cells.len()).collect();
    let some = shown(finding);
    let mut note = Sheet::default();
    note.blocks.extend(claim.note.clone().map(crate::report::words::sheet::Block::Text));
    html! {
        section.claim id=(claim.id) {
            h3 {
                span class={ "sign " (class(finding.outcome)) } { (finding.outcome.word().mark()) } " "
                a href={ "#" (claim.id) } { (claim.locus) } " " span.title { (typeset(&claim.title)) }
            }
            p { (typeset(&headline(finding))) }
            (facts(&facts_of(project, finding)))
            @if !some.is_empty() { (grid(&rows(finding, &some))) }
            @if some.len() < all.len() {
                details { summary { "All numbers" } (grid(&rows(finding, &all))) }
            }
            (blocks(&note, 1))
            p.command {
                "Reproduce: " code { "subcert explain " (project.key) ":" (claim.id) " " (quoted(&project.source.name)) }
            }
        }
    }
}

/// The class of an outcome, which has a colour.
fn class(outcome: Outcome) -> &'static str {
    Look::of(outcome.word()).class
}

/// What the signs mean.
fn legend() -> Markup {
    html! {
        section {
            h2 { "Signs" }
            ul.tally {
                @for outcome in Outcome::ALL {
                    @if outcome != Outcome::Ulps {
                        li {
                            span class={ "sign " (class(outcome)) } aria-hidden="true" { (outcome.word().mark()) } " "
                            (crate::report::shipped::meaning(outcome))
                        }
                    }
                }
            }
        }
    }
}
