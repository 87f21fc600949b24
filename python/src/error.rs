//! Errors as exceptions that carry a place and a remedy.

use pyo3::prelude::*;
use std::fmt::Display;
use subcert::diagnostic::Diagnostic;

/// `subcert.SubcertError`, with what is wrong, where, and what would be right.
fn exception(message: &str, place: Option<String>, remedy: Option<&str>) -> PyErr {
    Python::attach(|py| {
        let class = py.import("subcert._errors").and_then(|module| module.getattr("SubcertError"));
        match class.and_then(|class| class.call1((message, place, remedy))) {
            Ok(error) => PyErr::from_value(error),
            Err(error) => error,
        }
    })
}

/// An error without a place in a file.
pub(crate) fn plain(error: impl Display) -> PyErr {
    exception(&error.to_string(), None, None)
}

/// An error with a remedy.
pub(crate) fn with_remedy(message: &str, remedy: &str) -> PyErr {
    exception(message, None, Some(remedy))
}

/// An error at a place in a file.
pub(crate) fn located(diagnostic: &Diagnostic) -> PyErr {
    let (line, column) = diagnostic.line_and_column();
    let place = format!("{}:{line}:{column}", diagnostic.source.name);
    exception(&diagnostic.message, Some(place), diagnostic.help.as_deref())
}
