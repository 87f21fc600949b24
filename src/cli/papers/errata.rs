//! `subcert errata`.

use super::claim_files::{Claims, claims};
use super::judged::{judge_all, select};
use super::projects::{judge_projects, select_project};
use crate::cli::arguments::{ErrataArguments, ErrataFormat, Format};
use crate::cli::console::answer::{Answer, text};
use crate::cli::console::output::{Failure, Outcome, write_results};
use crate::cli::console::quantity::written;
use crate::cli::console::terminal;
use std::path::Path;
use subcert::audit::PaperAudit;
use subcert::files::permitted;
use subcert::report::json::{ErrataReport, ProjectsReport};
use subcert::report::{Sheet, differences_sheet, errata_sheet, issue_sheet};
use subcert::shipped::ProjectAudit;

pub(crate) fn errata(arguments: &ErrataArguments) -> Outcome {
    let bar = arguments.format != ErrataFormat::Json;
    match claims(&arguments.files)? {
        Claims::Papers(papers) => {
            let papers = select(papers, arguments.paper.as_deref())?;
            let audits = judge_all(&papers, bar)?;
            let together = arguments.together;
            deliver(arguments, &audits, |audit| &audit.paper.key, |audits| Errata { audits, together })
        }
        Claims::Projects(_) if arguments.together => Err(Failure::Input(
            "`--together` is about papers; these files are about programs, whose texts `errata` writes one after another"
                .to_owned(),
        )),
        Claims::Projects(projects) => {
            let projects = select_project(projects, arguments.paper.as_deref())?;
            let audits = judge_projects(&projects, bar)?;
            deliver(arguments, &audits, |audit| &audit.project.key, Issues)
        }
    }
}

/// The errata of papers.
pub(crate) struct Errata<'a> {
    audits: &'a [PaperAudit<'a>],
    /// Whether differences of all papers stand together.
    together: bool,
}

written!(errata: Errata<'_> => ErrataReport<'_>, ErrataReport::of(errata.audits));

impl Answer for Errata<'_> {
    const NAME: &'static str = "errata";

    fn sheet(&self) -> Sheet {
        if self.together { differences_sheet(self.audits) } else { errata_sheet(self.audits) }
    }
}

/// What to tell the authors of programs.
struct Issues<'a>(&'a [ProjectAudit<'a>]);

written!(issues: Issues<'_> => ProjectsReport<'_>, ProjectsReport::of(issues.0));

impl Answer for Issues<'_> {
    const NAME: &'static str = "audit-project";

    fn sheet(&self) -> Sheet {
        issue_sheet(self.0)
    }
}

/// Writes the errata of all to the standard output, or those of each into a file of its own, named by its key.
fn deliver<'a, A, E: Answer>(
    arguments: &ErrataArguments,
    audits: &'a [A],
    key: impl Fn(&A) -> &str,
    errata: impl Fn(&'a [A]) -> E,
) -> Outcome {
    let format = Format::named(&arguments.format).expect("a format of texts");
    let text = |audits, width| match (errata(audits), format) {
        (errata, Format::Latex) => errata.sheet().to_latex_document(),
        (errata, _) => text(&errata, format, width),
    };
    let folder = arguments.output_folder.as_deref();
    let Some(folder) = folder.filter(|folder| folder.as_os_str() != "-") else {
        return write_results(&text(audits, terminal::width()));
    };
    for audit in audits {
        save(folder, format, key(audit), text(std::slice::from_ref(audit), None))?;
    }
    Ok(())
}

/// Writes one text into the folder, which is made if it is missing.
fn save(folder: &Path, format: Format, key: &str, text: String) -> Outcome {
    let (extension, text) = match format {
        Format::Text => ("txt", anstream::adapter::strip_str(&text).to_string()),
        Format::Markdown => ("md", text),
        Format::Json => ("json", text),
        Format::Latex => ("tex", text),
        Format::Csv => ("csv", text),
    };
    let path = folder.join(format!("{key}.{extension}"));
    let written = permitted(&path)
        .and_then(|()| std::fs::create_dir_all(folder))
        .and_then(|()| std::fs::write(&path, text));
    written.map_err(|error| Failure::Input(format!("cannot write {}: {error}", path.display())))
}
