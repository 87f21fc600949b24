//! The section of a report about one table.

use super::facts;
use super::words::{self, at, count, is_wrong, type_name};
use crate::report::words::parts::titled;
use crate::report::words::sheet::{Grid, Sheet};
use crate::shipped::{
    ExactValues, Origin, Project, ShippedFinding, TableIndex, Verdict, decimal, nearest_text,
};

/// The most rows of a list of numbers, unless all are asked for.
const MAX_ROWS: usize = 12;

/// The most characters of a formula in a list of numbers.
const MAX_FORMULA: usize = 24;

/// The digits of an exact value beside a shipped one.
const DIGITS: u32 = 20;

/// The report about one table; with `all`, with every number.
#[must_use]
pub fn finding_sheet(project: &Project, finding: &ShippedFinding<'_>, all: bool) -> Sheet {
    let mut sheet = Sheet::default();
    section(&mut sheet, 1, project, finding, all);
    sheet
}

/// Appends the section, with a heading of this level.
pub(super) fn section(
    sheet: &mut Sheet,
    level: u8,
    project: &Project,
    finding: &ShippedFinding<'_>,
    all: bool,
) {
    let claim = finding.claim;
    let title = titled(&[&claim.locus, &claim.title, &claim.id]);
    sheet.heading(level, format!("{} {title}", finding.outcome.word().mark()));
    sheet.text(headline(finding));
    sheet.facts(facts_of(project, finding));
    grid(sheet, finding, all);
    if let Some(note) = &claim.note {
        sheet.text(note.clone());
    }
}

/// What is found of a table, in a sentence or two.
#[must_use]
pub fn headline(finding: &ShippedFinding<'_>) -> String {
    let claim = finding.claim;
    let all = finding.cells.len();
    let kind = type_name(claim.kind);
    if finding.is_right() {
        // What a program does to the numbers later is not known.
        return match (all, &claim.origin) {
            (1, Origin::Source { file, .. }) => {
                format!("As written in {file}, the number is the nearest {kind}.")
            }
            (_, Origin::Source { file, .. }) => {
                format!("As written in {file}, all {all} numbers are the nearest {kind}.")
            }
            (1, _) => format!("The number is the nearest {kind}."),
            _ => format!("All {all} numbers are the nearest {kind}."),
        };
    }
    let fair = |verdict| matches!(verdict, Verdict::Refuted(_)) && !is_wrong(verdict);
    let parts: [(usize, String); 8] = [
        (finding.count(is_wrong), "wrong".to_owned()),
        (finding.count(fair), "right to fewer digits than are written".to_owned()),
        (finding.count(|verdict| matches!(verdict, Verdict::Misprint(_))), misprints(finding)),
        (finding.count(|verdict| verdict == Verdict::Open), "not decided".to_owned()),
        (finding.count(|verdict| matches!(verdict, Verdict::Ulps(_))), ulps(finding)),
        (finding.count(|verdict| matches!(verdict, Verdict::Cut(_))), "cut".to_owned()),
        (
            finding.count(|verdict| matches!(verdict, Verdict::Rounded(_))),
            "rounded to the digits that are written".to_owned(),
        ),
        (finding.count(|verdict| verdict == Verdict::Nearest), format!("the nearest {kind}")),
    ];
    let parts: Vec<(usize, String)> = parts.into_iter().filter(|(count, _)| *count > 0).collect();
    let said: Vec<String> = parts
        .iter()
        .map(|(count, what)| format!("{count} {} {what}", if *count == 1 { "is" } else { "are" }))
        .collect();
    let sentence = match &parts[..] {
        [(_, what)] if all == 1 => format!("The number is {what}."),
        [(_, what)] => format!("All {all} numbers are {what}."),
        _ => format!("Of {}, {}.", count(all, "number", "numbers"), said.join(", ")),
    };
    match &finding.reading {
        Some(reading) => {
            format!("{} As printed: {}", words::reading(claim, reading), lower(&sentence))
        }
        None => sentence,
    }
}

/// A sentence that goes on after a colon.
fn lower(sentence: &str) -> String {
    let mut letters = sentence.chars();
    letters.next().map(|first| first.to_lowercase().chain(letters).collect()).unwrap_or_default()
}

fn misprints(finding: &ShippedFinding<'_>) -> String {
    match finding.count(|verdict| matches!(verdict, Verdict::Misprint(_))) {
        1 => "a misprint".to_owned(),
        _ => "misprints".to_owned(),
    }
}

/// How far those are away that are units in the last place away.
fn ulps(finding: &ShippedFinding<'_>) -> String {
    let units = finding.cells.iter().filter_map(|cell| match cell.verdict {
        Verdict::Ulps(units) => Some(units),
        _ => None,
    });
    match units.max() {
        Some(1) => "1 unit in the last place away".to_owned(),
        Some(most) => format!("up to {most} units in the last place away"),
        None => String::new(),
    }
}

/// What is known of a table, by name.
pub(crate) fn facts_of(project: &Project, finding: &ShippedFinding<'_>) -> Vec<(String, String)> {
    let claim = finding.claim;
    let mut facts = vec![("numbers".to_owned(), numbers(finding))];
    facts.extend(source(finding).map(|text| ("read from".to_owned(), text)));
    facts.push(("said to equal".to_owned(), equals(&claim.exact)));
    facts.extend(words::definitions(project, claim));
    let optional = [
        ("greatest error", facts::greatest_error(finding)),
        ("accepted", facts::tolerance(finding)),
        ("sums", facts::sums(finding)),
        ("equal values", facts::equals(finding)),
    ];
    let optional = optional.into_iter().filter_map(|(name, text)| Some((name.to_owned(), text?)));
    facts.extend(optional);
    facts
}

