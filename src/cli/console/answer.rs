//! Answers of commands: the JSON form, and what is made of it.

use super::csv;
use super::destination::{Destination, command};
use super::output::{self, Failure, Outcome, json_text, write_results};
use super::terminal;
use crate::cli::arguments::{Format, Output};
use crate::cli::papers::pages::{self, write_page};
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

    /// Its LaTeX.
    fn latex(&self) -> String {
        self.sheet().to_latex()
    }

    /// It in a sentence, for a page.
    fn sentence(&self) -> String {
        String::new()
    }

    /// The pictures of its page.
    fn pictures(&self) -> Vec<Picture> {
        Vec::new()
    }

    /// Its page.
    fn page(&self) -> Result<String, Failure> {
        let (sentence, sheet, pictures) = (&self.sentence(), &self.sheet(), &self.pictures());
        Ok(FindingPage { sentence, sheet, pictures, command: &command() }.to_html())
    }
}

/// An answer in a format; as text in lines of this width.
pub(crate) fn text(answer: &impl Answer, format: Format, width: Option<usize>) -> String {
    match format {
        Format::Text => answer.sheet().to_text(width),
        Format::Markdown => answer.sheet().to_markdown(),
        Format::Json => json_text(answer),
        Format::Latex => answer.latex(),
        Format::Csv => csv::of_grid(&answer.grid().unwrap_or_else(|| csv::values(answer))),
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
    let file = to.file.as_deref();
    // A file is as wide as it needs.
    let width = if file.is_none() { terminal::width() } else { None };
    output::deliver(&text(answer, to.format, width), file)
}

/// The same, also as a page.
pub(crate) fn deliver(to: &Destination, answer: &impl Answer) -> Outcome {
    match to {
        Destination::Output(to) => show(to, answer),
        Destination::Page => write_results(&answer.page()?),
        Destination::File(path) => {
            write_page(path, &answer.page()?)?;
            write_results(&format!("{}\n", path.display()))
        }
        Destination::Folder(folder, name) => {
            pages::write(folder, name, &answer.page()?)?;
            let path = folder.join(format!("{name}.html"));
            write_results(&format!("{}\n", path.display()))
        }
    }
}
