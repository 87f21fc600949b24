//! `subcert prove`.

use super::claim_files::{Claims, claims_or_keys};
use super::judged::judge_all;
use super::projects::judge_projects;
use crate::cli::arguments::ProveArguments;
use crate::cli::console::output::{Failure, Outcome, write, write_results};
use crate::cli::console::save::save_in;
use std::fmt::Write as _;
use std::path::Path;
use subcert::audit::PaperAudit;
use subcert::certificate::{Certificate, CoqFile, certificate, coq_files, project_certificate};

pub(crate) fn prove(arguments: &ProveArguments) -> Outcome {
    let claims = claims_or_keys(&arguments.what)?;
    let count = match &claims {
        Claims::Papers(papers) => papers.len(),
        Claims::Projects(projects) => projects.len(),
    };
    let ProveArguments { output, coq, .. } = arguments;
    // Before anything is judged.
    if output.as_ref().is_some_and(|output| output.as_os_str() == "-") && count != 1 {
        let message = "one certificate at a time goes to the standard output: name one paper or \
                       project";
        return Err(Failure::Input(message.to_owned()));
    }
    let certificates: Vec<Certificate> = match claims {
        Claims::Papers(papers) => {
            let audits = judge_all(&papers, true)?;
            if let Some(folder) = coq {
                theorems(&audits, folder)?;
            }
            match output {
                Some(_) => audits.iter().map(certificate).collect(),
                None => return Ok(()),
            }
        }
        Claims::Projects(_) if coq.is_some() => {
            let message = "the library of Coq has no theorems about constants of programs: \
                           without --coq";
            return Err(Failure::Input(message.to_owned()));
        }
        Claims::Projects(projects) => {
            judge_projects(&projects, true)?.iter().map(project_certificate).collect()
        }
    };
    output.as_ref().map_or(Ok(()), |output| deliver(&certificates, output))
}

/// Writes the theorems of Coq into folders, one for each paper.
fn theorems(audits: &[PaperAudit<'_>], folder: &Path) -> Outcome {
    let mut said = String::new();
    for audit in audits {
        let files = coq_files(audit)?;
        for CoqFile { name, text, .. } in &files {
            let path = folder.join(name);
            save_in(folder, name, text).map_err(|error| {
                Failure::Input(format!("cannot write `{}`: {error}", path.display()))
            })?;
        }
        let theorems: usize = files.iter().map(|file| file.theorems).sum();
        let (key, files) = (&audit.paper.key, files.len());
        let _ = writeln!(said, "{key}: {theorems} theorems of Coq in {files} files");
    }
    write_results(&said)
}

/// Writes certificates into a folder, or to the standard output.
fn deliver(certificates: &[Certificate], folder: &Path) -> Outcome {
    if folder.as_os_str() == "-" {
        return certificates.iter().try_for_each(|certificate| write(&certificate.text));
    }
    let mut said = String::new();
    for certificate in certificates {
        let name = format!("{}.cert", certificate.key);
        let path = folder.join(&name);
        save_in(folder, &name, &certificate.text).map_err(|error| {
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
