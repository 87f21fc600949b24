//! Certificates of verdicts, in the format of `proofs/FORMAT.md`.
//!
//! Nothing here is trusted: a certificate says what the audit has found, and `proofs/checker`,
//! which shares no code with this crate, accepts or rejects it.

mod block;
mod constant;
mod coq;
mod depth;
mod equation;
mod family;
mod lattice;
mod limits;
mod parametric;
mod promise;
mod radius;
mod reading;
mod shipped;
mod shown;
mod smooth_range;
mod smoothness;
mod table;
mod theorem;
mod vertex;
mod witness;

use crate::audit::{Finding, PaperAudit};
use crate::claim::Paper;
use block::{Block, Certified as _, words};
pub use coq::{CoqFile, coq_files};
pub use depth::{DepthDirection, DepthFar, depth_certificate};
pub use radius::{radius_certificate, smoothness_certificate};
pub use shipped::project_certificate;
use subcert_claims::with_kinds;

macro_rules! blocks {
    ($($(#[$doc:meta])* $kind:ident $name:literal $field:ident $c:ident $finding:ident $claim:ident,)*) => {
        /// What the certificate of a paper says of a claim.
        fn block(finding: Finding<'_, '_>, paper: &Paper) -> Block {
            match finding { $(Finding::$kind(finding) => finding.block(paper),)* }
        }
    };
}

with_kinds!(blocks);

/// The version of the format.
const VERSION: &str = "subcert-certificate 4";

/// The certificate of a paper's claims.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Certificate {
    /// The paper's key.
    pub key: String,
    /// The certificate.
    pub text: String,
    /// The number of claims that it covers.
    pub blocks: usize,
    /// The claims that it does not cover.
    pub omitted: Vec<Omission>,
}

/// A claim that the format cannot express.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Omission {
    /// `key:claim`.
    pub id: String,
    /// The reason.
    pub why: String,
}

/// The certificate of the verdicts of a paper.
///
/// ```
/// use subcert::audit::audit;
/// use subcert::certificate::certificate;
/// use subcert::claim::embedded_papers;
///
/// let papers = embedded_papers()?;
/// let text = certificate(&audit(&papers[2])?).text;
/// assert!(text.starts_with("subcert-certificate 4\npaper khan2019-newton\n"));
/// assert!(text.contains("\n  cell 1 1 \"0.002500\" 1/400 confirmed\n"));
/// # Ok::<(), subcert::diagnostic::Diagnostic>(())
/// ```
#[must_use]
pub fn certificate(audit: &PaperAudit<'_>) -> Certificate {
    let paper = audit.paper;
    let key = &paper.key;
    let mut text = format!("{VERSION}\npaper {key}\n");
    text.extend(["# ", &words(&paper.bibliography.short()), "\n"]);
    let (mut count, mut omitted) = (0, Vec::new());
    for CertifiedClaim { id, lines } in certificate_lines(audit) {
        match lines {
            Ok(lines) => {
                text.push_str(&lines);
                count += 1;
            }
            Err(why) => {
                text.extend(["# nothing of ", &id, ": ", &why, "\n"]);
                omitted.push(Omission { id: format!("{key}:{id}"), why });
            }
        }
    }
    text.extend(["end ", &count.to_string(), "\n"]);
    Certificate { key: key.clone(), text, blocks: count, omitted }
}

/// What a certificate says of one claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CertifiedClaim {
    /// The id of the claim within its paper.
    pub id: String,
    /// Its lines; the error says why the format cannot express it.
    pub lines: Result<String, String>,
}

/// The lines of the certificate, claim by claim, in its order.
///
/// ```
/// use subcert::audit::audit;
/// use subcert::certificate::{certificate, certificate_lines};
/// use subcert::claim::embedded_papers;
///
/// let papers = embedded_papers()?;
/// let audit = audit(&papers[2])?;
/// let claims = certificate_lines(&audit);
/// assert_eq!(claims[0].id, "table-1");
/// let lines = claims[0].lines.as_deref().unwrap_or_default();
/// assert!(lines.starts_with("table table-1\n") && certificate(&audit).text.contains(lines));
/// # Ok::<(), subcert::diagnostic::Diagnostic>(())
/// ```
#[must_use]
pub fn certificate_lines(audit: &PaperAudit<'_>) -> Vec<CertifiedClaim> {
    let paper = audit.paper;
    let claim = |finding| {
        let block = block(finding, paper);
        let id = block.id().to_owned();
        CertifiedClaim { id, lines: block.text().map_err(|why| words(&why)) }
    };
    audit.findings().map(claim).collect()
}
