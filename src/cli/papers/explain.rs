//! `subcert explain`.

use super::claim_files::{Claims, claims};
use super::judged::{files_of, judge_claim, select};
use super::listing::Listing;
use super::projects;
use crate::cli::arguments::{ExplainArguments, FindingFormat};
use crate::cli::console::answer::{Answer, deliver, show};
use crate::cli::console::destination::Destination;
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::console::quantity::written;
use std::path::PathBuf;
use subcert::audit::{self, Finding, PaperAudit, by_hand, readings};
use subcert::claim::{Claim, Paper, RegularityCell, Target};
use subcert::report::html::explain_page;
use subcert::report::json::Explained;
use subcert::report::{Background, Sheet, corrected_table, explain_sheet, table_of, to_the_eye};
use subcert::suggestion::did_you_mean;

pub(crate) fn explain(arguments: &ExplainArguments) -> Outcome {
    check_order(arguments)?;
    let papers = match claims(&arguments.files)? {
        Claims::Papers(papers) => papers,
        Claims::Projects(projects) => return projects::explain(arguments, projects),
    };
    let id = &whole_id(&arguments.id, &arguments.files, &papers);
    let mut target = Target::of(id);
    let key = target.key;
    let chosen = select(papers, Some(key))?;
    let [paper] = &chosen[..] else { return Ok(()) };
    if target.names_paper() {
        return list(paper, arguments);
    }
    if let Some(claim) = cell_of_smoothness(paper, target) {
        target = Target { key, claim, part: None };
    }
    check(paper, target, &arguments.files)?;
    let id = &target.to_string();
    let to = Destination::of(&arguments.output, &id.replace(':', "."))?;
    let bar = arguments.output.format != FindingFormat::Json;
    let audits = [judge_claim(paper, target.claim, bar)?];
    let audit = &audits[0];
    let (mut tried, mut working, mut eye) = (Vec::new(), None, None);
    if let Some((finding, at)) = table_of(&audits, id) {
        let kind = at.map(|(row, column)| finding.cells[row][column].kind());
        if let Some(kind) = kind.or_else(|| finding.kinds().first().copied()) {
            tried = readings(audit.paper, finding, kind)?;
        }
        working = at.map(|at| audit::working(audit, finding, at)).transpose()?;
        eye = at.map(|at| to_the_eye(audit.paper, finding, at)).transpose()?.flatten();
    }
    let by_hand = match audit.find(target) {
        Some(Finding::Theorem(finding)) => by_hand(audit, finding)?,
        _ => None,
    };
    let background = Background {
        readings: &tried,
        by_hand: by_hand.as_ref(),
        working: working.as_ref(),
        eye: eye.as_ref(),
    };
    let all = arguments.all;
    let sheet = explain_sheet(&audits, id, background, all).ok_or_else(|| no_claim(id))?;
    let source = &paper.source.name;
    let file = (!arguments.files.is_empty()).then_some(source.as_str());
    deliver(&to, &Explanation { audits: &audits, id, background, all, file, sheet })
}

fn no_claim(id: &str) -> Failure {
    Failure::Input(format!("no claim has the id `{id}`"))
}

/// A claim in full.
pub(crate) struct Explanation<'a> {
    /// Its paper.
    audits: &'a [PaperAudit<'a>; 1],
    id: &'a str,
    background: Background<'a>,
    /// Whether every reading is shown.
    all: bool,
    /// The claim file, unless it is embedded.
    file: Option<&'a str>,
    sheet: Sheet,
}

written!(this: Explanation<'_> => Explained<'_>, Explained::of(this.audits, this.id, this.background));

impl Answer for Explanation<'_> {
    const NAME: &'static str = "explain";

    fn sheet(&self) -> Sheet {
        self.sheet.clone()
    }

    /// Of a table, the table with its exact values.
    fn latex(&self) -> String {
        match table_of(self.audits, self.id) {
            Some((finding, None)) => corrected_table(finding),
            _ => self.sheet.to_latex(),
        }
    }

    fn page(&self) -> Result<String, Failure> {
        let Explanation { audits: [audit], id, background, all, file, .. } = *self;
        explain_page(audit, id, background, all, file)?.ok_or_else(|| no_claim(id))
    }
}

