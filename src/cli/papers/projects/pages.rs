//! Pages about constants that programs ship.

use crate::cli::console::output::Outcome;
use crate::cli::papers::pages::{tell, write_all};
use std::path::Path;
use subcert::report::Sheet;
use subcert::report::html::{project_page, projects_page};
use subcert::shipped::ProjectAudit;

/// Writes a page for each project, and an index of them with `more` below it.
pub(super) fn pages(audits: &[ProjectAudit<'_>], more: &Sheet, folder: &Path) -> Outcome {
    let (page, index) = (|audit: &_| Ok(project_page(audit)), projects_page(audits, more));
    write_all("project", audits, |audit| &audit.project.key, page, &index, folder)?;
    tell(folder, audits.len(), "")
}
