//! Answers of commands: the JSON form, and what is made of it.

use super::csv;
use super::destination::{Destination, command};
use super::output::{self, Outcome};
use crate::cli::arguments::{Format, Output};
use serde::Serialize;
use std::fmt::Display;
use subcert::report::html::{FindingPage, Picture};
use subcert::report::{Grid, Sheet};

pub(crate) use subcert::report::json::SCHEMA;

/// An answer, computed once for every format. Its fields are its JSON form, and their documentation is the schema.
pub(crate) trait Answer: Serialize {
    /// The name of its schema.
    #[cfg_attr(not(feature = "schema"), expect(dead_code))]
    const NAME: &'static str;

    /// What text, Markdown and LaTeX say.
    fn sheet(&self) -> Sheet;

    /// Its table for spreadsheets; without one, CSV has a row for each value of the JSON.
    fn grid(&self) -> Option<Grid> {
        None
    }

    /// It in a sentence, for a page.
    fn sentence(&self) -> String {
        String::new()
    }

    /// The pictures of its page.
    fn pictures(&self) -> Vec<Picture> {
        Vec::new()
    }
}

/// An answer, or the reason that there is none.
#[derive(Clone, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub(crate) enum OrNone<T> {
    /// The answer.
    Found(T),
    /// There is none.
    None {
        /// The reason.
        none: String,
    },
}

impl<T, E: Display> From<Result<T, E>> for OrNone<T> {
    fn from(found: Result<T, E>) -> OrNone<T> {
        match found {
            Ok(found) => OrNone::Found(found),
            Err(why) => OrNone::None { none: why.to_string() },
        }
    }
}

impl<T> OrNone<T> {
    pub(crate) fn map<U>(&self, make: impl FnOnce(&T) -> U) -> OrNone<U> {
        match self {
            OrNone::Found(found) => OrNone::Found(make(found)),
            OrNone::None { none } => OrNone::None { none: none.clone() },
        }
    }

    pub(crate) fn found(&self) -> Option<&T> {
        match self {
            OrNone::Found(found) => Some(found),
            OrNone::None { .. } => None,
        }
    }
}

/// Writes an answer in the chosen format.
pub(crate) fn show(to: &Output, answer: &impl Answer) -> Outcome {
    match answer.grid().filter(|_| to.format == Format::Csv) {
        Some(grid) => output::deliver(&csv::of_grid(&grid), to.file.as_deref()),
        None => output::show(to, || answer.sheet(), || answer),
    }
}

/// The same, also as a page.
pub(crate) fn deliver(to: &Destination, answer: &impl Answer) -> Outcome {
    to.page_or(
        |to| show(to, answer),
        || {
            let (sentence, sheet, pictures) =
                (answer.sentence(), answer.sheet(), answer.pictures());
            let page = FindingPage {
                sentence: &sentence,
                sheet: &sheet,
                pictures: &pictures,
                command: &command(),
            };
            Ok(page.to_html())
        },
    )
}
