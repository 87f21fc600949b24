//! How single findings are written: to the standard output, or as a page.

use super::{Format, Output};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// The formats of single findings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum FindingFormat {
    /// For people
    Text,
    /// For programs
    Json,
    /// For pasting into a report
    Markdown,
    /// For spreadsheets
    Csv,
    /// Tables for a paper, with the packages amssymb and booktabs
    Latex,
    /// A page with pictures for a browser
    Html,
}

impl FindingFormat {
    /// The format of what is no page, into this file; `None` for pages.
    pub(in crate::cli) fn of_text(self, file: Option<&PathBuf>) -> Option<Output> {
        Some(Output { format: Format::named(&self)?, file: file.cloned() })
    }
}

/// How a finding is written.
#[derive(Debug, Args)]
pub(in crate::cli) struct FindingOutput {
    /// Output format; without it, the ending of the file decides
    #[arg(long, value_enum, default_value_t = FindingFormat::Text)]
    pub(in crate::cli) format: FindingFormat,
    /// The file for the results; for `--format html` a file that ends in .html, or a folder for it
    /// [default: the standard output]
    #[arg(id = "output", short = 'o', long, value_name = "FILE|DIR")]
    pub(in crate::cli) file: Option<PathBuf>,
}

impl FindingOutput {
    /// Whether a page with pictures is wanted.
    pub(in crate::cli) fn is_page(&self) -> bool {
        self.format == FindingFormat::Html
    }
}
