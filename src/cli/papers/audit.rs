//! `subcert audit`.

use super::audit_output::Destination;
use super::certified::Certified;
use super::claim_files::{Claims, claims};
use super::judged::{judge_all, select};
use super::pages;
use super::projects;
use crate::cli::arguments::{AuditArguments, FindingFormat, Format, Output, is_of_papers};
use crate::cli::console::csv;
use crate::cli::console::output::{Failure, Outcome, denied, show_table};
use crate::cli::console::terminal;
use subcert::audit::{PaperAudit, Word};
use subcert::report::json::AuditReport;
use subcert::report::{Sheet, audit_sheet, overview_sheet};

pub(crate) fn audit(arguments: &AuditArguments) -> Outcome {
    let to = Destination::of(arguments)?;
    let papers = match claims(&arguments.files)? {
        Claims::Papers(papers) => select(papers, arguments.paper.as_deref())?,
        Claims::Projects(projects) => return projects::audit(arguments, to, projects),
    };
    if let Some(word) = arguments.deny.iter().find(|word| !is_of_papers(word)) {
        let message = format!("--deny {word}: this is said only of constants that programs ship");
        return Err(Failure::Input(message));
    }
    let audits = judge_all(&papers, arguments.format != FindingFormat::Json)?;
    let certified = if arguments.certified { Some(Certified::of(&audits)?) } else { None };
    match to {
        Destination::Output(to) => show_audit(arguments, &to, &audits, certified.as_ref())?,
        Destination::Pages(folder) => {
            pages::pages(&audits, certified.as_ref(), arguments.files.is_empty(), folder)?;
        }
    }
    denied(&arguments.deny, |verdict| {
        let count = audits.iter().map(|audit| count(audit, verdict)).sum();
        (
            count,
            if verdict == Word::Broken.name() {
                ["promise", "promises"]
            } else {
                ["claim", "claims"]
            },
        )
    })
}

/// Writes the report.
fn show_audit(
    arguments: &AuditArguments,
    to: &Output,
    audits: &[PaperAudit<'_>],
    certified: Option<&Certified>,
) -> Outcome {
    show_table(
        to,
        || {
            let mut sheet = audit_sheet(audits, arguments.all);
            sheet.text(
                "✓ confirmed  = reproduced at values that the paper does not state  ≈ rounded differently  ± misprint  ⇄ another reading  ✗ refuted  ? not checkable, or \
                 open. Under a cell: the exact value of the printed definition, and the sound \
                 value where the printed one is not shown to keep its promise. `--all` shows \
                 every table, `subcert explain KEY:ID` one claim, whose ID ends its heading.",
            );
            if let Some(certified) = certified {
                certified.section(&mut sheet);
            }
            if to.format == Format::Text && to.file.is_none() && is_longer_than_a_screen(&sheet) {
                // The summary has scrolled off the screen, and is repeated at the end.
                sheet.heading(1, "All papers");
                sheet.blocks.extend(overview_sheet(audits).blocks);
            }
            sheet
        },
        || {
            let mut report = AuditReport::of(audits);
            if let Some(certified) = certified {
                certified.mark(&mut report);
            }
            report
        },
        || csv::cells(audits),
    )
}

fn is_longer_than_a_screen(sheet: &Sheet) -> bool {
    sheet.to_text(terminal::width()).lines().count() > terminal::height()
}

/// How many claims, or cells of tables, have this verdict; for [`Word::Broken`], how many promises are
/// broken.
fn count(audit: &PaperAudit<'_>, verdict: &str) -> usize {
    if verdict == Word::Broken.name() {
        return audit.promise_counts().broken;
    }
    let claims = audit.claims();
    let verdicts = claims.iter().flat_map(|claim| claim.verdicts.iter());
    verdicts.filter(|(word, _)| word.name() == verdict).map(|(_, count)| count).sum()
}
