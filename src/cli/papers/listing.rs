//! The claims of a paper, without their verdicts.

use crate::cli::arguments::Output;
use crate::cli::console::output::{Outcome, show};
use crate::cli::json::{SCHEMA, listing as form};
use subcert::claim::{Claim, Paper};
use subcert::report::{Grid, Sheet};

/// The kind of a claim, as the list calls it.
fn kind(claim: Claim<'_>) -> &'static str {
    match claim {
        Claim::Smoothness(claim) => claim.kind.name(),
        other => other.kind().name(),
    }
}

/// Writes what `subcert explain` can explain of a paper.
pub(crate) fn listing(paper: &Paper, to: &Output) -> Outcome {
    show(
        to,
        || sheet(paper),
        || form::Listing {
            schema: SCHEMA,
            key: &paper.key,
            claims: paper.claims().map(claim_form).collect(),
        },
    )
}

fn sheet(paper: &Paper) -> Sheet {
    let mut sheet = Sheet::default();
    sheet.heading(1, format!("{} · {}", paper.key, paper.bibliography.short()));
    let row = |claim: Claim<'_>| {
        [claim.id(), kind(claim), claim.locus(), claim.title()].map(str::to_owned).to_vec()
    };
    let header = ["id", "kind", "where", "what"].map(str::to_owned).to_vec();
    sheet.grid(Grid { header, rows: paper.claims().map(row).collect(), left_columns: 4 });
    let key = &paper.key;
    sheet.text(format!(
        "`subcert explain {key}:ID` explains one claim, `subcert explain {key}:ID:ROW:COLUMN` one \
         cell of a table; rows and columns are counted from 1."
    ));
    sheet
}

fn claim_form(claim: Claim<'_>) -> form::Claim<'_> {
    form::Claim { id: claim.id(), kind: kind(claim), locus: claim.locus(), title: claim.title() }
}
