//! The claims of a paper, without their verdicts.

use crate::cli::arguments::Output;
use crate::cli::console::output::{Outcome, show};
use crate::cli::json::{SCHEMA, listing as form};
use subcert::claim::Paper;
use subcert::report::{Grid, Sheet};

/// A claim of a paper.
pub(crate) struct Listed<'a> {
    /// Its id within the paper.
    pub(crate) id: &'a str,
    kind: &'static str,
    locus: &'a str,
    title: &'a str,
}

impl Listed<'_> {
    /// Every claim of a paper, in the order of an audit.
    pub(crate) fn all(paper: &Paper) -> Vec<Listed<'_>> {
        macro_rules! of {
            ($kind:literal, $claims:expr) => {
                $claims.iter().map(|claim| Listed {
                    id: &claim.id,
                    kind: $kind,
                    locus: &claim.locus,
                    title: &claim.title,
                })
            };
        }
        of!("table", paper.tables)
            .chain(of!("equation", paper.equations))
            .chain(of!("function", paper.functions))
            .chain(of!("range", paper.ranges))
            .chain(paper.smoothness.iter().map(|claim| Listed {
                id: &claim.id,
                kind: claim.kind.name(),
                locus: &claim.locus,
                title: &claim.title,
            }))
            .chain(of!("theorem", paper.theorems))
            .collect()
    }
}

/// Writes what `subcert explain` can explain of a paper.
pub(crate) fn listing(paper: &Paper, to: &Output) -> Outcome {
    let claims = Listed::all(paper);
    show(
        to,
        || sheet(paper, &claims),
        || form::Listing {
            schema: SCHEMA,
            key: &paper.key,
            claims: claims.iter().map(claim_form).collect(),
        },
    )
}

fn sheet(paper: &Paper, claims: &[Listed<'_>]) -> Sheet {
    let mut sheet = Sheet::default();
    sheet.heading(1, format!("{} · {}", paper.key, paper.bibliography.short()));
    let row = |listed: &Listed<'_>| {
        [listed.id, listed.kind, listed.locus, listed.title].map(str::to_owned).to_vec()
    };
    let header = ["id", "kind", "where", "what"].map(str::to_owned).to_vec();
    sheet.grid(Grid { header, rows: claims.iter().map(row).collect(), left_columns: 4 });
    let key = &paper.key;
    sheet.text(format!(
        "`subcert explain {key}:ID` explains one claim, `subcert explain {key}:ID:ROW:COLUMN` one \
         cell of a table; rows and columns are counted from 1."
    ));
    sheet
}

fn claim_form<'a>(listed: &Listed<'a>) -> form::Claim<'a> {
    let Listed { id, kind, locus, title } = *listed;
    form::Claim { id, kind, locus, title }
}
