//! Single findings: to the standard output, or as a page in a file.

use super::output::Failure;
use crate::cli::arguments::{FindingOutput, Output};
use crate::cli::papers::pages::folder;
use std::path::{Path, PathBuf};
use subcert::report::html::shell_word;

/// Where a finding goes.
pub(crate) enum Destination {
    /// A text.
    Output(Output),
    /// A page to the standard output.
    Page,
    /// A page into this file.
    File(PathBuf),
    /// A page of this name into a folder, which is made if it is missing.
    Folder(PathBuf, String),
}

impl Destination {
    /// As far as it can be told before anything is computed; in a folder the page is called `name`.
    pub(crate) fn of(output: &FindingOutput, name: &str) -> Result<Destination, Failure> {
        let file = output.file.as_ref();
        match (output.format.of_text(file), file.map(PathBuf::as_path)) {
            (Some(text), _) => Ok(Destination::Output(no_page(text)?)),
            (None, None) => Ok(Destination::Page),
            (None, Some(path)) if path.as_os_str() == "-" => Ok(Destination::Page),
            (None, Some(path)) if is_page(path) => Ok(Destination::File(path.to_owned())),
            (None, path) => Ok(Destination::Folder(folder(path)?.to_owned(), plain(name))),
        }
    }
}

/// Where a text goes, which is no file for a page, and no folder.
pub(crate) fn no_page(to: Output) -> Result<Output, Failure> {
    match &to.file {
        Some(path) if is_page(path) || path.is_dir() => Err(Failure::Input(format!(
            "`{}` is for pages: add --format html, or name another file with -o FILE",
            path.display()
        ))),
        _ => Ok(to),
    }
}

/// Whether a path names a page and not a folder for it.
fn is_page(path: &Path) -> bool {
    let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
    (extension == "html" || extension == "htm") && !path.is_dir()
}

/// A name of a file: letters, digits, `-`, `_` and `.`.
pub(crate) fn plain(name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() || "-_.".contains(c) { c } else { '-' };
    let name: String = name.chars().map(plain).collect();
    let name = name.trim_start_matches('.');
    if name.is_empty() { "page".to_owned() } else { name.to_owned() }
}

/// The command that this program was called by, without what says where the page goes.
pub(crate) fn command() -> String {
    let mut words = vec!["subcert".to_owned()];
    let mut arguments = std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned());
    while let Some(word) = arguments.next() {
        match word.as_str() {
            "--format" | "-o" | "--output" => drop(arguments.next()),
            word if word.starts_with("--format=") || word.starts_with("--output=") => {}
            word if word.starts_with("-o") => {}
            word => words.push(shell_word(word)),
        }
    }
    words.join(" ")
}
