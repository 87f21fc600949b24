//! `subcert errata`.

use super::claim_files::{Claims, claims};
use super::judged::{judge_all, select};
use super::projects::{judge_projects, select_project};
use crate::cli::arguments::{ErrataArguments, ErrataFormat};
use crate::cli::console::csv;
use crate::cli::console::output::{Failure, Outcome, json_text, write_results};
use crate::cli::console::terminal;
use serde::Serialize;
use std::path::Path;
use subcert::report::json::{ErrataReport, ProjectsReport};
use subcert::report::{Sheet, differences_sheet, errata_sheet, issue_sheet};

pub(crate) fn errata(arguments: &ErrataArguments) -> Outcome {
    let bar = arguments.format != ErrataFormat::Json;
    match claims(&arguments.files)? {
        Claims::Papers(papers) => {
            let papers = select(papers, arguments.paper.as_deref())?;
            let audits = judge_all(&papers, bar)?;
            let sheet = if arguments.together { differences_sheet } else { errata_sheet };
            deliver(arguments, &audits, |audit| &audit.paper.key, sheet, ErrataReport::of)
        }
        Claims::Projects(_) if arguments.together => Err(Failure::Input(
            "`--together` is about papers; these files are about programs, whose texts `errata` writes one after another"
                .to_owned(),
        )),
        Claims::Projects(projects) => {
            let projects = select_project(projects, arguments.paper.as_deref())?;
            let audits = judge_projects(&projects, bar)?;
            deliver(arguments, &audits, |audit| &audit.project.key, issue_sheet, ProjectsReport::of)
        }
    }
}

/// Writes the errata of all to the standard output, or those of each into a file of its own, named by its key.
fn deliver<'a, A, J: Serialize>(
    arguments: &ErrataArguments,
    audits: &'a [A],
    key: impl Fn(&A) -> &str,
    sheet: impl Fn(&[A]) -> Sheet,
    json: impl Fn(&'a [A]) -> J,
) -> Outcome {
    let text = |audits: &'a [A], width: Option<usize>| match arguments.format {
        ErrataFormat::Text => sheet(audits).to_text(width),
        ErrataFormat::Markdown => sheet(audits).to_markdown(),
        ErrataFormat::Latex => sheet(audits).to_latex_document(),
        ErrataFormat::Json => json_text(&json(audits)),
        ErrataFormat::Csv => csv::values(&json(audits)),
    };
    let Some(folder) = &arguments.output_folder else {
        return write_results(&text(audits, terminal::width()));
    };
    for audit in audits {
        save(folder, arguments.format, key(audit), text(std::slice::from_ref(audit), None))?;
    }
    Ok(())
}

/// Writes one text into the folder, which is made if it is missing.
fn save(folder: &Path, format: ErrataFormat, key: &str, text: String) -> Outcome {
    let (extension, text) = match format {
        ErrataFormat::Text => ("txt", anstream::adapter::strip_str(&text).to_string()),
        ErrataFormat::Markdown => ("md", text),
        ErrataFormat::Json => ("json", text),
        ErrataFormat::Latex => ("tex", text),
        ErrataFormat::Csv => ("csv", text),
    };
    let path = folder.join(format!("{key}.{extension}"));
    let written = std::fs::create_dir_all(folder).and_then(|()| std::fs::write(&path, text));
    written.map_err(|error| Failure::Input(format!("cannot write {}: {error}", path.display())))
}
