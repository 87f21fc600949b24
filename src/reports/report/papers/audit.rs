//! The report of an audit: what is wrong first.

use super::consistency;
use super::overview::overview;
use crate::audit::{CellFinding, Direction, PaperAudit, TableFinding, Verdict, Word};
use crate::claim::Kind;
use crate::exact::{Rational, RealCyclotomic, format::raised_digits, format::short};
use crate::report::smooth::regularity;
use crate::report::tables::headers;
use crate::report::tables::promise;
use crate::report::tables::reading;
use crate::report::told::{Told, told};
use crate::report::words::kernel;
use crate::report::words::parts::titled;
use crate::report::words::sheet::{Grid, Sheet};

/// The most single cells or cases that a list names.
const MAX_LISTED: usize = 4;

/// The report of several papers: a summary, then what is wrong, table by table in
/// the table's own shape; with `all`, every table and equation.
#[must_use]
pub fn audit_sheet(audits: &[PaperAudit<'_>], all: bool) -> Sheet {
    let mut sheet = Sheet::default();
    overview(&mut sheet, audits);
    for audit in audits {
        paper(&mut sheet, audit, all);
    }
    sheet
}

fn paper(sheet: &mut Sheet, audit: &PaperAudit<'_>, all: bool) {
    let paper = audit.paper;
    sheet.heading(1, format!("{} · {}", paper.key, paper.bibliography.short()));
    sheet.text(paper.bibliography.title_and_venue());
    if let Some(note) = &paper.bibliography.note {
        sheet.text(note.clone());
    }
    let (unclear, judged): (Vec<_>, Vec<_>) =
        audit.tables.iter().partition(|table| is_unclear(table));
    let (wrong, right): (Vec<_>, Vec<_>) = judged.into_iter().partition(|table| is_wrong(table));
    for table in if all { audit.tables.iter().collect() } else { wrong } {
        one_table(sheet, audit, table);
    }
    if !all {
        let named = |tables: &[&TableFinding<'_>]| {
            tables.iter().map(|table| table.table.locus.clone()).collect::<Vec<String>>().join(", ")
        };
        if !right.is_empty() {
            sheet.heading(2, "Nothing wrong");
            sheet.text(format!("✓ {}", named(&right)));
        }
        if !unclear.is_empty() {
            sheet.heading(2, "Not checkable");
            sheet.grid(unclear_grid(&unclear));
        }
    }
    for kind in Kind::ALL.iter().filter(|kind| **kind != Kind::Table) {
        section(sheet, audit, *kind, all);
    }
    consistency::section(sheet, audit);
    super::summary::section(sheet, audit);
}

/// The claims of a kind; without `all`, those of which something is wrong.
fn section(sheet: &mut Sheet, audit: &PaperAudit<'_>, kind: Kind, all: bool) {
    let findings = audit.findings().filter(|finding| finding.claim().kind() == kind).map(told);
    let shown: Vec<&dyn Told<'_>> = findings.filter(|finding| all || finding.is_shown()).collect();
    let fact = |finding: &&dyn Told<'_>| {
        let claim = finding.claim();
        let lines = [vec![titled(&[claim.title(), claim.id()])], finding.remarks()].concat();
        (format!("{} {}", finding.word().mark(), claim.locus()), lines.join("\n"))
    };
    for group in shown.chunk_by(|one, next| one.heading() == next.heading()) {
        sheet.heading(2, group[0].heading()[0]);
        if kind == Kind::Smoothness {
            regularity::section(sheet, audit, all);
        }
        sheet.facts(group.iter().map(fact).collect());
    }
}

fn is_unclear(table: &TableFinding<'_>) -> bool {
    let mut cells = cells(table).peekable();
    cells.peek().is_some() && cells.all(|cell| matches!(cell.verdict, Verdict::NotCheckable(_)))
}

fn is_wrong(table: &TableFinding<'_>) -> bool {
    cells(table).any(|cell| cell.verdict != Verdict::Confirmed)
}

fn cells<'t>(table: &'t TableFinding<'_>) -> impl Iterator<Item = &'t CellFinding> {
    table.claiming()
}

fn one_table(sheet: &mut Sheet, audit: &PaperAudit<'_>, finding: &TableFinding<'_>) {
    let table = finding.table;
    sheet.heading(2, titled(&[&table.locus, &table.title, &table.id]));
    let mut facts = Vec::new();
    facts.extend(headers::schemes(table));
    facts.push(("said to equal".to_owned(), spelled_out(audit, &table.value.text)));
    sheet.facts(facts);
    sheet.grid(table_values(finding));
    for line in remarks(finding) {
        sheet.text(line);
    }
    if let Some(note) = &table.note {
        sheet.text(note.clone());
    }
}

