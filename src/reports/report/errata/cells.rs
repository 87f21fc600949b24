//! Wrong cells, and those that could not be checked.

use crate::audit::{
    Cause, CellErratum, CellFinding, CellStanding, Errata, Sound, Subject, TableFinding, Verdict,
    Word,
};
use crate::claim::{Printed, Table};
use crate::exact::{
    RealCyclotomic,
    format::{fixed, raised, raised_digits, scientific, short},
};
use crate::report::papers::audit::{assumed, spelled_out};
use crate::report::papers::summary::words;
use crate::report::tables::reading;
use crate::report::words::sheet::{Grid, Sheet};
use std::collections::BTreeSet;

/// The formula of the table, its title, and the number of the cells.
pub(super) fn facts(cells: &CellErratum<'_, '_>) -> Vec<(String, String)> {
    let table = cells.finding.table;
    let mut facts = vec![("said to equal".to_owned(), table.value.text.clone())];
    if !table.title.is_empty() {
        facts.insert(0, ("shows".to_owned(), table.title.clone()));
    }
    facts.push(("cells".to_owned(), cells.cells.len().to_string()));
    facts
}

/// How the cells came about: a rounding, a reading, a slip, or not explained.
pub(crate) fn origin(cells: &CellErratum<'_, '_>) -> String {
    let cause = cells.outcome.cause.as_ref().map(Cause::to_string).unwrap_or_default();
    if cells.as_defined {
        let values = if cause.is_empty() { cause } else { format!(" {cause}") };
        let rounded_down = |cell: &CellFinding| cell.kept_by_formula == Some(false);
        return if cells.findings().all(rounded_down) {
            format!("the definition's value{values}, rounded down: less than the bound itself")
        } else {
            format!("as defined{values}, but the definition's value is not enough")
        };
    }
    match cells.outcome.standing {
        CellStanding::Reproduced => reproduced(cells),
        CellStanding::Explained if cells.findings().any(|cell| cell.as_read.is_some()) => {
            let table = cells.finding.table;
            let evidence = |search| reading::evidence(table, search, &cells.findings());
            let evidence = cells.finding.searches().map(evidence).filter(|text| !text.is_empty());
            format!("read differently: {cause}\n{}", evidence.collect::<Vec<String>>().join("\n"))
        }
        CellStanding::Confirmed | CellStanding::NotCheckable | CellStanding::Explained => cause,
        CellStanding::Misprinted => {
            let slip = |cell: &CellFinding| match &cell.verdict {
                Verdict::Misprint(slip) => Some(format!("{} ({slip})", cell.printed.as_deref()?)),
                _ => None,
            };
            let slips: Vec<String> = cells.findings().filter_map(slip).collect();
            format!("slips, {cause}: {}", slips.join("; "))
        }
        CellStanding::Refuted => {
            let undefined = if cause.is_empty() { cause } else { format!(" no value: {cause}.") };
            // Only a cell that needs no assumption is refuted.
            let search = cells.finding.search.as_ref();
            let covered = search.map(reading::covered).unwrap_or_default();
            format!("not explained.{undefined} {covered}")
        }
    }
}

/// The values at which the cells are reproduced, and how likely luck is.
fn reproduced(cells: &CellErratum<'_, '_>) -> String {
    let cause = cells.outcome.cause.as_ref().map(Cause::to_string).unwrap_or_default();
    let table = cells.finding.table;
    let evidence = |search| reading::evidence(table, search, &cells.findings());
    let evidence = cells.finding.searches().map(evidence).filter(|text| !text.is_empty());
    let from = reading::recovered(cells.finding);
    let lines = std::iter::once(format!("reproduced {cause}")).chain(from).chain(evidence);
    lines.collect::<Vec<String>>().join("\n")
}

/// The cells in the shape of their table: printed and correct.
pub(super) fn grid(cells: &CellErratum<'_, '_>) -> Grid {
    let promised = cells.finding.table.promise.is_some();
    shaped(cells.finding, &cells.cells, |cell, printed| {
        let correct = if cells.as_defined {
            sound(cell)
        } else {
            correct(cell.exact.as_ref(), printed, promised)
        };
        format!("{} → {correct}", printed.text)
    })
}

/// The level or bound that keeps the promise.
pub(super) fn sound(cell: &CellFinding) -> String {
    match &cell.sound {
        Some(Sound::Depth { level, .. } | Sound::Least(level)) => level.to_string(),
        Some(Sound::Bound(bound)) => short(&raised_digits(bound, 6), 6),
        Some(Sound::None(_)) | None => "no sound value".to_owned(),
    }
}

/// An exact value in the form of the printed number: rounded to its last place or, if only zeros
/// remain, to as many digits. A number that promises something is rounded up: a smaller bound or level
/// would promise more than the definition.
pub(crate) fn correct(exact: Option<&RealCyclotomic>, printed: &Printed, promised: bool) -> String {
    let Some(exact) = exact else { return "no value".to_owned() };
    let digits = u32::try_from(printed.decimal.significant_digits()).unwrap_or(1).clamp(1, 40);
    let places = u32::try_from(-printed.decimal.exponent()).unwrap_or(0).min(60);
    let of_digits = |digits: u32| {
        if promised { raised_digits(exact, digits).into() } else { exact.clone() }
    };
    if printed.decimal.is_fraction() {
        return exact.as_rational().map_or_else(|| short(&of_digits(10), 10), ToString::to_string);
    }
    if printed.text.contains(['e', 'E']) {
        return scientific(&of_digits(digits), digits);
    }
    let text = fixed(exact, places);
    let shows = text.contains(|c: char| c.is_ascii_digit() && c != '0');
    match (shows || exact.sign() == 0, promised) {
        (true, true) => fixed(&raised(exact, places.cast_signed()), places),
        (true, false) => text,
        (false, _) => short(&of_digits(digits), digits),
    }
}

