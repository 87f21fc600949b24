//! `subcert errata`.

use super::arguments::{ErrataArguments, ErrataFormat};
use super::output::{Failure, Outcome, json_text, write_results};
use super::papers::{judge_all, papers, select};
use super::terminal;
use std::path::Path;
use subcert::audit::PaperAudit;
use subcert::report::{errata_sheet, json::ErrataReport};

pub(super) fn errata(arguments: &ErrataArguments) -> Outcome {
    let papers = select(papers(&arguments.files)?, arguments.paper.as_deref())?;
    let audits = judge_all(&papers, arguments.format != ErrataFormat::Json)?;
    match &arguments.output_folder {
        None => write_results(&text(arguments.format, &audits, terminal::width())),
        Some(folder) => audits.iter().try_for_each(|audit| save(folder, arguments.format, audit)),
    }
}

/// The errata of papers; those for people in lines of at most `width` characters.
fn text(format: ErrataFormat, audits: &[PaperAudit<'_>], width: Option<usize>) -> String {
    match format {
        ErrataFormat::Text => errata_sheet(audits).to_text(width),
        ErrataFormat::Markdown => errata_sheet(audits).to_markdown(),
        ErrataFormat::Latex => errata_sheet(audits).to_latex_document(),
        ErrataFormat::Json => json_text(&ErrataReport::of(audits)),
    }
}

/// Writes the errata of one paper into the folder, which is made if it is missing.
fn save(folder: &Path, format: ErrataFormat, audit: &PaperAudit<'_>) -> Outcome {
    let text = text(format, std::slice::from_ref(audit), None);
    let (extension, text) = match format {
        ErrataFormat::Text => ("txt", anstream::adapter::strip_str(&text).to_string()),
        ErrataFormat::Markdown => ("md", text),
        ErrataFormat::Json => ("json", text),
        ErrataFormat::Latex => ("tex", text),
    };
    let path = folder.join(format!("{}.{extension}", audit.paper.key));
    let written = std::fs::create_dir_all(folder).and_then(|()| std::fs::write(&path, text));
    written.map_err(|error| Failure::Input(format!("cannot write {}: {error}", path.display())))
}
