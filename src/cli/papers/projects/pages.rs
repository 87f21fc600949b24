//! Pages about constants that programs ship.

use crate::cli::console::output::{Failure, Outcome, write_results};
use crate::cli::papers::pages::{INDEX, write};
use std::path::Path;
use subcert::report::Sheet;
use subcert::report::html::{project_page, projects_page};
use subcert::shipped::ProjectAudit;

/// Writes a page for each project, and an index of them with `more` below it.
pub(super) fn pages(audits: &[ProjectAudit<'_>], more: &Sheet, folder: &Path) -> Outcome {
    if audits.iter().any(|audit| audit.project.key == INDEX) {
        let message =
            "a project of the key `index` would take the place of the index: give it another key";
        return Err(Failure::Input(message.to_owned()));
    }
    for audit in audits {
        write(folder, &audit.project.key, &project_page(audit))?;
    }
    write(folder, INDEX, &projects_page(audits, more))?;
    let count = audits.len();
    let pages = if count == 1 { "page" } else { "pages" };
    let folder = folder.display();
    write_results(&format!("{folder}: {count} {pages}, and index.html, which leads to them\n"))
}
