//! Pages in files, and `subcert audit --format html`: a page for each paper, and their index.

use super::certified::Certified;
use crate::cli::console::output::{Failure, Outcome, write_results};
use crate::cli::console::save::{save, save_in};
use std::io::ErrorKind;
use std::path::Path;
use subcert::audit::PaperAudit;
use subcert::report::Sheet;
use subcert::report::html::{audit_page, index_page};

/// The name of the index, without its extension.
pub(crate) const INDEX: &str = "index";

/// The folder for pages, as far as it can be told before the papers are judged.
pub(crate) fn folder(given: Option<&Path>) -> Result<&Path, Failure> {
    let Some(folder) = given else {
        let message = "--format html writes files: name a folder for them with -o DIR";
        return Err(Failure::Input(message.to_owned()));
    };
    if folder.as_os_str() == "-" {
        let message = "--format html writes several files, and `-` is the standard output: name a folder for them with -o DIR";
        return Err(Failure::Input(message.to_owned()));
    }
    if folder.exists() && !folder.is_dir() {
        return Err(Failure::Input(format!(
            "`{}` is no folder, and stays as it is: name another one with -o DIR",
            folder.display()
        )));
    }
    Ok(folder)
}

/// Writes the pages into a folder, which is made if it is missing; `embedded` says that the papers
/// come without claim files.
pub(crate) fn pages(
    audits: &[PaperAudit<'_>],
    certified: Option<&Certified>,
    embedded: bool,
    folder: &Path,
) -> Outcome {
    write_pages(audits, certified, embedded, folder)?;
    tell(folder, audits.len(), "")
}

/// Says how many pages a folder has, and `of` what.
pub(crate) fn tell(folder: &Path, count: usize, of: &str) -> Outcome {
    let (folder, pages) = (folder.display(), if count == 1 { "page" } else { "pages" });
    write_results(&format!("{folder}: {count} {pages}{of}, and index.html, which leads to them\n"))
}

/// The same, without a word.
pub(crate) fn write_pages(
    audits: &[PaperAudit<'_>],
    certified: Option<&Certified>,
    embedded: bool,
    folder: &Path,
) -> Outcome {
    let mut more = Sheet::default();
    if let Some(certified) = certified {
        certified.section(&mut more);
    }
    let page = |audit: &PaperAudit<'_>| {
        let file = (!embedded).then_some(audit.paper.source.name.as_str());
        let checked = certified.map(|certified| certified.of_paper(audit));
        Ok(audit_page(audit, file, checked.as_ref())?)
    };
    let index = index_page(audits, &more);
    write_all("paper", audits, |audit| &audit.paper.key, page, &index, folder)
}

/// Writes a page for each audit of a paper or what else `kind` says, by their keys, and their index.
pub(crate) fn write_all<A>(
    kind: &str,
    audits: &[A],
    key: impl Fn(&A) -> &str,
    page: impl Fn(&A) -> Result<String, Failure>,
    index: &str,
    folder: &Path,
) -> Outcome {
    if audits.iter().any(|audit| key(audit) == INDEX) {
        return Err(Failure::Input(format!(
            "a {kind} of the key `index` would take the place of the index: give it another key"
        )));
    }
    for audit in audits {
        write(folder, key(audit), &page(audit)?)?;
    }
    write(folder, INDEX, index)
}

/// Writes the page of this name into a folder.
pub(crate) fn write(folder: &Path, name: &str, text: &str) -> Outcome {
    let name = format!("{name}.html");
    unwritten(&folder.join(&name), save_in(folder, &name, text))
}

/// Writes a page, whole or not at all.
pub(crate) fn write_page(path: &Path, text: &str) -> Outcome {
    unwritten(path, save(path, text))
}

fn unwritten(path: &Path, written: std::io::Result<()>) -> Outcome {
    written.map_err(|error| {
        let path = path.display();
        Failure::Input(match error.kind() {
            ErrorKind::PermissionDenied => format!(
                "cannot write `{path}`: this folder is not yours to write to; name another one with -o DIR"
            ),
            _ => format!("cannot write `{path}`: {error}; name another folder with -o DIR"),
        })
    })
}
