//! How single findings are written: to the standard output, or as a page.

use super::TableFormat;
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
    /// Tables for a paper, with the packages amssymb and booktabs
    Latex,
    /// A page with pictures for a browser
    Html,
}

impl FindingFormat {
    /// The format of what is no page; `None` of pages.
    pub(in crate::cli) fn of_table(self) -> Option<TableFormat> {
        Some(match self {
            FindingFormat::Text => TableFormat::Text,
            FindingFormat::Json => TableFormat::Json,
            FindingFormat::Markdown => TableFormat::Markdown,
            FindingFormat::Latex => TableFormat::Latex,
            FindingFormat::Html => return None,
        })
    }
}

/// How a finding is written.
#[derive(Debug, Args)]
pub(in crate::cli) struct FindingOutput {
    /// Output format
    #[arg(long, value_enum, default_value_t = FindingFormat::Text)]
    pub(in crate::cli) format: FindingFormat,
    /// Where the page of `--format html` goes: a file that ends in .html, or a folder for it
    /// [default: the standard output]
    #[arg(short = 'o', long = "output", value_name = "FILE|DIR")]
    pub(in crate::cli) page: Option<PathBuf>,
}

impl FindingOutput {
    /// Whether a page with pictures is wanted.
    pub(in crate::cli) fn is_page(&self) -> bool {
        self.format == FindingFormat::Html
    }
}
