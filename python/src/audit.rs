//! Audits, as the JSON that `docs/json.md` describes.

use crate::error::{located, plain, with_remedy};
use crate::run::aside;
use pyo3::prelude::*;
use std::path::Path;
use subcert::audit::audit_whole;
use subcert::claim::{Paper, embedded, embedded_papers, read_paper_file};
use subcert::report::json::AuditReport;
use subcert::suggestion::known;

/// The keys of the papers that come with the module.
#[pyfunction]
pub fn paper_keys() -> Vec<&'static str> {
    embedded().iter().map(|paper| paper.key).collect()
}

/// What an audit of these claim files, or papers of the module, finds.
#[pyfunction]
pub fn audit_json(py: Python<'_>, what: Vec<String>) -> PyResult<String> {
    let papers = what.iter().map(|word| paper(word)).collect::<PyResult<Vec<Paper>>>()?;
    aside(py, move || {
        let audits = audit_whole(&papers, &|| ()).map_err(|errors| located(&errors.first()))?;
        serde_json::to_string(&AuditReport::of(&audits)).map_err(plain)
    })
}

fn paper(word: &str) -> PyResult<Paper> {
    let papers = embedded_papers().map_err(|error| located(&error))?;
    if let Some(paper) = papers.iter().find(|paper| paper.key == word) {
        return Ok(paper.clone());
    }
    let path = Path::new(word);
    if word.contains('\n') {
        let remedy = "write the claims into a file, and give its path";
        return Err(with_remedy("a text of several lines is no path of a claim file", remedy));
    }
    if !path.exists() {
        let names = known(word, paper_keys());
        return Err(plain(format!("`{word}` is no claim file, and no key of a paper{names}")));
    }
    match read_paper_file(path).map_err(plain)? {
        Ok(paper) => Ok(paper),
        Err(errors) => Err(located(&errors.first())),
    }
}