/// Some cells of a table in the table's shape; other cells are dots.
fn shaped(
    finding: &TableFinding<'_>,
    cells: &[(usize, usize)],
    text: impl Fn(&CellFinding, &Printed) -> String,
) -> Grid {
    let table = finding.table;
    let rows: BTreeSet<usize> = cells.iter().map(|&(row, _)| row).collect();
    let columns: BTreeSet<usize> = cells.iter().map(|&(_, column)| column).collect();
    let header = columns.iter().map(|&column| table.columns.entries[column].printed.clone());
    let header = std::iter::once(corner(table)).chain(header);
    let cell = |row: usize, column: usize| {
        let printed = table.cells[row][column].printed();
        match printed.filter(|_| cells.contains(&(row, column))) {
            Some(printed) => text(&finding.cells[row][column], printed),
            None => "·".to_owned(),
        }
    };
    let line = |&row: &usize| {
        let label = table.rows.as_ref().map(|rows| rows.entries[row].printed.clone());
        let cells = columns.iter().map(|&column| cell(row, column));
        std::iter::once(label.unwrap_or_default()).chain(cells).collect()
    };
    Grid::of(header, rows.iter().map(line), 1)
}

fn corner(table: &Table) -> String {
    match &table.rows {
        Some(rows) => format!("{} \\ {}", rows.label, table.columns.label),
        None => table.columns.label.clone(),
    }
}

/// The parameters that the paper does not state, with the values that were recovered.
pub(super) fn recovered(sheet: &mut Sheet, errata: &Errata<'_, '_>) {
    if errata.recovered.is_empty() {
        return;
    }
    sheet.heading(2, "What the paper does not state, and its numbers give away");
    // The reading of a table with wrong cells is given with these cells.
    let told = |finding: &TableFinding<'_>| {
        errata.errata.iter().any(|erratum| {
            let Subject::Cells(cells) = &erratum.subject else { return false };
            cells.finding.table.id == finding.table.id && !cells.as_defined
        })
    };
    let fact = |finding: &&TableFinding<'_>| {
        let mut lines = reading::recovered(finding);
        let searches = finding.searches().filter(|search| !search.best.is_empty());
        lines.extend(searches.filter(|_| !told(finding)).map(reading::remark));
        (finding.table.locus.clone(), lines.join("\n"))
    };
    sheet.facts(errata.recovered.iter().map(fact).collect());
}

/// The claims and the cells that could not be checked, why, and what cells are at the values put in.
pub(super) fn unchecked(sheet: &mut Sheet, errata: &Errata<'_, '_>) {
    let beyond = errata.audit.beyond_caps();
    if errata.unchecked.is_empty() && beyond.is_empty() {
        return;
    }
    sheet.heading(2, "What could not be checked, and why");
    if !beyond.is_empty() {
        sheet.facts(beyond.into_iter().map(|one| (one.locus.to_owned(), one.cap)).collect());
    }
    if errata.unchecked.is_empty() {
        return;
    }
    sheet.text(
        "Where the paper does not state a parameter, a value was put in to have something to show; \
         agreement there proves nothing, and disagreement refutes nothing.",
    );
    for group in &errata.unchecked {
        let table = group.finding.table;
        let cause = group.cause.as_ref().map(Cause::to_string).unwrap_or_default();
        sheet.heading(3, format!("{} · {} {cause}", table.locus, Word::NotCheckable.mark()));
        let value = spelled_out(errata.audit, &table.value.text);
        let mut facts = vec![
            ("said to equal".to_owned(), value),
            ("cells".to_owned(), group.cells.len().to_string()),
        ];
        if let Some(cell) = group.findings().find(|cell| !cell.assumed.is_empty()) {
            facts.push(("shown at".to_owned(), assumed(cell)));
        }
        let outcomes = group.if_assumed().groups.into_iter().filter_map(|group| {
            Some(format!("{} {}", group.count, words(group.if_assumed.as_ref()?)))
        });
        let outcomes: Vec<String> = outcomes.collect();
        if !outcomes.is_empty() {
            facts.push(("there".to_owned(), outcomes.join("\n")));
        }
        let count =
            |is: &dyn Fn(&CellFinding) -> bool| group.findings().filter(|cell| is(cell)).count();
        let broken = count(&|cell| cell.keeps_promise() == Some(false));
        let open = count(&CellFinding::may_break_promise);
        if broken + open > 0 {
            let text = format!("{broken} break it for some control data, {open} are open");
            facts.push(("promise".to_owned(), text));
        }
        for search in group.finding.searches() {
            let lines = reading::line_remarks(table, search);
            let lines = std::iter::once(reading::remark(search)).chain(lines);
            facts.push(("what was tried".to_owned(), lines.collect::<Vec<String>>().join("\n")));
        }
        sheet.facts(facts);
        let differs = |at: &&(usize, usize)| {
            let cell = &group.finding.cells[at.0][at.1];
            cell.verdict_if_assumed.as_ref().is_some_and(|verdict| *verdict != Verdict::Confirmed)
        };
        let differing: Vec<(usize, usize)> = group.cells.iter().filter(differs).copied().collect();
        if !differing.is_empty() {
            sheet.grid(shaped(group.finding, &differing, |cell, printed| {
                let exact = correct(cell.exact.as_ref(), printed, table.promise.is_some());
                format!("{} | {exact}", printed.text)
            }));
        }
    }
}