/// A formula; if it is only the name of a definition, with the definition's formula beside it.
pub(crate) fn spelled_out(audit: &PaperAudit<'_>, formula: &str) -> String {
    match audit.paper.definitions.get(formula) {
        Some(definition) => format!("{formula} = {}", definition.text),
        None => formula.to_owned(),
    }
}

/// A table in its own shape: each cell as printed with its mark; below it, the
/// exact value of the definition unless the cell is confirmed, and the sound
/// value where there is a promise that is broken or open.
#[must_use]
pub fn table_values(finding: &TableFinding<'_>) -> Grid {
    let table = finding.table;
    let columns = table.columns.entries.iter().map(|entry| entry.printed.clone());
    let corner = match &table.rows {
        Some(rows) => format!("{} \\ {}", rows.label, table.columns.label),
        None => table.columns.label.clone(),
    };
    let header = std::iter::once(corner).chain(columns);
    let rows = finding.cells.iter().enumerate().map(|(row, cells)| {
        let label = table.rows.as_ref().map(|rows| rows.entries[row].printed.clone());
        let label = label.unwrap_or_default();
        let cells = cells.iter().map(|cell| cell_text(cell, table.promise.is_some()));
        std::iter::once(label).chain(cells).collect()
    });
    Grid::of(header, rows, 1)
}

fn cell_text(cell: &CellFinding, promised: bool) -> String {
    let printed = cell.shown();
    // A cell that another reading reproduces gets a second mark: the value below it is that of the
    // printed definition.
    let otherwise = cell.verdict == Verdict::Reproduced && cell.as_read.is_some();
    let otherwise = if otherwise { Word::OtherReading.mark() } else { "" };
    if cell.is_blank() {
        return printed.to_owned();
    }
    let mut lines = vec![format!("{printed} {}{otherwise}", cell.verdict.word().mark())];
    lines.extend(below(cell, promised));
    lines.join("\n")
}

/// What stands below a cell: the exact value of the definition unless the cell is confirmed, and the sound value where a
/// promise is broken or open. What is `promised` is rounded up.
pub(crate) fn below(cell: &CellFinding, promised: bool) -> Vec<String> {
    let mut lines = Vec::new();
    if cell.verdict != Verdict::Confirmed {
        match (&cell.exact, &cell.undefined) {
            (Some(exact), _) => lines.push(beside(exact, digits_beside(cell), promised)),
            (None, Some(_)) => lines.push("no value".to_owned()),
            (None, None) => {}
        }
    }
    lines.extend(promise::line(cell));
    lines
}

/// The value below a cell; of a number that promises something it is rounded up.
fn beside(exact: &RealCyclotomic, digits: u32, promised: bool) -> String {
    if promised { short(&raised_digits(exact, digits), digits) } else { short(exact, digits) }
}

/// As many digits as the printed text has, but from 4 to 12; 6 where nothing is printed.
fn digits_beside(cell: &CellFinding) -> u32 {
    let digits = |text: &String| text.chars().filter(char::is_ascii_digit).count();
    let digits = cell.printed.as_ref().map_or(6, digits);
    u32::try_from(digits.clamp(4, 12)).unwrap_or(12)
}

/// The remarks below a table: the slips, how damaged text is read, why a value is missing, the
/// assumptions, how many promises are kept, and what Coq checks.
pub(crate) fn remarks(finding: &TableFinding<'_>) -> Vec<String> {
    let mut lines = Vec::new();
    let listed = |word: Word, what: &dyn Fn(&CellFinding) -> Option<String>| {
        let mut all: Vec<String> = cells(finding).filter_map(what).collect();
        let more = all.len().saturating_sub(MAX_LISTED);
        all.truncate(MAX_LISTED);
        let more = if more > 0 { format!("; and {more} more") } else { String::new() };
        (!all.is_empty()).then(|| format!("{} {word}: {}{more}.", word.mark(), all.join("; ")))
    };
    lines.extend(listed(Word::Misprint, &|cell| match &cell.verdict {
        Verdict::Misprint(slip) => Some(format!("{} ({slip})", cell.printed.as_deref()?)),
        _ => None,
    }));
    lines.extend(listed(Word::Rounding, &|cell| match &cell.verdict {
        Verdict::Rounding(direction) => Some(format!("{} ({direction})", cell.printed.as_deref()?)),
        _ => None,
    }));
    lines.extend(reading::recovered(finding));
    for search in finding.searches() {
        lines.push(reading::remark(search));
        lines.extend(reading::line_remarks(finding.table, search));
    }
    lines.extend(finding.table.axes().flat_map(headers::notes));
    lines.extend(cells(finding).filter_map(|cell| {
        let (printed, note) = (cell.printed.as_ref()?, cell.note.as_ref()?);
        Some(format!("The cell {printed}: {note}."))
    }));
    if let Some(cell) = cells(finding).find(|cell| cell.undefined.is_some()) {
        let why = cell.undefined.as_deref().unwrap_or_default();
        lines.push(format!("No value at {}: {why}.", cell.locus));
    }
    lines.extend(assumption(finding));
    lines.extend(promise::remarks(finding));
    lines.extend(kernel::remark(finding));
    lines
}

