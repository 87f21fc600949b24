//! Errors as exceptions that carry a place and a remedy.

use pyo3::import_exception;
use pyo3::prelude::*;
use std::fmt::Display;
use subcert::diagnostic::Diagnostic;
use subcert::scheme::SchemeError;

import_exception!(subcert._errors, SubcertError);

/// `subcert.SubcertError`, with what is wrong, where, and what would be right. Python makes it when it is raised:
/// a thread that works beside Python may call this.
fn exception(message: &str, place: Option<String>, remedy: Option<&str>) -> PyErr {
    SubcertError::new_err((message.to_owned(), place, remedy.map(str::to_owned)))
}

/// An error without a place in a file.
pub(crate) fn plain(error: impl Display) -> PyErr {
    exception(&error.to_string(), None, None)
}

/// An error with a remedy.
pub(crate) fn with_remedy(message: &str, remedy: &str) -> PyErr {
    exception(message, None, Some(remedy))
}

/// The error of a scheme, with the argument that gives a parameter, if that is what is missing.
pub(crate) fn of_scheme(error: &SchemeError) -> PyErr {
    match error {
        SchemeError::MissingParameter { scheme, parameter } => with_remedy(
            &format!("`{scheme}` needs its parameter `{parameter}`"),
            &format!("write Scheme(\"{scheme}\", {parameter}=…)"),
        ),
        other => plain(other),
    }
}

/// An error at a place in a file.
pub(crate) fn located(diagnostic: &Diagnostic) -> PyErr {
    let (line, column) = diagnostic.line_and_column();
    let place = format!("{}:{line}:{column}", diagnostic.source.name);
    exception(&diagnostic.message, Some(place), diagnostic.help.as_deref())
}
