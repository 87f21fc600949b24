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

macro_rules! claims {
    ($($key:literal),* $(,)?) => {
        [$(EmbeddedPaper {
            key: $key,
            text: include_str!(concat!("../../proofs/claims/", $key, ".toml")),
        }),*]
    };
}

const PAPERS: [EmbeddedPaper; 5] = claims![
    "mustafa2007-bajaj",
    "mustafa2007-ternary",
    "khan2019-newton",
    "mustafa2020-nary",
    "khan2022-doo-sabin",
];

/// The embedded claim files, in the order of the papers' years.
#[must_use]
pub fn embedded() -> &'static [EmbeddedPaper] {
    &PAPERS
}

/// The embedded papers, read.
///
/// # Errors
/// Never in a released program: a test reads them all.
pub fn embedded_papers() -> Result<Vec<Paper>, Diagnostic> {
    let read = |paper: &EmbeddedPaper| {
        let name = format!("proofs/claims/{}.toml", paper.key);
        read_paper(&SourceText::new(name, paper.text))
    };
    PAPERS.iter().map(read).collect()
}
