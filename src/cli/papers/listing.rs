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
    /// What they are from.
    #[serde(skip)]
    source: Source<'a>,
}

enum Source<'a> {
    Paper(&'a Paper, String),
    Project(&'a Project),
}

/// A claim that can be explained.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Claim<'a> {
    /// Its id within the paper.
    id: &'a str,
    /// `table`, `equation`, `relation`, `function`, `range`, `smoothness`, `exponent` or `theorem`; `shipped` in a program.
    kind: &'static str,
    /// Where in the paper it is.
    locus: &'a str,
    /// What it is.
    title: &'a str,
}

impl<'a> Listing<'a> {
    /// The claims of a paper, whose claim file stands in `file` unless it is embedded: ` FILE`.
    pub(crate) fn of_paper(paper: &'a Paper, file: String) -> Listing<'a> {
        let kind = |claim| match claim {
            claim::Claim::Smoothness(claim) => claim.kind.name(),
            claim::Claim::Equation(claim) => claim.kind(),
            other => other.kind().name(),
        };
        let claim = |one: claim::Claim<'a>| Claim {
            id: one.id(),
            kind: kind(one),
            locus: one.locus(),
            title: one.title(),
        };
        let claims = paper.claims().map(claim).collect();
        Listing { schema: SCHEMA, key: &paper.key, claims, source: Source::Paper(paper, file) }
    }

    pub(crate) fn of_project(project: &'a Project) -> Listing<'a> {
        let claim = |ShippedClaim { id, locus, title, .. }: &'a ShippedClaim| Claim {
            id,
            kind: "shipped",
            locus,
            title,
        };
        let claims = project.shipped.iter().map(claim).collect();
        Listing { schema: SCHEMA, key: &project.key, claims, source: Source::Project(project) }
    }
}

impl Answer for Listing<'_> {
    const NAME: &'static str = "explain-list";

    fn sheet(&self) -> Sheet {
        let (key, claims) = (self.key, self.claims.iter());
        let row = |texts: [&str; 4]| texts.map(str::to_owned).to_vec();
        let (name, grid, note) = match &self.source {
            Source::Paper(paper, file) => {
                let rows = claims.map(|one| row([one.id, one.kind, one.locus, one.title]));
                let note = format!(
                    "`subcert explain {key}:ID{file}` explains one claim, `subcert explain {key}:ID:ROW:COLUMN{file}` one \
                     cell of a table; rows and columns are counted from 1."
                );
                let grid = Grid::of(["id", "kind", "where", "what"], rows, 4);
                (paper.bibliography.short(), grid, note)
            }
            Source::Project(Project { name, shipped, source, .. }) => {
                let counts = shipped.iter().map(|claim| claim.numbers.len().to_string());
                let rows = claims.zip(counts);
                let rows = rows.map(|(one, count)| row([one.id, one.locus, one.title, &count]));
                let file = &source.name;
                let note =
                    format!("`subcert explain {key}:ID {file}` shows every number of one table.");
                (name.clone(), Grid::of(["id", "where", "what", "numbers"], rows, 3), note)
            }
        };
        let mut sheet = Sheet::titled(format!("{key} · {name}"));
        sheet.grid(grid);
        sheet.text(note);
        sheet
    }
}
