//! The papers that a command is about.

use super::claim_files::{Claims, claims};
use crate::cli::console::output::Failure;
use crate::cli::console::progress::Progress;
use std::path::PathBuf;
use subcert::audit::{PaperAudit, audit_claim, audit_partly, claims_needed};
use subcert::claim::Paper;
use subcert::diagnostic::Errors;
use subcert::report::html::shell_word;
use subcert::suggestion::known as names;

/// The papers of claim files, for a command that is about papers alone; without any, the embedded ones.
pub(crate) fn papers(files: &[PathBuf]) -> Result<Vec<Paper>, Failure> {
    match claims(files)? {
        Claims::Papers(papers) => Ok(papers),
        Claims::Projects(_) => Err(Failure::Input(
            "this command is about papers; of claim files with [project], use audit, explain, errata \
             or prove"
                .to_owned(),
        )),
    }
}

/// The paper of this key; without a key, all of them.
pub(crate) fn select(papers: Vec<Paper>, key: Option<&str>) -> Result<Vec<Paper>, Failure> {
    chosen(papers, |paper| &paper.key, key)
}

/// Those of this key; without a key, all of them.
pub(crate) fn chosen<T>(
    all: Vec<T>,
    key_of: impl Fn(&T) -> &str,
    key: Option<&str>,
) -> Result<Vec<T>, Failure> {
    let Some(key) = key else { return Ok(all) };
    let (chosen, others): (Vec<T>, Vec<T>) = all.into_iter().partition(|one| key_of(one) == key);
    if chosen.is_empty() {
        let known = names(key, others.iter().map(key_of));
        return Err(Failure::Input(format!("no paper has the key `{key}`{known}")));
    }
    Ok(chosen)
}

/// What follows a command about a paper: its claim file, unless it is embedded.
pub(crate) fn files_of(paper: &Paper, files: &[PathBuf]) -> String {
    let own = files.iter().find(|file| file.display().to_string() == paper.source.name);
    match own {
        Some(file) => format!(" {}", shell_word(&file.display().to_string())),
        None if files.is_empty() => String::new(),
        // The standard input.
        None => " -".to_owned(),
    }
}

/// Judges a claim of a paper and the claims that it needs, on all cores. With `bar`, a bar shows
/// the progress.
pub(crate) fn judge_claim<'a>(
    paper: &'a Paper,
    id: &str,
    bar: bool,
) -> Result<PaperAudit<'a>, Failure> {
    let progress = Progress::of_claims(claims_needed(paper, id), bar);
    Ok(audit_claim(paper, id, &|| progress.step())?)
}

/// As [`judge_all`], but judges what has no errors; the first errors stand beside.
pub(crate) fn judge_partly(
    papers: &[Paper],
    bar: bool,
) -> (Vec<PaperAudit<'_>>, Result<(), Failure>) {
    let claims = papers.iter().map(|paper| paper.claims().count()).sum();
    let progress = Progress::of_claims(claims, bar);
    let found = audit_partly(papers, &|| progress.step());
    let (audits, errors): (Vec<_>, Vec<_>) = found.into_iter().unzip();
    (audits, errors.into_iter().collect::<Result<(), Errors>>().map_err(Failure::from))
}

/// Judges every claim of the papers, on all cores. With `bar`, a bar shows the progress.
pub(crate) fn judge_all(papers: &[Paper], bar: bool) -> Result<Vec<PaperAudit<'_>>, Failure> {
    let (audits, errors) = judge_partly(papers, bar);
    errors.map(|()| audits)
}
