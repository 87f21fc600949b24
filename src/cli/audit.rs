//! `subcert audit`.

use super::arguments::{AuditArguments, BROKEN};
use super::certified::Certified;
use super::output::{Outcome, denied, show};
use super::papers::{judge_all, papers, select};
use subcert::audit::PaperAudit;
use subcert::report::audit_sheet;
use subcert::report::json::AuditReport;

pub(super) fn audit(arguments: &AuditArguments) -> Outcome {
    let papers = select(papers(&arguments.files)?, arguments.paper.as_deref())?;
    let audits = judge_all(&papers, arguments.output.format)?;
    let certified = if arguments.certified { Some(Certified::of(&audits)?) } else { None };
    show(
        arguments.output.format,
        || {
            let mut sheet = audit_sheet(&audits, arguments.all);
            sheet.text(
                "✓ confirmed  ≈ rounded otherwise  ± misprint  ⇄ another reading  ✗ refuted  ? not checkable, or \
                 open. Under a cell: the exact value of the printed definition, and the sound \
                 value where the printed one is not shown to keep its promise. `--all` shows \
                 every table, `subcert explain KEY:ID` one claim, whose ID ends its heading.",
            );
            if let Some(certified) = &certified {
                certified.section(&mut sheet);
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
    )?;
    denied(&arguments.deny, |verdict| {
        let count = audits.iter().map(|audit| count(audit, verdict)).sum();
        (count, if verdict == BROKEN { ["promise", "promises"] } else { ["claim", "claims"] })
    })
}

/// How many claims, of tables how many cells, have this verdict; how many promises are broken.
fn count(audit: &PaperAudit<'_>, verdict: &str) -> usize {
    if verdict == BROKEN {
        return audit.promise_counts().broken;
    }
    audit.claims().iter().filter_map(|claim| claim.verdicts.get(verdict)).sum()
}
