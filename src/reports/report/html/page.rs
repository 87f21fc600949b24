//! The page of a paper.

use super::claims;
use super::context::Context;
use super::document::document;
use super::filter::buttons;
use super::regularity as regularity_table;
use super::sheet::{blocks, counts};
use super::table;
use super::verdict::{LOOKS, Look};
use crate::audit::PaperAudit;
use crate::diagnostic::Diagnostic;
use crate::report::headline::headline;
use crate::report::overview::overview_sheet;
use crate::report::sheet::{Block, Sheet};
use crate::report::{consistency, regularity, summary};
use maud::{Markup, html};

/// The page of a paper, in one file that loads nothing: what its claims come to, its tables in their
/// own shape, its other claims, and for each the command that shows it again.
///
/// Every claim has the anchor of its id, and every cell that of its table, row and column, as in
/// `#table-1:2:3`. `file` is the claim file of a paper that is not embedded; it stands in the commands.
///
/// ```
/// use subcert::audit::audit;
/// use subcert::claim::embedded_papers;
/// use subcert::report::html::audit_page;
///
/// let papers = embedded_papers()?;
/// let page = audit_page(&audit(&papers[1])?, None)?;
/// assert!(page.starts_with("<!DOCTYPE html>"));
/// # Ok::<(), subcert::diagnostic::Diagnostic>(())
/// ```
///
/// # Errors
/// When a formula of the claim file is wrong.
pub fn audit_page(audit: &PaperAudit<'_>, file: Option<&str>) -> Result<String, Diagnostic> {
    let context = Context::new(audit, file);
    let tables = audit.tables.iter().map(|one| table::section(&context, one));
    let tables = tables.collect::<Result<Vec<Markup>, Diagnostic>>()?;
    let theorems = audit.theorems.iter().map(|one| claims::theorem(&context, one));
    let theorems = theorems.collect::<Result<Vec<Markup>, Diagnostic>>()?;
    let paper = audit.paper;
    let bibliography = &paper.bibliography;
    let main = html! {
        header {
            h1 { (bibliography.title) }
            p {
                (bibliography.imprint())
                @if let Some(doi) = &bibliography.doi {
                    " " a href={ "https://doi.org/" (doi) } { "doi:" (doi) }
                }
            }
            @if let Some(note) = &bibliography.note { p.note { (note) } }
        }
        main id="page:main" tabindex="-1" {
            p.headline { strong { (headline(audit)) } }
            (contents(audit))
            (buttons(audit))
            (list("Tables", "tables", &tables, Markup::clone))
            (list("Equations", "equations", &audit.equations, |one| claims::equation(&context, one)))
            (list("Functions of a parameter", "functions", &audit.functions, |one| claims::function(&context, one)))
            (list("Parameter ranges", "ranges", &audit.ranges, |one| claims::range(&context, one)))
            (list("Tables of smoothness", "regularity", &regularity::tables(audit), regularity_table::section))
            (list("Smoothness", "smoothness", &audit.smoothness, |one| claims::smoothness(&context, one)))
            (list("Theorems", "theorems", &theorems, Markup::clone))
            section.overview { (blocks(&rest(audit), 0)) h2 { "Counts" } (tallies(audit)) }
            (legend())
        }
    };
    Ok(document(&format!("{} · audit by subcert", bibliography.short()), &main))
}

/// How many claims have each verdict.
fn tallies(audit: &PaperAudit<'_>) -> Markup {
    let sheet = overview_sheet(std::slice::from_ref(audit));
    html! {
        @for block in &sheet.blocks {
            @if let Block::Grid(grid) = block { (counts(grid)) }
        }
    }
}

/// The claims of a kind.
fn list<F>(heading: &str, id: &str, findings: &[F], one: impl Fn(&F) -> Markup) -> Markup {
    html! {
        @if !findings.is_empty() {
            section.kind id={ "page:" (id) } {
                h2 { (heading) }
                @for finding in findings { (one(finding)) }
            }
        }
    }
}

/// A link to each claim, with the signs of its verdicts.
fn contents(audit: &PaperAudit<'_>) -> Markup {
    html! {
        nav aria-label="Claims" {
            details.contents {
                summary { "Claims" }
                ul {
                    @for claim in audit.claims() {
                        li {
                            @for look in &LOOKS {
                                @if claim.verdicts.iter().any(|(word, _)| Look::of(word).class == look.class) {
                                    span class={ "sign " (look.class) } title=(look.says) { (look.sign()) }
                                }
                            }
                            " " a href={ "#" (claim.id) } { (claim.locus) }
                        }
                    }
                }
            }
        }
    }
}

/// Contradictions between tables, and what the cells amount to.
fn rest(audit: &PaperAudit<'_>) -> Sheet {
    let mut sheet = Sheet::default();
    consistency::section(&mut sheet, audit);
    summary::section(&mut sheet, audit);
    sheet
}

/// What the signs mean.
pub(super) fn legend() -> Markup {
    html! {
        section {
            h2 { "Signs" }
            ul.tally {
                @for look in &LOOKS {
                    li { span class={ "sign " (look.class) } aria-hidden="true" { (look.sign()) } " " (look.says) }
                }
                li { span.sign.broken aria-hidden="true" { "⚑" } " a printed bound or depth does not keep its promise" }
            }
        }
    }
}
