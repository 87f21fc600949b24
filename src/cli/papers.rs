//! The papers that a command is about.

use super::output::Failure;
use std::path::PathBuf;
use subcert::audit::{PaperAudit, audit};
use subcert::claim::{Paper, embedded_papers, read_paper_file};

/// The papers of claim files; without any, the embedded ones.
pub(super) fn papers(files: &[PathBuf]) -> Result<Vec<Paper>, Failure> {
    if files.is_empty() {
        return Ok(embedded_papers()?);
    }
    let read = |path: &PathBuf| -> Result<Paper, Failure> {
        Ok(read_paper_file(path).map_err(Failure::Input)??)
    };
    let papers = files.iter().map(read).collect::<Result<Vec<Paper>, Failure>>()?;
    for (i, paper) in papers.iter().enumerate() {
        if papers[..i].iter().any(|earlier| earlier.key == paper.key) {
            let message = format!("two of the files have the key `{}`", paper.key);
            return Err(Failure::Input(message));
        }
    }
    Ok(papers)
}

/// The paper of this key; without a key, all of them.
pub(super) fn select(papers: Vec<Paper>, key: Option<&str>) -> Result<Vec<Paper>, Failure> {
    let Some(key) = key else { return Ok(papers) };
    let known: Vec<String> = papers.iter().map(|paper| paper.key.clone()).collect();
    let papers: Vec<Paper> = papers.into_iter().filter(|paper| paper.key == key).collect();
    if papers.is_empty() {
        let known = known.join(", ");
        return Err(Failure::Input(format!("no paper has the key `{key}`; known: {known}")));
    }
    Ok(papers)
}

/// Judges every claim of the papers.
pub(super) fn judge_all(papers: &[Paper]) -> Result<Vec<PaperAudit<'_>>, Failure> {
    papers.iter().map(|paper| audit(paper).map_err(Failure::from)).collect()
}
