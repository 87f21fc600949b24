//! The check of all claims of a file: of a paper, or of a project.

pub mod paper;
pub mod project;

use crate::claims::Task;
use crate::text::Rejection;
use std::collections::BTreeMap;

/// The outcome of the check of a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// The certificate is right.
    Valid,
    /// The certificate is right and cites this statement of THEOREMS.md. The checker does not
    /// check that the statement proves what the claim says.
    Cited(String),
    /// The certificate with this index is wrong, for this reason.
    Invalid(usize, Rejection),
    /// The claim has no certificate, or the certificate leaves it open for this reason.
    Incomplete(Option<Rejection>),
}

/// The claims of a file and the outcomes of their checks.
#[derive(Debug)]
pub struct Report {
    /// The key of the paper or project.
    pub key: String,
    /// The kind, id and outcome of every claim, in the order of the file.
    pub claims: Vec<(&'static str, String, Outcome)>,
    /// The verdict of each valid or cited certificate, by the id of its claim, in a few words such
    /// as `refuted: 15/16 > 125/144`.
    pub verdicts: BTreeMap<String, String>,
    /// The rejections of whole certificates, with the indices of the certificates.
    pub broken: Vec<(usize, Rejection)>,
}

/// Whether a text can be the id of a claim or the key of a file. It has to fit in one line.
pub fn is_id(text: &str) -> bool {
    let fits = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.');
    !text.is_empty() && text.chars().all(fits)
}

/// The outcome of a claim whose certificate is refused.
pub fn refused(task: &Task<'_>, rejection: Rejection) -> Outcome {
    if rejection.given_up() {
        Outcome::Incomplete(Some(rejection))
    } else {
        Outcome::Invalid(task.place, rejection)
    }
}
