//! One finding as a page of its own.

use crate::audit::{Finding, PaperAudit, SmoothnessVerdict, TableFinding};
use crate::claim::Target;
use crate::diagnostic::Diagnostic;
use crate::exact::format::short;
use crate::report::html::broken::of_cell as broken_promise;
use crate::report::html::certified::of_cell as certified_cell;
use crate::report::html::claims;
use crate::report::html::command;
use crate::report::html::context::Context;
use crate::report::html::document::document;
use crate::report::html::picture::digits;
use crate::report::html::regularity as regularity_table;
use crate::report::html::sheet::blocks;
use crate::report::html::typeset::typeset;
use crate::report::papers::explain::{cell_place, explain_sheet};
use crate::report::smooth::regularity;
use crate::report::smooth::regularity::Regularity;
use crate::report::told::{Background, told};
use crate::report::words::sheet::{Block, Sheet};
use maud::{Markup, html};

/// How many digits the exact value of a cell has in the sentence on top.
const DIGITS: u32 = 9;

/// The claim, table or cell of this id (`key:table-1`, `key:table-1:2:3`, `key:theorem-1`) as a page in one file
/// that loads nothing: a sentence, its pictures, all that [`explain_sheet`] says, and the lines of its certificate.
/// `None` where there is none. `file` is the claim file of a paper that is not embedded.
///
/// ```
/// use subcert::audit::audit;
/// use subcert::claim::embedded_papers;
/// use subcert::report::Background;
/// use subcert::report::html::explain_page;
///
/// let papers = embedded_papers()?;
/// let audit = audit(&papers[2])?;
/// let page = explain_page(&audit, "khan2019-newton:table-1:2:1", Background::default(), false, None)?;
/// assert!(page.is_some_and(|page| page.contains("0.023863")));
/// # Ok::<(), subcert::diagnostic::Diagnostic>(())
/// ```
///
/// # Errors
/// When a formula of the claim file is wrong.
pub fn explain_page(
    audit: &PaperAudit<'_>,
    id: &str,
    background: Background<'_>,
    all: bool,
    file: Option<&str>,
) -> Result<Option<String>, Diagnostic> {
    let audits = std::slice::from_ref(audit);
    let Some(sheet) = explain_sheet(audits, id, background, all) else { return Ok(None) };
    let context = Context { is_whole: true, ..Context::new(audit, file) };
    let Some(FindingSection { sentence, contents, grid }) = shown(&context, id)? else {
        return Ok(None);
    };
    let (title, rest) = parts(sheet, grid);
    let bibliography = &audit.paper.bibliography;
    let main = html! {
        header {
            h1 { (typeset(&title)) }
            p {
                (bibliography.short()) ", " (typeset(&bibliography.title)) "."
                @if let Some(doi) = &bibliography.doi {
                    " " a href={ "https://doi.org/" (doi) } { "doi:" (doi) }
                }
            }
        }
        main id="page:main" tabindex="-1" {
            p.headline { strong { (typeset(&sentence)) } }
            (contents)
            @if !rest.blocks.is_empty() {
                section.beside { h2 { "In full" } (blocks(&rest, 1)) }
            }
        }
    };
    Ok(Some(document(&format!("{title} · subcert"), &main)))
}

/// The heading of a sheet, and what stands below it; without the first grid, where this is shown already.
fn parts(sheet: Sheet, mut grid: bool) -> (String, Sheet) {
    let mut title = String::new();
    let mut rest = Sheet::default();
    for block in sheet.blocks {
        match block {
            Block::Heading(1, text) if title.is_empty() => title = text,
            Block::Grid(_) if grid => grid = false,
            block => rest.blocks.push(block),
        }
    }
    (title, rest)
}

/// What a finding shows beyond its sheet.
struct FindingSection {
    sentence: String,
    contents: Markup,
    /// Whether the first grid of the sheet is among it.
    grid: bool,
}

fn shown(context: &Context<'_, '_>, id: &str) -> Result<Option<FindingSection>, Diagnostic> {
    let audit = context.audit;
    let target = Target::of(id);
    let Some(finding) = audit.find(target) else {
        return Ok(regularity::table_of(audit, target).map(|found| of_regularity(&found)));
    };
    if let (Finding::Table(finding), Some(_)) = (finding, target.part) {
        return of_cell(context, finding, target);
    }
    let contents = claims::section(context, finding)?;
    let outcome = told(finding).outcome();
    if matches!(finding, Finding::Table(_)) {
        return Ok(Some(FindingSection { sentence: outcome, contents, grid: true }));
    }
    let first = outcome.lines().next().unwrap_or_default();
    let sentence = format!("{}: {first}", finding.claim().locus());
    Ok(Some(FindingSection { sentence, contents, grid: false }))
}

fn of_regularity(found: &Regularity<'_, '_>) -> FindingSection {
    let cells = || found.cells.iter().flatten().flatten();
    let sentence = format!(
        "{} of the {} statements of {} are confirmed.",
        cells().filter(|one| one.verdict == SmoothnessVerdict::Confirmed).count(),
        cells().count(),
        found.table.locus
    );
    FindingSection { sentence, contents: regularity_table::section(found), grid: true }
}

fn of_cell(
    context: &Context<'_, '_>,
    finding: &TableFinding<'_>,
    target: Target<'_>,
) -> Result<Option<FindingSection>, Diagnostic> {
    let id = target.to_string();
    let at = cell_place(finding.table, target);
    let Some(cell) = finding.cells.iter().flatten().find(|cell| cell.id == id) else {
        return Ok(None);
    };
    let printed = cell.printed.as_deref().unwrap_or("nothing that is left");
    let exact = cell.exact.as_ref().map(|exact| format!(", exactly {}", short(exact, DIGITS)));
    let verdict = cell.verdict.word();
    let sentence = format!("Printed {printed}{}: {verdict}.", exact.unwrap_or_default());
    let pictures = at.map(|at| broken_promise(context, finding, at)).transpose()?;
    let contents = html! {
        div.beside {
            @if let Some(digits) = digits(cell) { (digits) }
            @for picture in pictures.iter().flatten() { (picture) }
            @if let Some(at) = at { (certified_cell(context, &finding.table.id, at)) }
            (command::explain(context, &target.within()))
        }
    };
    Ok(Some(FindingSection { sentence, contents, grid: false }))
}
