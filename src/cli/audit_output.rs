//! Where the answers of `subcert audit` go, of papers and of programs.

use super::arguments::{AuditArguments, Output};
use super::finding::no_page;
use super::output::Failure;
use super::pages::folder;
use std::path::Path;

/// Where an audit goes.
pub(super) enum Destination<'a> {
    /// A text.
    Output(Output),
    /// Into this folder.
    Pages(&'a Path),
}

impl Destination<'_> {
    pub(super) fn of(arguments: &AuditArguments) -> Result<Destination<'_>, Failure> {
        match arguments.format.of_text(arguments.file.as_ref()) {
            None => Ok(Destination::Pages(folder(arguments.file.as_deref())?)),
            Some(to) => Ok(Destination::Output(no_page(to)?)),
        }
    }
}
