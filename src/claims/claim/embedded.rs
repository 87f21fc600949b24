//! The claim files that are part of the program.

use super::paper::Paper;
use super::read::read_paper;
use crate::diagnostic::{Diagnostic, SourceText};

/// A claim file that is part of the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EmbeddedPaper {
    /// The paper's key.
    pub key: &'static str,
    /// The text of its claim file.
    pub text: &'static str,
}

/// Every file of the folder `proofs/claims`, by year and key: `build.rs` lists them.
const PAPERS: &[EmbeddedPaper] = &include!(concat!(env!("OUT_DIR"), "/papers.rs"));

/// The embedded claim files, by the year of the paper, and within one year by key.
#[must_use]
pub fn embedded() -> &'static [EmbeddedPaper] {
    PAPERS
}

/// The embedded papers, read.
///
/// # Errors
/// Never in a released program: a test reads them all.
pub fn embedded_papers() -> Result<Vec<Paper>, Diagnostic> {
    PAPERS.iter().map(embedded_paper).collect()
}

/// An embedded paper, read.
///
/// # Errors
/// Never in a released program.
pub(crate) fn embedded_paper(paper: &EmbeddedPaper) -> Result<Paper, Diagnostic> {
    let name = format!("proofs/claims/{}.toml", paper.key);
    read_paper(&SourceText::new(name, paper.text))
}
