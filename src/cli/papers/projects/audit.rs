//! `subcert audit` of constants that programs ship.

use super::{certified, judge_projects, pages, select_project};
use crate::cli::arguments::{AuditArguments, FindingFormat};
use crate::cli::console::answer::{Answer, show};
use crate::cli::console::output::{Failure, none_denied};
use crate::cli::console::quantity::written;
use crate::cli::papers::audit_output::Destination;
use subcert::audit::Word;
use subcert::report::json::ProjectsReport;
use subcert::report::{Grid, Sheet, projects_sheet};
use subcert::shipped::{Outcome, Project, ProjectAudit};

/// Judges the tables of projects and shows what is found.
pub(in crate::cli) fn audit(
    arguments: &AuditArguments,
    to: Destination<'_>,
    projects: Vec<Project>,
) -> Result<(), Failure> {
    let denied = arguments.deny.iter().map(|word| outcome(*word)).collect::<Result<Vec<_>, _>>()?;
    let projects = select_project(projects, arguments.paper.as_deref())?;
    let audits = judge_projects(&projects, arguments.format != FindingFormat::Json)?;
    let mut certificates = Sheet::default();
    if arguments.certified {
        certified::section(&mut certificates, &audits)?;
    }
    match to {
        Destination::Output(to) => {
            show(&to, &Projects { audits: &audits, all: arguments.all, certificates })?;
        }
        Destination::Pages(folder) => pages::pages(&audits, &certificates, folder)?,
    }
    none_denied(
        &denied,
        |outcome| outcome.word().name(),
        |outcome| {
            let findings = audits.iter().flat_map(|audit| &audit.findings);
            (findings.filter(|finding| finding.has(outcome)).count(), ["table", "tables"])
        },
    )
}

/// The audits of projects.
pub(crate) struct Projects<'a> {
    audits: &'a [ProjectAudit<'a>],
    /// Whether every number is shown.
    all: bool,
    /// What the checker says.
    certificates: Sheet,
}

written!(projects: Projects<'_> => ProjectsReport<'_>, ProjectsReport::of(projects.audits));

impl Answer for Projects<'_> {
    const NAME: &'static str = "audit-project";

    fn sheet(&self) -> Sheet {
        let mut sheet = projects_sheet(self.audits, self.all);
        sheet.text(
            "✓ nearest of its type  ≈ rounded, cut, or off in the last places  ± misprint  ⇄ another table than it is said to be  \
             ✗ wrong, or right to fewer digits than are written  ? not decided. `--all` shows every number, `subcert explain KEY:ID FILE` those of one table, \
             `subcert errata FILE` a text for the project's issue tracker.",
        );
        sheet.blocks.extend(self.certificates.blocks.clone());
        sheet
    }

    /// One row for each number.
    fn grid(&self) -> Option<Grid> {
        let mut rows = Vec::new();
        for project in ProjectsReport::of(self.audits).projects {
            for table in project.tables {
                for number in table.numbers {
                    let at = number.at.iter().map(|(name, value)| format!("{name}={value}"));
                    let at = at.collect::<Vec<String>>().join(" ");
                    let texts = [project.key, table.id, &at, number.shipped, number.verdict];
                    let more = [number.exact, number.nearest, number.error];
                    let texts = texts.into_iter().map(str::to_owned);
                    rows.push(texts.chain(more.map(Option::unwrap_or_default)).collect());
                }
            }
        }
        let header = ["project", "table", "at", "shipped", "verdict", "exact", "nearest", "error"];
        Some(Grid::of(header, rows, 8))
    }
}

/// The outcome that `--deny` names.
fn outcome(word: Word) -> Result<Outcome, Failure> {
    Outcome::ALL.into_iter().find(|outcome| outcome.word() == word).ok_or_else(|| {
        let names: Vec<&str> = Outcome::ALL.iter().map(|outcome| outcome.word().name()).collect();
        Failure::Input(format!(
            "--deny {word}: of constants that programs ship, it takes {}",
            names.join(", ")
        ))
    })
}
