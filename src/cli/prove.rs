//! `subcert prove`.

use super::arguments::ProveArguments;
use super::output::{Failure, Outcome, write, write_results};
use super::papers::{judge_all, papers_or_keys};
use std::fmt::Write as _;
use std::fs::{File, create_dir_all, remove_file, rename};
use std::io::{self, Write as _};
use std::path::Path;
use subcert::certificate::{Certificate, certificate};

pub(super) fn prove(arguments: &ProveArguments) -> Outcome {
    let papers = papers_or_keys(&arguments.what)?;
    let certificates: Vec<Certificate> =
        judge_all(&papers, true)?.iter().map(certificate).collect();
    let folder = &arguments.output;
    if folder.as_os_str() == "-" {
        let [only] = &certificates[..] else {
            let message = "one certificate at a time goes to the standard output: name one paper";
            return Err(Failure::Input(message.to_owned()));
        };
        return write(&only.text);
    }
    let mut said = String::new();
    for certificate in &certificates {
        let path = folder.join(format!("{}.cert", certificate.key));
        save(&path, &certificate.text).map_err(|error| {
            Failure::Input(format!("cannot write `{}`: {error}", path.display()))
        })?;
        let claims = if certificate.blocks == 1 { "claim" } else { "claims" };
        let _ = writeln!(said, "{}: {} {claims}", path.display(), certificate.blocks);
        for omission in &certificate.omitted {
            let _ = writeln!(said, "  without {}: {}", omission.id, omission.why);
        }
    }
    write_results(&said)
}

/// Writes a file that is there either as it was before or whole.
fn save(path: &Path, text: &str) -> io::Result<()> {
    let folder = path.parent().unwrap_or(Path::new("."));
    create_dir_all(folder)?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let draft = folder.join(format!(".{name}.{}", std::process::id()));
    let mut file = File::create_new(&draft)?;
    let written = file.write_all(text.as_bytes()).and_then(|()| file.sync_all());
    drop(file);
    let done = written.and_then(|()| rename(&draft, path));
    if done.is_err() {
        // The first error is the one to be told.
        let _ = remove_file(&draft);
    }
    done
}
