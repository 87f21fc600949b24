//! Readings of a table, and the search for the best.

use crate::audit::{self, LineReading, TableFinding};
use crate::claim;
use crate::report::json::exact::decimal;
use crate::report::tables::reading::place;
use crate::report::tables::tried::in_order;
use serde::Serialize;

/// The search for a reading of a table: what it covered, and what it found.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Search<'a> {
    /// How many readings were tried.
    pub tried: usize,
    /// The choices, definitions and quantities in which readings differ.
    pub choices: &'a [String],
    /// In how many of these a reading may differ from the printed text.
    pub max_differences: usize,
    /// How many cells there are to explain.
    pub cells: usize,
    /// How many of them the printed text explains.
    pub as_printed: usize,
    /// How many cells the best reading explains, even if only by luck.
    pub most: usize,
    /// The best readings, where they explain more than chance would.
    pub best: Vec<Explanation<'a>>,
    /// An upper bound of how many readings would explain as many cells by chance.
    pub chance: String,
    /// The readings of single rows and columns.
    pub lines: Vec<Line<'a>>,
}

/// The reading of a row or a column.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Line<'a> {
    /// Which row or column.
    pub place: String,
    /// How many cells the reading of the whole table leaves there.
    pub cells: usize,
    /// How far the values are from their places.
    pub shift: Shift,
    /// How many readings were tried over all rows and columns.
    pub tried: usize,
    /// The best reading.
    pub best: Explanation<'a>,
    /// An upper bound of how many readings would explain as many cells by chance.
    pub chance: String,
}

/// How far the values of a row or a column are from their places.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Shift {
    /// By so many rows down.
    pub rows: i32,
    /// By so many columns to the right.
    pub columns: i32,
}

/// A reading, and how many cells it explains.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Explanation<'a> {
    /// How it differs from the printed text; empty where it does not.
    pub differs: String,
    /// How many cells it explains.
    pub explains: usize,
    /// The parameters that were solved for.
    pub solved: Vec<Solved<'a>>,
}

/// A parameter that was solved for.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Solved<'a> {
    /// Its name.
    pub name: &'a str,
    /// The lower end of the interval of values with which every explained cell is consistent.
    pub from: String,
    /// The upper end of this interval.
    pub to: String,
    /// The simplest number in this interval.
    pub simplest: String,
}

/// A reading that was tried.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Reading<'a> {
    /// The reading; its fields stand here.
    #[serde(flatten)]
    pub explanation: Explanation<'a>,
    /// The value of the reading for the cell that was asked about; its fields stand here, and are
    /// missing where a whole table was asked about.
    #[serde(flatten)]
    pub of_cell: Option<ReadingOfCell>,
}

/// The value of a reading for one cell.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ReadingOfCell {
    /// The value; null where it has none.
    pub exact: Option<String>,
    /// The value as a decimal.
    pub decimal: Option<String>,
    /// Whether this value explains the cell.
    pub explains_this: bool,
    /// Whether it does so by luck: the reading explains no more of the other cells than unrelated
    /// numbers would.
    pub by_luck: bool,
}

impl<'a> Search<'a> {
    pub(crate) fn of(table: &claim::Table, search: &'a audit::Search) -> Search<'a> {
        let line = |line: &'a LineReading| Line {
            place: place(table, line.line),
            cells: line.cells,
            shift: Shift { rows: line.shift.0, columns: line.shift.1 },
            tried: line.tried,
            best: Explanation::of(&line.best),
            chance: line.chance.to_string(),
        };
        Search {
            tried: search.tried,
            choices: &search.choices,
            max_differences: search.max_differences,
            cells: search.cells,
            as_printed: search.as_printed,
            most: search.most,
            best: search.best.iter().map(Explanation::of).collect(),
            chance: search.chance.to_string(),
            lines: search.lines.iter().map(line).collect(),
        }
    }
}

impl<'a> Explanation<'a> {
    fn of(explanation: &'a audit::Explanation) -> Explanation<'a> {
        let solved = |solved: &'a audit::Solved| Solved {
            name: &solved.name,
            from: solved.between.0.to_string(),
            to: solved.between.1.to_string(),
            simplest: solved.simplest.to_string(),
        };
        Explanation {
            differs: explanation.differs(),
            explains: explanation.count(),
            solved: explanation.solved.iter().map(solved).collect(),
        }
    }
}

impl<'a> Reading<'a> {
    /// All readings of a table, or of its cell at a row and a column, the best first.
    pub(crate) fn all(
        finding: &'a TableFinding<'_>,
        readings: &'a [audit::Explanation],
        at: Option<(usize, usize)>,
    ) -> Vec<Reading<'a>> {
        let reading = |reading: &'a audit::Explanation| Reading {
            explanation: Explanation::of(reading),
            of_cell: at.map(|(row, column)| {
                let value = reading.values[row][column].as_ref();
                ReadingOfCell {
                    exact: value.map(ToString::to_string),
                    decimal: value.map(decimal),
                    explains_this: reading.explained[row][column],
                    by_luck: finding.is_by_luck(reading, (row, column)),
                }
            }),
        };
        in_order(finding, readings, at).into_iter().map(reading).collect()
    }
}
