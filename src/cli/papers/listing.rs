//! The claims of a claim file, without their verdicts.

use crate::cli::console::answer::{Answer, SCHEMA};
use serde::Serialize;
use subcert::claim::{self, Paper};
use subcert::report::{Grid, Sheet};
use subcert::shipped::{Project, ShippedClaim};

/// The claims of a paper.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Listing<'a> {
    /// The version of this form.
    schema: u32,
    /// The paper's key.
    key: &'a str,
    /// Its claims.
    claims: Vec<Claim<'a>>,
    /// Whether they are constants that a program ships.
    #[serde(skip)]
    is_program: bool,
    /// What they are from.
    #[serde(skip)]
    source: String,
    /// How they are explained.
    #[serde(skip)]
    note: String,
}

/// A claim that can be explained.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Claim<'a> {
    /// Its id within the paper.
    id: &'a str,
    /// `table`, `equation`, `function`, `range`, `smoothness`, `exponent` or `theorem`; `shipped` in a program.
    kind: &'static str,
    /// Where in the paper it is.
    locus: &'a str,
    /// What it is.
    title: &'a str,
    /// How many numbers of a program it has.
    #[serde(skip)]
    numbers: usize,
}

impl<'a> Listing<'a> {
    pub(crate) fn of_paper(paper: &'a Paper) -> Listing<'a> {
        let key = &paper.key;
        let kind = |claim| match claim {
            claim::Claim::Smoothness(claim) => claim.kind.name(),
            other => other.kind().name(),
        };
        let claim = |claim: claim::Claim<'a>| Claim {
            id: claim.id(),
            kind: kind(claim),
            locus: claim.locus(),
            title: claim.title(),
            numbers: 0,
        };
        let note = format!(
            "`subcert explain {key}:ID` explains one claim, `subcert explain {key}:ID:ROW:COLUMN` one \
             cell of a table; rows and columns are counted from 1."
        );
        let claims = paper.claims().map(claim).collect();
        Listing {
            schema: SCHEMA,
            key,
            claims,
            is_program: false,
            source: paper.bibliography.short(),
            note,
        }
    }

    pub(crate) fn of_project(project: &'a Project) -> Listing<'a> {
        let key = &project.key;
        let claim = |claim: &'a ShippedClaim| Claim {
            id: &claim.id,
            kind: "shipped",
            locus: &claim.locus,
            title: &claim.title,
            numbers: claim.numbers.len(),
        };
        let file = &project.source.name;
        let note = format!("`subcert explain {key}:ID {file}` shows every number of one table.");
        let claims = project.shipped.iter().map(claim).collect();
        Listing {
            schema: SCHEMA,
            key,
            claims,
            is_program: true,
            source: project.name.clone(),
            note,
        }
    }
}

impl Answer for Listing<'_> {
    const NAME: &'static str = "explain-list";

    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::titled(format!("{} · {}", self.key, self.source));
        let row = |claim: &Claim<'_>| {
            let Claim { id, kind, locus, title, numbers } = *claim;
            let numbers = &*numbers.to_string();
            let row = if self.is_program {
                [id, locus, title, numbers]
            } else {
                [id, kind, locus, title]
            };
            row.map(str::to_owned).to_vec()
        };
        let (header, left_columns) = if self.is_program {
            (["id", "where", "what", "numbers"], 3)
        } else {
            (["id", "kind", "where", "what"], 4)
        };
        sheet.grid(Grid::of(header, self.claims.iter().map(row), left_columns));
        sheet.text(self.note.clone());
        sheet
    }
}
