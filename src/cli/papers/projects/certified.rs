//! Which tables of projects have a valid certificate, by the word of the checker alone.

use crate::cli::console::output::Failure;
use subcert::certificate::project_certificate;
use subcert::report::{Grid, Sheet};
use subcert::shipped::ProjectAudit;
use subcert_check::{Outcome, check};

/// Writes certificates of the audits, has them checked, and says in a section what came out.
pub(super) fn section(sheet: &mut Sheet, audits: &[ProjectAudit<'_>]) -> Result<(), Failure> {
    let mut rows = Vec::new();
    for audit in audits {
        let source = &audit.project.source;
        let written = project_certificate(audit);
        let report = check(&source.text, &[&written.text]).map_err(|why| {
            let name = &source.name;
            Failure::Input(format!("subcert-check cannot read the claim file `{name}`: {why}"))
        })?;
        let broken = report.broken.first().map(|(_, rejection)| rejection.reason.to_string());
        for (_, id, outcome) in &report.claims {
            let says = match (&broken, outcome) {
                (Some(why), _) => format!("rejected, the certificate is broken: {why}"),
                (None, Outcome::Valid) => "certified".to_owned(),
                (None, Outcome::Cited(statement)) => format!("on the word of {statement}"),
                (None, Outcome::Invalid(_, rejection)) => format!("rejected, {}", rejection.reason),
                (None, Outcome::Incomplete(Some(rejection))) => {
                    format!("incomplete, {}", rejection.reason)
                }
                (None, Outcome::Incomplete(None)) => "incomplete, no certificate".to_owned(),
            };
            rows.push(vec![format!("{}:{id}", report.key), says]);
        }
    }
    sheet.heading(1, "Certificates");
    sheet.text(
        "A table is certified when subcert-check, which shares no code with this program, has found its \
         certificate valid.",
    );
    sheet.grid(Grid::of(["table", "certificate"], rows, 2));
    Ok(())
}
