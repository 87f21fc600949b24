//! `subcert audit` and `subcert explain`.

use super::Outcome;
use super::arguments::{AuditArguments, ExplainArguments, Format};
use super::output::{Failure, show, write};
use super::papers::{judge_all, papers, select};
use subcert::audit::PaperAudit;
use subcert::report::{audit_json, audit_sheet, explain_sheet};

pub(super) fn audit(arguments: &AuditArguments) -> Outcome {
    let papers = select(papers(&arguments.files)?, arguments.paper.as_deref())?;
    let audits = judge_all(&papers)?;
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
            sheet
        },
        || audit_json(&audits),
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
    let papers = papers(&arguments.files)?;
    let audits = judge_all(&papers)?;
    let id = &arguments.id;
    let Some(sheet) = explain_sheet(&audits, id) else {
        let keys: Vec<&str> = papers.iter().map(|paper| paper.key.as_str()).collect();
        return Err(Failure::Input(format!(
            "no claim has the id `{id}`; an id is `KEY:table-1`, `KEY:table-1:ROW:COLUMN`, \
             `KEY:EQUATION` or `KEY:THEOREM`, with KEY one of {}",
            keys.join(", ")
        )));
    };
    match arguments.output.format {
        Format::Text => write(&sheet.to_text()),
        Format::Markdown => write(&sheet.to_markdown()),
        Format::Json => {
            let mut json = audit_json(&audits);
            let claims = json["papers"].as_array_mut().into_iter().flatten();
            let chosen: Vec<serde_json::Value> = claims
                .flat_map(|paper| paper["claims"].as_array().cloned().unwrap_or_default())
                .filter(|claim| {
                    let claim = claim["id"].as_str().unwrap_or_default();
                    claim == id || claim.strip_prefix(id).is_some_and(|rest| rest.starts_with(':'))
                })
                .collect();
            write(&format!("{:#}\n", serde_json::Value::from(chosen)))
        }
    }
}

/// How many claims, of tables how many cells, have this verdict.
fn count(audit: &PaperAudit<'_>, verdict: &str) -> usize {
    audit.claims().iter().filter_map(|claim| claim.verdicts.get(verdict)).sum()
}
