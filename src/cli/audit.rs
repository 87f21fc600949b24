//! `subcert audit` and `subcert explain`.

use super::arguments::{AuditArguments, ExplainArguments};
use super::certified::Certified;
use super::output::{Failure, Outcome, show};
use super::papers::{judge_all, papers, select};
use subcert::audit::{PaperAudit, readings};
use subcert::claim::Paper;
use subcert::report::json::{AuditReport, Explained};
use subcert::report::{audit_sheet, explain_sheet, table_of};

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
                 every table, `subcert explain ID` one claim.",
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
    for verdict in &arguments.deny {
        let count = audits.iter().map(|audit| count(audit, verdict)).sum::<usize>();
        if count > 0 {
            return Err(Failure::Expectation(format!("{count} claims are {verdict}")));
        }
    }
    Ok(())
}

pub(super) fn explain(arguments: &ExplainArguments) -> Outcome {
    let id = &arguments.id;
    let papers = papers(&arguments.files)?;
    let keys: Vec<String> = papers.iter().map(|paper| paper.key.clone()).collect();
    let key = id.split(':').next().unwrap_or_default();
    let chosen: Vec<Paper> = papers.into_iter().filter(|paper| paper.key == key).collect();
    let audits = judge_all(&chosen, arguments.output.format)?;
    let tried = match (audits.first(), table_of(&audits, id)) {
        (Some(audit), Some((finding, at))) => {
            let kind = at.map(|(row, column)| finding.cells[row][column].kind());
            let kind = kind.or_else(|| finding.kinds().first().copied());
            kind.map_or(Ok(Vec::new()), |kind| readings(audit.paper, finding, kind))?
        }
        _ => Vec::new(),
    };
    let Some(sheet) = explain_sheet(&audits, id, &tried, arguments.all) else {
        return Err(Failure::Input(format!(
            "no claim has the id `{id}`; an id is `KEY:table-1`, `KEY:table-1:ROW:COLUMN`, \
             `KEY:EQUATION` or `KEY:THEOREM`, with KEY one of {}",
            keys.join(", ")
        )));
    };
    show(arguments.output.format, || sheet, || Explained::of(&audits, id, &tried))
}

/// How many claims, of tables how many cells, have this verdict.
fn count(audit: &PaperAudit<'_>, verdict: &str) -> usize {
    audit.claims().iter().filter_map(|claim| claim.verdicts.get(verdict)).sum()
}
