//! The report of what a search for readings has found.

use crate::audit::{
    CellFinding, Explanation, Fitting, Line, LineReading, Recovered, RecoveredFrom, Search, Slip,
    TableFinding, Verdict, Word,
};
use crate::claim::{Axis, Table};
use crate::exact::{Rational, format::short};
use crate::report::words::numbers::grouped;

/// How many equally good readings are named.
const MAX_LISTED: usize = 3;

/// The outcome in a sentence or two, below a table.
pub(crate) fn remark(search: &Search) -> String {
    let Search { tried, cells, as_printed, .. } = search;
    let Some(first) = search.best.first() else {
        let tried = grouped(*tried);
        let found = match by_luck(search) {
            Some(found) => format!("the best of {tried} {found}"),
            None => format!(
                "none of {tried} explains more than the {as_printed} of {cells} cells that are as \
                 printed."
            ),
        };
        return format!("Readings: {found} {}{}", differ_in(search), uncomputed(search));
    };
    let others = search.best[1..].iter().take(MAX_LISTED - 1);
    let others = others.map(|other| format!(" Or: {}.", named(other)));
    let mut text = if first.differences.is_empty() {
        format!("{} As printed.", Word::Reproduced.mark())
    } else {
        format!("{} Read differently: {}.", Word::OtherReading.mark(), first.differs())
    };
    text.extend(others);
    text.push_str(" That explains ");
    text.push_str(&strength(search));
    if first.count() < *cells {
        text.push(' ');
        text.push_str(&differ_in(search));
    }
    text.push_str(&uncomputed(search));
    text
}

/// Which values of readings were not computed.
fn uncomputed(search: &Search) -> String {
    let cap = search.uncomputed.as_ref().map(|uncomputed| &uncomputed.cap);
    cap.map_or_else(String::new, |cap| format!(" Not every reading is computed: {cap}."))
}

/// The readings of single rows and columns, a sentence each.
pub(crate) fn line_remarks(table: &Table, search: &Search) -> Vec<String> {
    let remark = |line: &LineReading| {
        format!(
            "{} {}: {}. That explains {}",
            if line.shift == (0, 0) { Word::OtherReading } else { Word::Misprint }.mark(),
            capital(&place(table, line.line)),
            line_differs(line),
            line_strength(line)
        )
    };
    search.lines.iter().map(remark).collect()
}

/// The parameters that were recovered, a sentence each, or the values that fit best.
pub(crate) fn recovered(finding: &TableFinding<'_>) -> Vec<String> {
    let sentence = |(name, recovered): (&String, &Recovered)| {
        let value = &recovered.value;
        let from = match &recovered.from {
            RecoveredFrom::Solved(low, high) => {
                let (low, high) = (short(low, 8), short(high, 8));
                format!(
                    "These numbers give {name} = {value}: every value from {low} to {high} fits."
                )
            }
            RecoveredFrom::Table { locus, .. } => format!("{locus} gives {name} = {value}."),
            RecoveredFrom::Tried => {
                format!("{name} = {value} is the plainest value that fits these numbers.")
            }
        };
        format!("The paper does not state {name}. {from}")
    };
    let fitting = finding.fitting.as_ref();
    let count = finding.cells.iter().flatten().filter(|cell| cell.printed.is_some()).count();
    let fitting = fitting.map(|found| format!("{}.", self::fitting(found, count)));
    finding.recovered.iter().map(sentence).chain(fitting).collect()
}

/// The values that fit some of the cells of a table, which may be luck.
pub(crate) fn fitting(fitting: &Fitting, of: usize) -> String {
    let value = |(name, recovered): (&String, &Recovered)| match &recovered.from {
        RecoveredFrom::Solved(low, high) => {
            format!("{name} from {} to {}", short(low, 8), short(high, 8))
        }
        _ => format!("{name} = {}", recovered.value),
    };
    let values: Vec<String> = fitting.values.iter().map(value).collect();
    format!("{} of {of} fit {}, which may be luck", fitting.cells, values.join(", "))
}

/// A reading in words.
fn named(reading: &Explanation) -> String {
    match reading.differs() {
        nothing if nothing.is_empty() => "as printed".to_owned(),
        differs => differs,
    }
}

/// How a line is read: its reading, and where its values stand.
pub(crate) fn line_differs(line: &LineReading) -> String {
    let differs = named(&line.best);
    match line.shift {
        (0, 0) => differs,
        (rows, columns) => format!("{differs}; {} throughout", Slip::Neighbour(rows, columns)),
    }
}

/// `row j = 1` of a table.
pub(crate) fn place(table: &Table, line: Line) -> String {
    let name = |axis: &Axis, place: usize| {
        let printed = axis.entries.get(place).map_or("", |entry| entry.printed.as_str());
        format!("{} = {printed}", axis.label)
    };
    match line {
        Line::Row(place) => match &table.rows {
            Some(rows) => format!("row {}", name(rows, place)),
            None => format!("row {}", place + 1),
        },
        Line::Column(place) => format!("column {}", name(&table.columns, place)),
    }
}

