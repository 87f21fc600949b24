//! Where the answers of `subcert audit` go, of papers and of programs.

use super::pages::folder;
use crate::cli::arguments::{AuditArguments, Output};
use crate::cli::console::destination::no_page;
use crate::cli::console::output::Failure;
use std::path::Path;

/// Where an audit goes.
pub(crate) enum Destination<'a> {
    /// A text.
    Output(Output),
    /// Into this folder.
    Pages(&'a Path),
}

impl Destination<'_> {
    pub(crate) fn of(arguments: &AuditArguments) -> Result<Destination<'_>, Failure> {
        match arguments.format.of_text(arguments.file.as_ref()) {
            None => Ok(Destination::Pages(folder(arguments.file.as_deref())?)),
            Some(to) => Ok(Destination::Output(no_page(to)?)),
        }
    }
}
