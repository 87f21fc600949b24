//! `subcert errata`.

use super::arguments::{ErrataArguments, Format};
use super::output::{Failure, Outcome, json_text, show};
use super::papers::{judge_all, papers, select};
use std::path::Path;
use subcert::audit::PaperAudit;
use subcert::report::{errata_sheet, json::ErrataReport};

pub(super) fn errata(arguments: &ErrataArguments) -> Outcome {
    let papers = select(papers(&arguments.files)?, arguments.paper.as_deref())?;
    let audits = judge_all(&papers, arguments.format != Format::Json)?;
    match &arguments.output_folder {
        None => show(arguments.format, || errata_sheet(&audits), || ErrataReport::of(&audits)),
        Some(folder) => audits.iter().try_for_each(|audit| save(folder, arguments.format, audit)),
    }
}

/// Writes the errata of one paper into the folder, which is made if it is missing.
fn save(folder: &Path, format: Format, audit: &PaperAudit<'_>) -> Outcome {
    let audits = std::slice::from_ref(audit);
    let (extension, text) = match format {
        Format::Text => {
            ("txt", anstream::adapter::strip_str(&errata_sheet(audits).to_text(None)).to_string())
        }
        Format::Markdown => ("md", errata_sheet(audits).to_markdown()),
        Format::Json => ("json", json_text(&ErrataReport::of(audits))),
    };
    let path = folder.join(format!("{}.{extension}", audit.paper.key));
    let written = std::fs::create_dir_all(folder).and_then(|()| std::fs::write(&path, text));
    written.map_err(|error| Failure::Input(format!("cannot write {}: {error}", path.display())))
}
