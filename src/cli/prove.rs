//! `subcert prove`.

use super::arguments::ProveArguments;
use super::claim_files::{Claims, claims_or_keys};
use super::output::{Failure, Outcome, write, write_results};
use super::papers::judge_all;
use super::projects::judge_projects;
use super::save::save;
use std::fmt::Write as _;
use std::path::Path;
use subcert::certificate::{Certificate, certificate, project_certificate};

pub(super) fn prove(arguments: &ProveArguments) -> Outcome {
    let claims = claims_or_keys(&arguments.what)?;
    let count = match &claims {
        Claims::Papers(papers) => papers.len(),
        Claims::Projects(projects) => projects.len(),
    };
    // Before anything is judged.
    if arguments.output.as_os_str() == "-" && count != 1 {
        let message = "one certificate at a time goes to the standard output: name one paper or \
                       project";
        return Err(Failure::Input(message.to_owned()));
    }
    let certificates: Vec<Certificate> = match claims {
        Claims::Papers(papers) => judge_all(&papers, true)?.iter().map(certificate).collect(),
        Claims::Projects(projects) => {
            judge_projects(&projects, true)?.iter().map(project_certificate).collect()
        }
    };
    deliver(&certificates, &arguments.output)
}

/// Writes certificates into a folder, or to the standard output.
fn deliver(certificates: &[Certificate], folder: &Path) -> Outcome {
    if folder.as_os_str() == "-" {
        return certificates.iter().try_for_each(|certificate| write(&certificate.text));
    }
    let mut said = String::new();
    for certificate in certificates {
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