/// The id with the key of its paper: where the files have one paper, the key may be left out.
fn whole_id(id: &str, files: &[PathBuf], papers: &[Paper]) -> String {
    match papers {
        [paper] if !files.is_empty() => {
            let Target { key: first, .. } = Target::of(id);
            let is_claim = paper.claim(first).is_some()
                || paper.smoothness.iter().any(|claim| claim.is_cell_of(first));
            let bare = first != paper.key && (is_claim || !id.contains(':'));
            if bare { format!("{}:{id}", paper.key) } else { id.to_owned() }
        }
        _ => id.to_owned(),
    }
}

/// Refuses a claim file in the place of the claim.
fn check_order(arguments: &ExplainArguments) -> Outcome {
    let ExplainArguments { id, files, .. } = arguments;
    let is_file = |name: &str| std::path::Path::new(name).is_file();
    match &files[..] {
        [other] if is_file(id) && !other.exists() => {
            let other = other.display();
            Err(Failure::Input(format!(
                "the claim stands before its file: subcert explain {other} {id}"
            )))
        }
        [] if is_file(id) => Err(Failure::Input(format!(
            "`{id}` is a file: write the claim before it, as in subcert explain KEY:CLAIM {id}"
        ))),
        _ => Ok(()),
    }
}

/// Lists the claims of a paper.
fn list(paper: &Paper, arguments: &ExplainArguments) -> Outcome {
    match Destination::of(&arguments.output, &paper.key)? {
        Destination::Output(to) => {
            show(&to, &Listing::of_paper(paper, files_of(paper, &arguments.files)))
        }
        _ => Err(Failure::Input(format!(
            "a list of claims is no page; name a claim, or write the pages of all of them with \
             `subcert audit --paper {} --format html -o DIR`",
            paper.key
        ))),
    }
}

/// The id of the claim that is this cell of a table of smoothness: of `table-1:2:1`, `table-1.2.order`.
fn cell_of_smoothness<'a>(paper: &'a Paper, target: Target<'_>) -> Option<&'a str> {
    let at = target.cell()?;
    let is_at = |cell: &RegularityCell| at == (cell.row, cell.column);
    let found = paper
        .smoothness
        .iter()
        .find(|claim| claim.is_cell_of(target.claim) && claim.cell.as_ref().is_some_and(is_at))?;
    Some(&found.id)
}

/// Checks that the paper has this claim, before all of its claims are judged.
fn check(paper: &Paper, target: Target<'_>, files: &[PathBuf]) -> Outcome {
    let (key, name) = (&paper.key, target.claim);
    let file = files_of(paper, files);
    if paper.smoothness.iter().any(|claim| claim.is_cell_of(name)) {
        return target.part.map_or(Ok(()), |cell| {
            Err(Failure::Input(format!(
                "`{key}:{name}` has no statement in a cell `{cell}`; `subcert explain {key}:{name}{file}` has all of them"
            )))
        });
    }
    let Some(claim) = paper.claim(name) else {
        let meant = did_you_mean(name, paper.claims().map(Claim::id));
        return Err(Failure::Input(format!(
            "`{key}` has no claim `{name}`; `subcert explain {key}{file}` lists its claims{meant}"
        )));
    };
    let Some(cell) = target.part else { return Ok(()) };
    let Claim::Table(table) = claim else {
        return Err(Failure::Input(format!("`{key}:{name}` is no table, and has no cells")));
    };
    let (rows, columns) = (table.cells.len(), table.columns.entries.len());
    if target.cell().is_some_and(|(row, column)| row < rows && column < columns) {
        return Ok(());
    }
    Err(Failure::Input(format!(
        "`{key}:{name}` has no cell `{cell}`: write {key}:{name}:ROW:COLUMN, with a row from 1 to \
         {rows} and a column from 1 to {columns}"
    )))
}