pub(crate) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(char::to_uppercase).into_iter().flatten().chain(letters).collect()
}

/// What the best reading explains, if it was not taken since it may be luck.
fn by_luck(search: &Search) -> Option<String> {
    let Search { cells, as_printed, most, chance, .. } = search;
    (search.best.is_empty() && most > as_printed).then(|| {
        format!("explains {most} of {cells} cells, {as_printed} are as printed. {}", luck(chance))
    })
}

/// What the search covered, so that a reader can judge a search that found nothing.
pub(crate) fn covered(search: &Search) -> String {
    let best = match search.best.first() {
        None => by_luck(search).map_or(String::new(), |found| format!(" The best {found}")),
        Some(best) => format!(
            " The best ({}) explains {} of {} cells.",
            best.differs(),
            best.count(),
            search.cells
        ),
    };
    let (differ, uncomputed) = (differ_in(search), uncomputed(search));
    format!("{} readings were tried. {differ}{best}{uncomputed}", grouped(search.tried))
}

/// How good the reading of these cells is: the table's reading, and the readings of rows and
/// columns, as far as these cells are read by them.
pub(crate) fn evidence<'c>(
    table: &Table,
    search: &Search,
    cells: &(impl Iterator<Item = &'c CellFinding> + Clone),
) -> String {
    let read = |reading: &Explanation| {
        cells.clone().any(|cell| cell.as_read.as_ref().is_some_and(|read| read.is(reading)))
    };
    // Cells that are reproduced as printed have no other reading.
    let as_printed =
        |cell: &CellFinding| cell.verdict == Verdict::Reproduced && cell.as_read.is_none();
    let named = |best: &Explanation| {
        read(best) || best.differences.is_empty() && cells.clone().any(as_printed)
    };
    let whole = search.best.first().filter(|best| named(best));
    let whole = whole.map(|_| format!("That explains {}", strength(search)));
    let lines = search.lines.iter().filter(|line| read(&line.best));
    let lines =
        lines.map(|line| format!("{}: {}", capital(&place(table, line.line)), line_strength(line)));
    whole.into_iter().chain(lines).collect::<Vec<String>>().join("\n")
}

fn strength(search: &Search) -> String {
    let Search { tried, cells, as_printed, chance, .. } = search;
    format!(
        "{} of {cells} cells, {as_printed} as printed; {} readings were compared. {}",
        search.best.first().map_or(0, Explanation::count),
        grouped(*tried),
        luck(chance),
    )
}

fn line_strength(line: &LineReading) -> String {
    let LineReading { cells, tried, chance, best, .. } = line;
    let explained = best.count();
    let of = if explained == *cells {
        format!("all {cells} cells")
    } else {
        format!("{explained} of {cells} cells")
    };
    format!(
        "{of} left there; {} readings were compared over all rows and columns. {}",
        grouped(*tried),
        luck(chance)
    )
}

/// How likely luck is, in a sentence.
fn luck(chance: &Rational) -> String {
    // Beyond this, only the number of digits is told.
    const MANY: u32 = 9;
    if *chance >= Rational::one() {
        return "Unrelated numbers would do as well.".to_owned();
    }
    let often = chance.recip().floor().to_string();
    let places = u32::try_from(often.len() - 1).unwrap_or(u32::MAX);
    let rounded = format!("{}{}", &often[..1], "0".repeat(often.len() - 1));
    let often = match rounded.parse::<usize>() {
        Ok(number) if places < MANY => grouped(number),
        _ => format!("10^{places}"),
    };
    let by_luck = if *chance <= Rational::new(1, 1_000) { "" } else { ", so that it may be luck" };
    format!("Of tables of unrelated numbers, at most 1 in {often} would do as well{by_luck}.")
}

fn differ_in(search: &Search) -> String {
    format!("They differ in up to {} of: {}.", search.max_differences, search.choices.join(", "))
}

/// The facts about a search: what it covered, and what it found.
pub(crate) fn facts(table: &Table, search: &Search) -> Vec<(String, String)> {
    let mut facts = vec![
        ("readings differ in".to_owned(), search.choices.join(", ")),
        ("readings tried".to_owned(), grouped(search.tried)),
        ("as printed".to_owned(), format!("explains {} of {}", search.as_printed, search.cells)),
    ];
    for explanation in search.best.iter().take(MAX_LISTED) {
        facts.push(("best reading".to_owned(), best(explanation, search.cells)));
    }
    if !search.best.is_empty() {
        facts.push(("by luck".to_owned(), luck(&search.chance)));
    }
    for line in &search.lines {
        let lines = [line_differs(line), line_strength(line)].join("\n");
        facts.push((place(table, line.line), lines));
    }
    facts
}

fn best(explanation: &Explanation, cells: usize) -> String {
    let solved = explanation.solved.iter().map(|solved| {
        let (low, high) = (short(&solved.between.0, 8), short(&solved.between.1, 8));
        format!("\n{} is between {low} and {high}", solved.name)
    });
    let explained = explanation.count();
    let differs = explanation.differs();
    format!("{differs}\nexplains {explained} of {cells}{}", solved.collect::<String>())
}
