//! Claim files, of papers or of projects.

use crate::cli::console::output::Failure;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use subcert::claim::{MAX_CLAIM_FILE_BYTES, Paper, embedded_papers, read_whole_paper};
use subcert::diagnostic::{SourceText, read_text, read_text_from};
use subcert::shipped::{Project, is_project, read_project};
use subcert::suggestion::known as names;

/// What stands for the standard input in place of a claim file.
const STANDARD_INPUT: &str = "-";

/// What claim files are about. A command takes files of one kind.
pub(crate) enum Claims {
    /// Papers.
    Papers(Vec<Paper>),
    /// Constants that programs ship.
    Projects(Vec<Project>),
}

/// The papers or projects of claim files; without any, the embedded papers.
pub(crate) fn claims(files: &[PathBuf]) -> Result<Claims, Failure> {
    if files.is_empty() {
        return Ok(Claims::Papers(embedded_papers()?));
    }
    let texts: Vec<Arc<SourceText>> =
        files.iter().map(|path| text(path)).collect::<Result<_, Failure>>()?;
    of_texts(Vec::new(), &texts)
}

/// The embedded papers of these keys, and what claim files are about; without any, the embedded papers.
pub(crate) fn claims_or_keys(what: &[String]) -> Result<Claims, Failure> {
    let embedded = embedded_papers()?;
    if what.is_empty() {
        return Ok(Claims::Papers(embedded));
    }
    let (mut papers, mut texts) = (Vec::new(), Vec::new());
    for word in what {
        if let Some(paper) = embedded.iter().find(|paper| paper.key == *word) {
            papers.push(paper.clone());
            continue;
        }
        let path = Path::new(word);
        if path.as_os_str() != STANDARD_INPUT && !path.exists() {
            let keys = names(word, embedded.iter().map(|paper| paper.key.as_str()));
            let message = format!("`{word}` is no claim file, and no key of a paper{keys}");
            return Err(Failure::Input(message));
        }
        texts.push(text(path)?);
    }
    of_texts(papers, &texts)
}

/// These papers and those of the texts; or the projects of the texts, if there are no papers.
fn of_texts(mut papers: Vec<Paper>, texts: &[Arc<SourceText>]) -> Result<Claims, Failure> {
    let projects = texts.iter().filter(|text| is_project(&text.text)).count();
    if projects == 0 {
        for text in texts {
            papers.push(read_whole_paper(text)?);
        }
        distinct(papers.iter().map(|paper| paper.key.as_str()))?;
        return Ok(Claims::Papers(papers));
    }
    if projects < texts.len() || !papers.is_empty() {
        let message = "some of these are about papers and some about projects: call the program once for \
                       the papers, and once for the projects";
        return Err(Failure::Input(message.to_owned()));
    }
    let mut found = Vec::with_capacity(texts.len());
    for text in texts {
        found.push(read_project(text)?);
    }
    distinct(found.iter().map(|project| project.key.as_str()))?;
    Ok(Claims::Projects(found))
}

/// The text of a claim file.
fn text(path: &Path) -> Result<Arc<SourceText>, Failure> {
    if path.as_os_str() != STANDARD_INPUT {
        let text = read_text(path, MAX_CLAIM_FILE_BYTES).map_err(|reason| {
            let meant = if path.exists() { String::new() } else { meant(path) };
            Failure::Input(format!("cannot read `{}`: {reason}{meant}", path.display()))
        })?;
        return Ok(SourceText::new(path.display().to_string(), text));
    }
    let text = read_text_from(std::io::stdin().lock(), MAX_CLAIM_FILE_BYTES)
        .map_err(|reason| Failure::Input(format!("cannot read the standard input: {reason}")))?;
    if text.trim().is_empty() {
        let message = "the standard input, for which `-` stands, is empty or was read before";
        return Err(Failure::Input(message.to_owned()));
    }
    Ok(SourceText::new("standard input", text))
}

/// What a name of no file may have meant: a key, of a file beside it or of an embedded paper.
fn meant(path: &Path) -> String {
    let file = PathBuf::from(format!("{}.toml", path.display()));
    if file.exists() {
        return format!("; the claim file is `{}`", file.display());
    }
    let is_key = |paper: &Paper| path.as_os_str() == paper.key.as_str();
    let embedded = embedded_papers().is_ok_and(|papers| papers.iter().any(is_key));
    if embedded {
        format!("; the paper of this key is `--paper {}`", path.display())
    } else {
        String::new()
    }
}

/// Checks that keys differ.
fn distinct<'a>(keys: impl Iterator<Item = &'a str>) -> Result<(), Failure> {
    let mut seen: Vec<&str> = Vec::new();
    for key in keys {
        if seen.contains(&key) {
            return Err(Failure::Input(format!("two of the files have the key `{key}`")));
        }
        seen.push(key);
    }
    Ok(())
}
