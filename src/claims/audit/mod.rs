//! From claims to verdicts.

mod chosen;
mod jobs;

pub use crate::cores::map as on_all_cores;
pub use crate::digest::{
    Beyond, BeyondCap, Cause, CellErratum, CellGroup, CellOutcome, CellStanding, CellSummary,
    ClaimVerdict, Consequences, Coverage, CoverageState, Errata, Erratum, HowRead, KernelCounts,
    NotSharp, Opposed, Share, Subject, Unchecked,
};
pub use crate::evaluation::Limits;
pub use crate::evaluation::{Choice, Copied, Effect, FAMILY, QUANTITIES, Way};
pub use crate::evidence::{
    AttainedConstant, DepthLevels, Evidence, Powers, PromiseEvidence, SearchedConstant, SoundCell,
    by_hand, depth_levels, evidence, kernel_findings, promise_evidence, promise_refiner,
    theorem_evidence, working,
};
pub use crate::finding::*;
pub use crate::judge::MAX_CASES;
pub use crate::verdict::{Standing, Tally, Word};

use crate::audit::chosen::Chosen;
use crate::claim::Paper;
use crate::diagnostic::{Diagnostic, Errors};
use crate::evaluation::library::Library;

/// Judges every claim of a paper.
///
/// # Errors
/// When a formula of the claim file is wrong: an unknown name or function, or
/// one that is used as it cannot be. A wrong claim is a finding, not an error.
///
/// ```
/// use subcert::audit::{audit, Verdict};
/// use subcert::claim::embedded_papers;
///
/// let papers = embedded_papers()?;
/// let khan = audit(&papers[2])?;
/// assert_eq!(khan.tables[0].cells[0][0].verdict, Verdict::Confirmed);
/// # Ok::<(), subcert::diagnostic::Diagnostic>(())
/// ```
///
/// # Panics
/// Never.
pub fn audit(paper: &Paper) -> Result<PaperAudit<'_>, Diagnostic> {
    let mut audits = audit_all(std::slice::from_ref(paper), &|| {})?;
    Ok(audits.pop().expect("an audit for the paper"))
}

/// Judges every claim of these papers, each paper by itself, on all cores; calls `after_claim`
/// after each claim.
///
/// # Errors
/// As [`audit`]: the first error of the first paper that has one.
pub fn audit_all<'a>(
    papers: &'a [Paper],
    after_claim: &(dyn Fn() + Sync),
) -> Result<Vec<PaperAudit<'a>>, Diagnostic> {
    audit_whole(papers, after_claim).map_err(Errors::first)
}

/// As [`audit_all`], but fails with all errors of the first paper that has some, if they do not
/// follow from each other.
///
/// # Errors
/// As [`audit`].
pub fn audit_whole<'a>(
    papers: &'a [Paper],
    after_claim: &(dyn Fn() + Sync),
) -> Result<Vec<PaperAudit<'a>>, Errors> {
    let found = audit_partly(papers, after_claim);
    found.into_iter().map(|(audit, errors)| errors.map(|()| audit)).collect()
}

/// As [`audit_whole`], but judges what has no errors, and gives the errors of each paper beside. A table with an error is left out
/// with the tables about the same schemes, since numbers of one may determine a parameter of another.
///
/// ```
/// use subcert::audit::audit_partly;
/// use subcert::claim::read_paper;
/// use subcert::diagnostic::SourceText;
///
/// let claim = |id: &str, states: &str| format!("[[relation]]\nid = '{id}'\nlocus = '1'\nstates = '{states}'\n");
/// let head = "key = 'k'\n[paper]\ntitle = 'T'\nyear = 2026\n";
/// let text = format!("{head}{}{}", claim("a", "1 < 2"), claim("b", "wrong(2) = 1"));
/// let paper = read_paper(&SourceText::new("k.toml", text))?;
/// let found = audit_partly(std::slice::from_ref(&paper), &|| {});
/// let (audit, errors) = &found[0];
/// assert_eq!((audit.equations.len(), errors.is_err()), (1, true));
/// # Ok::<(), subcert::diagnostic::Errors>(())
/// ```
pub fn audit_partly<'a>(
    papers: &'a [Paper],
    after_claim: &(dyn Fn() + Sync),
) -> Vec<(PaperAudit<'a>, Result<(), Errors>)> {
    jobs::judge(papers, &|_| Chosen::all(), after_claim)
}

/// Judges one claim of a paper, on all cores, and the claims that it needs: those on which a
/// theorem rests, and the tables that may determine a table's unstated parameters. Their findings
/// are those of [`audit`]; the other claims of the paper are left out. `id` is the id of the claim
/// within the paper.
///
/// # Errors
/// As [`audit`], for the claims that are judged.
///
/// # Panics
/// Never.
pub fn audit_claim<'a>(
    paper: &'a Paper,
    id: &str,
    after_claim: &(dyn Fn() + Sync),
) -> Result<PaperAudit<'a>, Errors> {
    let paper = std::slice::from_ref(paper);
    let mut audits = jobs::judge(paper, &|paper| Chosen::claim(paper, id), after_claim);
    let (audit, errors) = audits.pop().expect("an audit for the paper");
    errors.map(|()| audit)
}

/// The number of claims that [`audit_claim`] judges.
#[must_use]
pub fn claims_needed(paper: &Paper, id: &str) -> usize {
    let chosen = Chosen::claim(paper, id);
    paper.claims().filter(|claim| chosen.has(claim.id())).count()
}

/// Every reading that the search compares for the cells of one kind, with the cells that it
/// explains, the best first; empty where no cell is printed.
///
/// # Errors
/// As [`audit`].
pub fn readings(
    paper: &Paper,
    finding: &TableFinding<'_>,
    kind: CellKind,
) -> Result<Vec<Explanation>, Diagnostic> {
    crate::judge::table::readings(paper, finding, kind, &Library::new(paper))
}