fn assumption(finding: &TableFinding<'_>) -> Option<String> {
    let unclear = |cell: &&CellFinding| matches!(cell.verdict, Verdict::NotCheckable(_));
    let cell = cells(finding).filter(unclear).find(|cell| !cell.is_plain())?;
    let Verdict::NotCheckable(missing) = &cell.verdict else { return None };
    if let Some(name) = &cell.unknown {
        return Some(format!("? {missing}, and no table gives {name}."));
    }
    let comparison = comparison(finding).map(|text| format!(": {text}")).unwrap_or_default();
    let slips = cells(finding).filter_map(|cell| match &cell.verdict_if_assumed {
        Some(Verdict::Misprint(slip)) => Some(format!("{} ({slip})", cell.printed.as_deref()?)),
        _ => None,
    });
    let slips: Vec<String> = slips.take(MAX_LISTED).collect();
    let slips = if slips.is_empty() { String::new() } else { format!(" {}.", slips.join("; ")) };
    Some(format!("? {missing}. What is left, at {}{comparison}.{slips}", assumed(cell)))
}

/// How many cells have which verdict at the assumed values, in words.
fn comparison(finding: &TableFinding<'_>) -> Option<String> {
    let count = |of: &dyn Fn(&Verdict) -> bool| {
        cells(finding).filter_map(|cell| cell.verdict_if_assumed.as_ref()).filter(|v| of(v)).count()
    };
    let all = count(&|_| true);
    let parts = [
        ("equal", count(&|verdict| *verdict == Verdict::Confirmed)),
        ("a level short", count(&|v| *v == Verdict::Rounding(Direction::DepthDown))),
        (
            "rounded differently",
            count(&|v| matches!(v, Verdict::Rounding(d) if *d != Direction::DepthDown)),
        ),
        ("by another reading", count(&|verdict| *verdict == Verdict::OtherReading)),
        ("one slip away", count(&|verdict| matches!(verdict, Verdict::Misprint(_)))),
        ("different", count(&|verdict| *verdict == Verdict::Refuted)),
        ("not computed", count(&|verdict| matches!(verdict, Verdict::NotCheckable(_)))),
    ];
    let parts: Vec<String> = parts
        .iter()
        .filter(|(_, count)| *count > 0)
        .map(
            |(name, count)| {
                if *count == all { format!("all {name}") } else { format!("{count} {name}") }
            },
        )
        .collect();
    (all > 0).then(|| parts.join(", "))
}

/// The values that were put in for parameters that the paper does not state.
pub(crate) fn assumed(cell: &CellFinding) -> String {
    let value = |(name, value): &(String, Rational)| format!("{name} = {value}");
    cell.assumed.iter().map(value).collect::<Vec<String>>().join(", ")
}

fn unclear_grid(tables: &[&TableFinding<'_>]) -> Grid {
    let rows = tables.iter().map(|finding| {
        let count = cells(finding).count();
        let first = cells(finding).next();
        let names = first.into_iter().flat_map(|cell| {
            cell.assumed.iter().map(|(name, _)| name.as_str()).chain(cell.unknown.as_deref())
        });
        let names = names.collect::<Vec<&str>>().join(", ");
        let mut missing = Vec::new();
        if !names.is_empty() {
            missing.push(format!("{names} not stated"));
        }
        missing.extend(finding.fitting.as_ref().map(|fitting| reading::fitting(fitting, count)));
        if cells(finding).any(|cell| cell.printed.is_none()) {
            missing.push("the cells are lost".to_owned());
        }
        if missing.is_empty() {
            missing.push("beyond the program's caps".to_owned());
        }
        let shown = first.map(assumed).unwrap_or_default();
        let comparison = comparison(finding).unwrap_or_else(|| {
            let value = |cell: &CellFinding| cell.exact.as_ref().map(|exact| short(exact, 6));
            cells(finding).filter_map(value).collect::<Vec<String>>().join("  ")
        });
        let kept = match finding.promise_counts() {
            counts if counts.all() == 0 => "·".to_owned(),
            counts => promise::count(counts),
        };
        let at = if shown.is_empty() { "·".to_owned() } else { shown };
        let missing = missing.join("; ");
        let table = titled(&[&finding.table.locus, &finding.table.id]);
        vec![table, count.to_string(), missing, at, comparison, kept]
    });
    let header = ["table", "cells", "missing", "shown at", "printed against exact", "promise"];
    Grid::of(header, rows, 5)
}
