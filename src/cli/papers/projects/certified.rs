//! Which tables of projects have a valid certificate, by the word of the checker alone.

use crate::cli::console::output::Failure;
use crate::cli::papers::certified::Checked;
use subcert::certificate::{Certificate, project_certificate};
use subcert::report::{Grid, Sheet};
use subcert::shipped::ProjectAudit;

/// Writes certificates of the audits, has them checked, and says in a section what came out.
pub(super) fn section(sheet: &mut Sheet, audits: &[ProjectAudit<'_>]) -> Result<(), Failure> {
    let mut rows = Vec::new();
    for audit in audits {
        let written = Certificate { omitted: Vec::new(), ..project_certificate(audit) };
        let Checked { key, claims } = Checked::of(&audit.project.source, written)?;
        rows.extend(claims.iter().map(|(id, state)| vec![format!("{key}:{id}"), state.words()]));
    }
    sheet.heading(1, "Certificates");
    sheet.text(
        "A table is certified when subcert-check, which shares no code with this program, has found its \
         certificate valid.",
    );
    sheet.grid(Grid::of(["table", "certificate"], rows, 2));
    Ok(())
}
