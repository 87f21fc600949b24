//! `subcert explain`.

use super::arguments::{ExplainArguments, Format};
use super::listing::{Listed, listing};
use super::output::{Failure, Outcome, show};
use super::papers::{judge_all, papers, select};
use subcert::audit::{by_hand, readings};
use subcert::claim::{Paper, Table};
use subcert::report::json::Explained;
use subcert::report::{explain_sheet, table_of};
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
    let audits = judge_all(&chosen, arguments.output.format != Format::Json)?;
    let tried = match (audits.first(), table_of(&audits, id)) {
        (Some(audit), Some((finding, at))) => {
            let kind = at.map(|(row, column)| finding.cells[row][column].kind());
            let kind = kind.or_else(|| finding.kinds().first().copied());
            kind.map_or(Ok(Vec::new()), |kind| readings(audit.paper, finding, kind))?
        }
        _ => Vec::new(),
    };
    let theorems = audits.iter().flat_map(|audit| audit.theorems.iter().map(move |it| (audit, it)));
    let hand = match { theorems }.find(|(_, finding)| finding.id == *id) {
        Some((audit, finding)) => by_hand(audit, finding)?,
        None => None,
    };
    let hand = hand.as_ref();
    let sheet = explain_sheet(&audits, id, &tried, hand, arguments.all)
        .ok_or_else(|| Failure::Input(format!("no claim has the id `{id}`")))?;
    show(arguments.output.format, || sheet, || Explained::of(&audits, id, &tried, hand))
}

/// Makes sure that the paper has this claim, before all of its claims are judged.
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
