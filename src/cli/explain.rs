//! `subcert explain`.

use super::arguments::{ExplainArguments, Format};
use super::listing::{Listed, listing};
use super::output::{Failure, Outcome, show};
use super::papers::{judge_claim, papers, select};
use subcert::audit::{self, by_hand, readings};
use subcert::claim::{Paper, Table};
use subcert::report::json::Explained;
use subcert::report::{Background, explain_sheet, table_of};
use subcert::suggestion::did_you_mean;

pub(super) fn explain(arguments: &ExplainArguments) -> Outcome {
    let id = &arguments.id;
    let (key, claim) = match id.split_once(':') {
        Some((key, claim)) => (key, claim),
        None => (id.as_str(), ""),
    };
    let chosen = select(papers(&arguments.files)?, Some(key))?;
    let [paper] = &chosen[..] else { return Ok(()) };
    if claim.is_empty() {
        return listing(paper, arguments.output.format);
    }
    check(paper, claim)?;
    let name = claim.split(':').next().unwrap_or(claim);
    let bar = arguments.output.format != Format::Json;
    let audits = [judge_claim(paper, name, bar)?];
    let audit = &audits[0];
    let (mut tried, mut working) = (Vec::new(), None);
    if let Some((finding, at)) = table_of(&audits, id) {
        let kind = at.map(|(row, column)| finding.cells[row][column].kind());
        if let Some(kind) = kind.or_else(|| finding.kinds().first().copied()) {
            tried = readings(audit.paper, finding, kind)?;
        }
        working = at.map(|at| audit::working(audit, finding, at)).transpose()?;
    }
    let by_hand = match audit.theorems.iter().find(|finding| finding.id == *id) {
        Some(finding) => by_hand(audit, finding)?,
        None => None,
    };
    let background =
        Background { readings: &tried, by_hand: by_hand.as_ref(), working: working.as_ref() };
    let sheet = explain_sheet(&audits, id, background, arguments.all)
        .ok_or_else(|| Failure::Input(format!("no claim has the id `{id}`")))?;
    show(arguments.output.format, || sheet, || Explained::of(&audits, id, background))
}

/// Checks that the paper has this claim, before all of its claims are judged.
fn check(paper: &Paper, claim: &str) -> Outcome {
    let key = &paper.key;
    let (name, cell) = match claim.split_once(':') {
        Some((name, cell)) => (name, Some(cell)),
        None => (claim, None),
    };
    let claims = Listed::all(paper);
    if !claims.iter().any(|listed| listed.id == name) {
        let meant = did_you_mean(name, claims.iter().map(|listed| listed.id));
        return Err(Failure::Input(format!(
            "`{key}` has no claim `{name}`{meant}; `subcert explain {key}` lists its claims"
        )));
    }
    let Some(cell) = cell else { return Ok(()) };
    let Some(table) = paper.tables.iter().find(|table| table.id == name) else {
        return Err(Failure::Input(format!("`{key}:{name}` is no table, and has no cells")));
    };
    if has_cell(table, cell) {
        return Ok(());
    }
    let (rows, columns) = (table.cells.len(), table.columns.entries.len());
    Err(Failure::Input(format!(
        "`{key}:{name}` has no cell `{cell}`: write {key}:{name}:ROW:COLUMN, with a row from 1 to \
         {rows} and a column from 1 to {columns}"
    )))
}

/// Whether `cell` is a row and a column of the table.
fn has_cell(table: &Table, cell: &str) -> bool {
    let within = |text: &str, count: usize| {
        text.parse::<usize>().is_ok_and(|number| (1..=count).contains(&number))
    };
    cell.split_once(':').is_some_and(|(row, column)| {
        within(row, table.cells.len()) && within(column, table.columns.entries.len())
    })
}
