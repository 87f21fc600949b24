//! `subcert new`.

use crate::cli::arguments::NewArguments;
use crate::cli::console::output::{Failure, Outcome, write, write_results};
use std::fs::File;
use std::io::{ErrorKind, Write as _};
use std::path::{Path, PathBuf};
use subcert::claim::{embedded, is_id};
use subcert::files::permitted;

/// A claim file that audits cleanly; `KEY` stands for its key.
const TEMPLATE: &str = include_str!("template.toml");

pub(crate) fn new(arguments: &NewArguments) -> Outcome {
    let key = &arguments.key;
    if !is_id(key) {
        return Err(Failure::Input(format!(
            "`{key}` cannot be a key: use letters, digits, `-`, `_` and `.`, as in doe2026-corner"
        )));
    }
    let known = embedded().iter().find(|paper| paper.key == *key);
    let text = known.map_or_else(|| TEMPLATE.replace("KEY", key), |paper| paper.text.to_owned());
    let path = arguments.output.clone().unwrap_or_else(|| PathBuf::from(format!("{key}.toml")));
    if path.as_os_str() == "-" {
        return write(&text);
    }
    save(&path, &text)?;
    let path = path.display();
    write_results(&format!(
        "{path}: a claim file to start from; `subcert audit {path}` judges its claims\n"
    ))
}

/// Writes a file that is not there yet.
fn save(path: &Path, text: &str) -> Outcome {
    let written = permitted(path)
        .and_then(|()| File::create_new(path))
        .and_then(|mut file| file.write_all(text.as_bytes()));
    written.map_err(|error| {
        let path = path.display();
        Failure::Input(match error.kind() {
            ErrorKind::AlreadyExists => format!(
                "`{path}` is there already, and stays as it is: name another file with -o FILE, or \
                 `-o -` for the standard output"
            ),
            _ => format!("cannot write `{path}`: {error}"),
        })
    })
}
