//! The papers that a command is about.

use super::output::Failure;
use super::progress::Progress;
use std::path::{Path, PathBuf};
use subcert::audit::{PaperAudit, audit_claim, audit_whole, claims_needed};
use subcert::claim::{
    MAX_CLAIM_FILE_BYTES, Paper, embedded_papers, read_paper_file, read_whole_paper,
};
use subcert::diagnostic::{SourceText, read_text_from};
use subcert::suggestion::known as names;

/// The papers of claim files; without any, the embedded ones.
pub(super) fn papers(files: &[PathBuf]) -> Result<Vec<Paper>, Failure> {
    if files.is_empty() {
        return Ok(embedded_papers()?);
    }
    distinct(files.iter().map(|path| read(path)).collect::<Result<Vec<Paper>, Failure>>()?)
}

/// The embedded papers of these keys, and those of claim files; without any, the
/// embedded ones.
pub(super) fn papers_or_keys(what: &[String]) -> Result<Vec<Paper>, Failure> {
    let embedded = embedded_papers()?;
    if what.is_empty() {
        return Ok(embedded);
    }
    let paper = |word: &String| -> Result<Paper, Failure> {
        if let Some(paper) = embedded.iter().find(|paper| paper.key == *word) {
            return Ok(paper.clone());
        }
        let path = Path::new(word);
        if path.as_os_str() != STANDARD_INPUT && !path.exists() {
            let keys = names(word, embedded.iter().map(|paper| paper.key.as_str()));
            let message = format!("`{word}` is no claim file, and no key of a paper{keys}");
            return Err(Failure::Input(message));
        }
        read(path)
    };
    distinct(what.iter().map(paper).collect::<Result<Vec<Paper>, Failure>>()?)
}

/// What stands for the standard input in place of a claim file.
const STANDARD_INPUT: &str = "-";

/// The paper of a claim file.
fn read(path: &Path) -> Result<Paper, Failure> {
    if path.as_os_str() != STANDARD_INPUT {
        return Ok(read_paper_file(path).map_err(Failure::Input)??);
    }
    let text = read_text_from(std::io::stdin().lock(), MAX_CLAIM_FILE_BYTES)
        .map_err(|reason| Failure::Input(format!("cannot read the standard input: {reason}")))?;
    if text.trim().is_empty() {
        let message = "the standard input, for which `-` stands, is empty or was read before";
        return Err(Failure::Input(message.to_owned()));
    }
    Ok(read_whole_paper(&SourceText::new("standard input", text))?)
}

/// These papers, if their keys differ.
fn distinct(papers: Vec<Paper>) -> Result<Vec<Paper>, Failure> {
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
        let known = names(key, known.iter().map(String::as_str));
        return Err(Failure::Input(format!("no paper has the key `{key}`{known}")));
    }
    Ok(papers)
}

/// Judges a claim of a paper and the claims that it needs, on all cores. With `bar`, a bar shows
/// the progress.
pub(super) fn judge_claim<'a>(
    paper: &'a Paper,
    id: &str,
    bar: bool,
) -> Result<PaperAudit<'a>, Failure> {
    let progress = Progress::of_claims(claims_needed(paper, id), bar);
    Ok(audit_claim(paper, id, &|| progress.step())?)
}

/// Judges every claim of the papers, on all cores. With `bar`, a bar shows the progress.
pub(super) fn judge_all(papers: &[Paper], bar: bool) -> Result<Vec<PaperAudit<'_>>, Failure> {
    let claims = papers.iter().map(|paper| paper.tables.len() + paper.smoothness.len()).sum();
    let progress = Progress::of_claims(claims, bar);
    Ok(audit_whole(papers, &|| progress.step())?)
}
