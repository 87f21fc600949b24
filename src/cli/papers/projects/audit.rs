//! `subcert audit` of constants that programs ship.

use super::{certified, judge_projects, pages, select_project};
use crate::cli::arguments::{AuditArguments, FindingFormat};
use crate::cli::console::csv;
use crate::cli::console::output::{Failure, denied, show_table};
use crate::cli::papers::audit_output::Destination;
use subcert::report::json::ProjectsReport;
use subcert::report::{Sheet, projects_sheet};
use subcert::shipped::{Outcome, Project};

/// Judges the tables of projects and shows what is found.
pub(in crate::cli) fn audit(
    arguments: &AuditArguments,
    to: Destination<'_>,
    projects: Vec<Project>,
) -> Result<(), Failure> {
    let denies = arguments.deny.iter().map(|word| outcome(word)).collect::<Result<Vec<_>, _>>()?;
    let projects = select_project(projects, arguments.paper.as_deref())?;
    let audits = judge_projects(&projects, arguments.format != FindingFormat::Json)?;
    let mut certificates = Sheet::default();
    if arguments.certified {
        certified::section(&mut certificates, &audits)?;
    }
    match to {
        Destination::Output(to) => show_table(
            &to,
            || {
                let mut sheet = projects_sheet(&audits, arguments.all);
                sheet.text(
                    "✓ nearest of its type  ≈ rounded, cut, or off in the last places  ± misprint  ⇄ another table than it is said to be  \
                     ✗ wrong, or right to fewer digits than are written  ? not decided. `--all` shows every number, `subcert explain KEY:ID FILE` those of one table, \
                     `subcert errata FILE` a text for the project's issue tracker.",
                );
                sheet.blocks.extend(certificates.blocks.clone());
                sheet
            },
            || ProjectsReport::of(&audits),
            || csv::shipped(&audits),
        )?,
        Destination::Pages(folder) => pages::pages(&audits, &certificates, folder)?,
    }
    denied(&arguments.deny, |word| {
        let findings = audits.iter().flat_map(|audit| &audit.findings);
        let has = |outcome: &Outcome| outcome.word().name() == word;
        let outcome = denies.iter().copied().find(has);
        let count = findings.filter(|finding| outcome.is_some_and(|one| finding.has(one))).count();
        (count, ["table", "tables"])
    })
}

/// The outcome that `--deny` names.
fn outcome(word: &str) -> Result<Outcome, Failure> {
    Outcome::ALL.into_iter().find(|outcome| outcome.word().name() == word).ok_or_else(|| {
        let names: Vec<&str> = Outcome::ALL.iter().map(|outcome| outcome.word().name()).collect();
        Failure::Input(format!(
            "--deny {word}: of constants that programs ship, it takes {}",
            names.join(", ")
        ))
    })
}
