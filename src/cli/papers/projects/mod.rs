//! The commands about claim files, where these are about constants that programs ship.

mod audit;
mod certified;
mod explain;
mod pages;

pub(super) use audit::audit;
pub(super) use explain::explain;
#[cfg(feature = "schema")]
pub(in crate::cli) use {audit::Projects, explain::Shipped};

use super::judged::chosen;
use crate::cli::console::output::Failure;
use crate::cli::console::progress::Progress;
use subcert::shipped::{Project, ProjectAudit, audit_projects};

/// The project of this key; without a key, all of them.
pub(super) fn select_project(
    projects: Vec<Project>,
    key: Option<&str>,
) -> Result<Vec<Project>, Failure> {
    chosen(projects, |project| &project.key, key)
}

/// Judges every table of the projects. With `bar`, a bar shows the progress.
pub(super) fn judge_projects(
    projects: &[Project],
    bar: bool,
) -> Result<Vec<ProjectAudit<'_>>, Failure> {
    let tables = projects.iter().map(|project| project.shipped.len()).sum();
    let progress = Progress::of_tables(tables, bar);
    Ok(audit_projects(projects, &|| progress.step())?)
}