/// `21 of type f32: n = 3, …, 9, k = 0, …, 2`.
pub(super) fn numbers(finding: &ShippedFinding<'_>) -> String {
    let claim = finding.claim;
    let range = |index: &TableIndex| {
        let TableIndex { name, from, to } = index;
        match to - from {
            0 => format!("{name} = {from}"),
            1 => format!("{name} = {from}, {to}"),
            _ => format!("{name} = {from}, …, {to}"),
        }
    };
    let ranges: Vec<String> = claim.indices.iter().map(range).collect();
    let ranges = if ranges.is_empty() { String::new() } else { format!(": {}", ranges.join("; ")) };
    format!("{} of type {}{ranges}", claim.numbers.len(), claim.kind.name())
}

/// Where the numbers were read, of a source file.
fn source(finding: &ShippedFinding<'_>) -> Option<String> {
    let Origin::Source { file, after } = &finding.claim.origin else { return None };
    let line = finding.claim.numbers.first()?.line?;
    Some(format!("{file}, line {line}, after {after}"))
}

/// The formula of a table.
pub(super) fn equals(exact: &ExactValues) -> String {
    match exact {
        ExactValues::Formula(formula) => formula.text.clone(),
        ExactValues::Each(_) => "a formula of its own for each number".to_owned(),
    }
}

/// The numbers that are off; with `all`, every number.
fn grid(sheet: &mut Sheet, finding: &ShippedFinding<'_>, all: bool) {
    if all {
        let places: Vec<usize> = (0..finding.cells.len()).collect();
        sheet.grid(rows(finding, &places));
        return;
    }
    let places = shown(finding);
    if places.is_empty() {
        return;
    }
    sheet.grid(rows(finding, &places));
    let count = (0..finding.cells.len()).filter(|&place| is_off(finding, place)).count();
    if places.len() < count {
        sheet
            .text(format!("{} of {count} such numbers; `--all` shows every number.", places.len()));
    }
}

/// Whether a number is neither the nearest nor rounded or cut to its digits.
fn is_off(finding: &ShippedFinding<'_>, place: usize) -> bool {
    !matches!(
        finding.cells[place].verdict,
        Verdict::Nearest | Verdict::Rounded(_) | Verdict::Cut(_)
    )
}

/// The numbers that are listed of a table: some of those that are off, the worst verdicts first.
pub(crate) fn shown(finding: &ShippedFinding<'_>) -> Vec<usize> {
    let mut off: Vec<usize> =
        (0..finding.cells.len()).filter(|&place| is_off(finding, place)).collect();
    if off.len() > MAX_ROWS {
        // Numbers of one outcome stay in order.
        off.sort_by_key(|&place| std::cmp::Reverse(finding.cells[place].verdict.outcome()));
        off.truncate(MAX_ROWS);
    }
    off
}

/// A column of a list of numbers: whether this table has it, its header, and its text.
type Column<'c> = (bool, &'c str, &'c dyn Fn(usize) -> String);

/// Numbers of a table with their exact values and verdicts.
pub(crate) fn rows(finding: &ShippedFinding<'_>, places: &[usize]) -> Grid {
    let claim = finding.claim;
    let kind = claim.kind;
    let formulas = matches!(claim.exact, ExactValues::Each(_));
    let has_lines = claim.numbers.iter().any(|number| number.line.is_some());
    let nearest = format!("nearest {}", type_name(kind));
    let exact = |place: usize| finding.cells[place].exact.as_ref().ok();
    let unknown = || "?".to_owned();
    let columns: [Column<'_>; 7] = [
        (!claim.indices.is_empty(), "at", &|place| at(claim, place)),
        (has_lines, "line", &|place| {
            claim.numbers[place].line.map(|line| line.to_string()).unwrap_or_default()
        }),
        (true, "shipped", &|place| claim.numbers[place].text.clone()),
        (formulas, "formula", &|place| shortened(&claim.exact.of(place).text)),
        (true, "exact", &|place| exact(place).map_or_else(unknown, |exact| decimal(exact, DIGITS))),
        (true, &nearest, &|place| {
            exact(place).and_then(|exact| nearest_text(exact, kind)).unwrap_or_else(unknown)
        }),
        (true, "verdict", &|place| {
            let cell = &finding.cells[place];
            let written = claim.numbers[place].written.as_ref();
            let digits = written.and_then(|written| written.count).map(|(digits, _)| digits);
            format!(
                "{} {}",
                cell.verdict.outcome().word().mark(),
                words::verdict(cell, kind, digits)
            )
        }),
    ];
    let columns = columns.iter().filter(|(is_there, ..)| *is_there);
    let row = |&place: &usize| columns.clone().map(|(.., text)| text(place)).collect();
    let header: Vec<&str> = columns.clone().map(|(_, header, _)| *header).collect();
    Grid { left_columns: header.len(), ..Grid::of(header, places.iter().map(row), 0) }
}

/// A formula, cut where it would make a table too wide; the claim file has it whole.
fn shortened(formula: &str) -> String {
    if formula.chars().count() <= MAX_FORMULA {
        return formula.to_owned();
    }
    let part: String = formula.chars().take(MAX_FORMULA - 1).collect();
    format!("{part}…")
}
