//! `subcert audit`.

use super::arguments::{AuditArguments, BROKEN, TableFormat};
use super::certified::Certified;
use super::output::{Outcome, denied, show_table};
use super::papers::{judge_all, papers, select};
use super::{csv, terminal};
use subcert::audit::PaperAudit;
use subcert::report::json::AuditReport;
use subcert::report::{Sheet, audit_sheet, overview_sheet};

pub(super) fn audit(arguments: &AuditArguments) -> Outcome {
    let papers = select(papers(&arguments.files)?, arguments.paper.as_deref())?;
    let audits = judge_all(&papers, arguments.output.format != TableFormat::Json)?;
    let certified = if arguments.certified { Some(Certified::of(&audits)?) } else { None };
    show_table(
        arguments.output.format,
        || {
            let mut sheet = audit_sheet(&audits, arguments.all);
            sheet.text(
                "✓ confirmed  = reproduced at values that the paper does not state  ≈ rounded otherwise  ± misprint  ⇄ another reading  ✗ refuted  ? not checkable, or \
                 open. Under a cell: the exact value of the printed definition, and the sound \
                 value where the printed one is not shown to keep its promise. `--all` shows \
                 every table, `subcert explain KEY:ID` one claim, whose ID ends its heading.",
            );
            if let Some(certified) = &certified {
                certified.section(&mut sheet);
            }
            if arguments.output.format == TableFormat::Text && is_longer_than_a_screen(&sheet) {
                // The summary has scrolled off the screen, and is repeated at the end.
                sheet.heading(1, "All papers");
                sheet.blocks.extend(overview_sheet(&audits).blocks);
            }
            sheet
        },
        || {
            let mut report = AuditReport::of(&audits);
            if let Some(certified) = &certified {
                certified.mark(&mut report);
            }
            report
        },
        || csv::cells(&audits),
    )?;
    denied(&arguments.deny, |verdict| {
        let count = audits.iter().map(|audit| count(audit, verdict)).sum();
        (count, if verdict == BROKEN { ["promise", "promises"] } else { ["claim", "claims"] })
    })
}

fn is_longer_than_a_screen(sheet: &Sheet) -> bool {
    sheet.to_text(terminal::width()).lines().count() > terminal::height()
}

/// How many claims, or cells of tables, have this verdict; for [`BROKEN`], how many promises are
/// broken.
fn count(audit: &PaperAudit<'_>, verdict: &str) -> usize {
    if verdict == BROKEN {
        return audit.promise_counts().broken;
    }
    audit.claims().iter().filter_map(|claim| claim.verdicts.get(verdict)).sum()
}
