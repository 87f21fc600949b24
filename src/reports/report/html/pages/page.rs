//! The page of a paper.

use crate::audit::PaperAudit;
use crate::claim::Kind;
use crate::diagnostic::Diagnostic;
use crate::report::html::claims;
use crate::report::html::context::Context;
use crate::report::html::document::document;
use crate::report::html::filter::buttons;
use crate::report::html::regularity as regularity_table;
use crate::report::html::sheet::{blocks, counts};
use crate::report::html::typeset::typeset;
use crate::report::html::verdict::{LOOKS, Look};
use crate::report::json::Certificate;
use crate::report::papers::consistency;
use crate::report::papers::headline::headline;
use crate::report::papers::overview::overview_sheet;
use crate::report::papers::summary;
use crate::report::smooth::regularity;
use crate::report::told::told;
use crate::report::words::sheet::{Block, Sheet};
use maud::{Markup, html};
use std::collections::BTreeMap;

/// The page of a paper, in one file that loads nothing: what its claims come to, its tables in their
/// own shape, its other claims, and for each the command that shows it again.
///
/// Every claim has the anchor of its id, and every cell that of its table, row and column, as in
/// `#table-1:2:3`. `file` is the claim file of a paper that is not embedded; it stands in the commands.
/// `checked` says by the id of a claim what a checker has found of its certificate.
///
/// ```
/// use subcert::audit::audit;
/// use subcert::claim::embedded_papers;
/// use subcert::report::html::audit_page;
///
/// let papers = embedded_papers()?;
/// let page = audit_page(&audit(&papers[1])?, None, None)?;
/// assert!(page.starts_with("<!DOCTYPE html>"));
/// # Ok::<(), subcert::diagnostic::Diagnostic>(())
/// ```
///
/// # Errors
/// When a formula of the claim file is wrong.
pub fn audit_page(
    audit: &PaperAudit<'_>,
    file: Option<&str>,
    checked: Option<&BTreeMap<String, Certificate>>,
) -> Result<String, Diagnostic> {
    let context = Context { checked, ..Context::new(audit, file) };
    let mut sections: BTreeMap<Kind, Vec<Group>> = BTreeMap::new();
    for finding in audit.findings() {
        let section = claims::section(&context, finding)?;
        let heading = told(finding).heading();
        let groups = sections.entry(finding.claim().kind()).or_default();
        match groups.last_mut().filter(|(last, _)| *last == heading) {
            Some((_, sections)) => sections.push(section),
            None => groups.push((heading, vec![section])),
        }
    }
    let paper = audit.paper;
    let bibliography = &paper.bibliography;
    let main = html! {
        header {
            h1 { (typeset(&bibliography.title)) }
            p {
                (bibliography.imprint())
                @if let Some(doi) = &bibliography.doi {
                    " " a href={ "https://doi.org/" (doi) } { "doi:" (doi) }
                }
            }
            @if let Some(note) = &bibliography.note { p.note { (typeset(note)) } }
        }
        main id="page:main" tabindex="-1" {
            div.beside {
                p.headline { strong { (typeset(&headline(audit))) } }
                (contents(audit))
                (buttons(audit))
            }
            @for kind in Kind::ALL {
                @if *kind == Kind::Smoothness {
                    @let tables: Vec<Markup> = regularity::tables(audit).iter().map(regularity_table::section).collect();
                    (list("Tables of smoothness", "regularity", &tables))
                }
                @for ([heading, id], sections) in sections.get(kind).into_iter().flatten() {
                    (list(heading, id, sections))
                }
            }
            section.beside { (blocks(&rest(audit), 0)) h2 { "Counts" } (tallies(audit)) }
            (legend())
        }
    };
    Ok(document(&format!("{} · audit by subcert", bibliography.short()), &main))
}

/// Claims under one heading, with its anchor.
type Group = ([&'static str; 2], Vec<Markup>);

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
fn list(heading: &str, id: &str, sections: &[Markup]) -> Markup {
    html! {
        @if !sections.is_empty() {
            section.kind id={ "page:" (id) } {
                h2 { (heading) }
                @for section in sections { (section) }
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
                            " " a href={ "#" (claim.id) } { (typeset(claim.locus)) }
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
pub(crate) fn legend() -> Markup {
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
