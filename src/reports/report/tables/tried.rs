//! The readings of a table that were tried, the best first.

use crate::audit::{Explanation, TableFinding, Word};
use crate::exact::format::short;
use crate::report::words::sheet::{Grid, Sheet};

/// The order of the readings, in words.
const ORDER: &str = "The readings that explain most cells of the table come first.";

/// The meaning of [`LUCK`], in words.
const ON_LUCK: &str = "✓ luck: the reading gives this cell, but no more of the others than \
                       unrelated numbers would.";

/// How many readings are shown without `--all`.
const MAX_SHOWN: usize = 10;

/// The word beside a value that a reading gives by luck.
const LUCK: &str = " luck";

/// The place of a cell: row and column, counted from 0.
pub(crate) type Place = (usize, usize);

/// The readings in order: those that explain most cells first. For a cell, the readings of its row
/// and of its column come before all others.
pub(crate) fn in_order<'r>(
    finding: &'r TableFinding<'_>,
    readings: &'r [Explanation],
    at: Option<Place>,
) -> Vec<&'r Explanation> {
    let mut readings: Vec<&Explanation> = readings.iter().collect();
    if let Some((row, column)) = at {
        let lines = finding.searches().flat_map(|search| &search.lines);
        let own = lines.map(|line| &line.best).filter(|best| best.explained[row][column]);
        readings.splice(0..0, own);
    }
    readings
}

/// The readings, and of each the number of those after it that give the same value at a place and are left out. Only
/// the values of the readings that are shown are compared.
fn grouped<'r>(
    finding: &TableFinding<'_>,
    readings: &[&'r Explanation],
    at: Option<Place>,
) -> Vec<(&'r Explanation, usize)> {
    let mut groups: Vec<(&Explanation, usize)> = Vec::new();
    for reading in readings {
        let alike = at.and_then(|at| {
            let same = |(first, _): &&mut (&Explanation, usize)| {
                let [own, other] = [reading, first].map(|one| &one.values[at.0][at.1]);
                let luck = [reading, first].map(|one| finding.is_by_luck(one, at));
                own == other && luck[0] == luck[1]
            };
            groups.iter_mut().take(MAX_SHOWN).find(same)
        });
        match alike {
            Some((_, others)) => *others += 1,
            None => groups.push((reading, 0)),
        }
    }
    groups
}

/// Each reading with the number of cells that it explains; for a cell, also with its value there.
pub(crate) fn section(
    sheet: &mut Sheet,
    finding: &TableFinding<'_>,
    readings: &[Explanation],
    at: Option<Place>,
    all: bool,
) {
    if readings.is_empty() {
        return;
    }
    sheet.heading(2, "Readings tried");
    let values = readings.iter().flat_map(|reading| reading.values.iter().flatten());
    if values.flatten().next().is_none() {
        let count = readings.len();
        sheet.text(format!("None of {count} readings gives a value for any of these cells."));
        return;
    }
    let readings = in_order(finding, readings, at);
    let groups = grouped(finding, &readings, at.filter(|_| !all));
    let shown = if all { groups.len() } else { MAX_SHOWN };
    let row = |(reading, others): &(&Explanation, usize)| {
        let differs = match reading.differs() {
            nothing if nothing.is_empty() => "as printed".to_owned(),
            differs => differs,
        };
        let mut row = vec![match others {
            0 => differs,
            1 => format!("{differs} (and 1 more with this value)"),
            others => format!("{differs} (and {others} more with this value)"),
        }];
        if let Some((row_place, column)) = at {
            let explained = reading.explained[row_place][column];
            let verdict = if explained { Word::Confirmed } else { Word::Refuted };
            let value = reading.values[row_place][column].as_ref();
            let value = value.map_or_else(|| "no value".to_owned(), |value| short(value, 12));
            let luck = if finding.is_by_luck(reading, (row_place, column)) { LUCK } else { "" };
            row.push(format!("{value} {}{luck}", verdict.mark()));
        }
        row.push(reading.count().to_string());
        row
    };
    let header = match at {
        None => vec!["reading", "cells explained"],
        Some(_) => vec!["reading", "value here", "cells explained"],
    };
    sheet.text(ORDER);
    if at.is_some_and(|at| groups.iter().take(shown).any(|(one, _)| finding.is_by_luck(one, at))) {
        sheet.text(ON_LUCK);
    }
    sheet.grid(Grid::of(header, groups.iter().take(shown).map(row), 1));
    let told: usize = groups.iter().take(shown).map(|(_, others)| 1 + others).sum();
    let more = readings.len() - told;
    if more > 0 {
        sheet.text(format!("And {more} more, none of them better: `--all` shows them."));
    }
}
