//! The reading of a table.

use super::block::Block;
use crate::audit::{
    AsRead, Copied, Difference, Direction, Explanation, Line, LineReading, Search, Slip,
    TableFinding,
};

/// The readings of a table, and of its rows and columns.
pub(super) struct Readings<'f> {
    /// The readings of the cells that need no assumptions or, if there are none, of all cells.
    first: Part<'f>,
    /// If the table has cells of both kinds, the readings of those that need assumptions.
    assumed: Part<'f>,
}

/// The readings of the cells of one kind.
struct Part<'f> {
    table: Option<&'f Explanation>,
    lines: Vec<&'f LineReading>,
}

impl<'f> Readings<'f> {
    pub(super) fn of(finding: &'f TableFinding<'_>) -> Readings<'f> {
        let (search, assumed) = (finding.search.as_ref(), finding.assumed_search.as_ref());
        Readings { first: Part::of(search), assumed: Part::of(assumed) }
    }

    /// Whether the cells of the first kind are all read as printed.
    pub(super) fn is_empty(&self) -> bool {
        self.first.is_empty()
    }

    /// Writes the lines `read …`, and those of rows and columns.
    pub(super) fn write(&self, block: &mut Block) {
        self.first.write(block);
        if !self.assumed.is_empty() {
            block.line("assumed".to_owned());
            self.assumed.write(block);
        }
    }

    /// How a cell follows from the reading `read`: the words for its rounding, and the words for
    /// the row or column whose reading this is. `slip` is the slip that remains under the reading.
    pub(super) fn by(
        &self,
        read: &AsRead,
        slip: Option<&Slip>,
        at: (usize, usize),
    ) -> Result<(&'static str, String), String> {
        let found = self.first.by(read, slip, at).or_else(|| self.assumed.by(read, slip, at));
        found.ok_or_else(|| {
            "a cell is read differently from the table, its row and its column".to_owned()
        })
    }
}

impl<'f> Part<'f> {
    fn of(search: Option<&'f Search>) -> Part<'f> {
        let table = search.and_then(|search| search.best.first());
        let lines = search.into_iter().flat_map(|search| &search.lines);
        Part { table, lines: lines.collect() }
    }

    fn is_empty(&self) -> bool {
        self.table.is_none() && self.lines.is_empty()
    }

    fn write(&self, block: &mut Block) {
        if let Some(reading) = self.table {
            lines(reading).for_each(|line| block.line(line));
        }
        for (i, line) in self.lines.iter().enumerate() {
            let name = name(line);
            if self.lines[..i].iter().any(|other| self::name(other) == name) {
                block.give_up(format!("{name} has two readings"));
            }
            block.line(name);
            lines(&line.best).for_each(|line| block.line(line));
        }
    }

    fn by(
        &self,
        read: &AsRead,
        slip: Option<&Slip>,
        at: (usize, usize),
    ) -> Option<(&'static str, String)> {
        let table = self.table.map(|reading| (reading, String::new()));
        let lines = self.lines.iter().filter(|line| match line.line {
            Line::Row(row) => row == at.0,
            Line::Column(column) => column == at.1,
        });
        // If a line is shifted, its shift is the slip of all cells that it explains.
        let lines = lines.filter(|line| match (line.shift, slip) {
            ((0, 0), slip) => !matches!(slip, Some(Slip::Neighbour(..))),
            (shift, Some(Slip::Neighbour(rows, columns))) => shift == (*rows, *columns),
            _ => false,
        });
        let lines = lines.map(|line| (&line.best, format!(" by {}", name(line))));
        for (reading, by) in table.into_iter().chain(lines) {
            if reading.values[at.0][at.1].as_ref() != Some(&read.value) {
                continue;
            }
            let words = match read.rounded {
                None => "",
                Some(Direction::Cut) => " rounding cut",
                Some(Direction::Away) => " rounding away",
                Some(Direction::DepthDown | Direction::DepthNearest) => continue,
            };
            if read.is(reading) {
                return Some((words, by));
            }
        }
        None
    }
}

/// `row 1`, or `column 1 from 0 1`.
fn name(reading: &LineReading) -> String {
    let line = match reading.line {
        Line::Row(row) => format!("row {}", row + 1),
        Line::Column(column) => format!("column {}", column + 1),
    };
    match reading.shift {
        (0, 0) => line,
        (rows, columns) => format!("{line} from {rows} {columns}"),
    }
}

/// The lines `read …`.
fn lines(reading: &Explanation) -> impl Iterator<Item = String> {
    // A parameter that was solved for has a line of its own.
    let solved = &reading.solved;
    let is_solved = |difference: &&Difference| {
        solved.iter().any(|parameter| parameter.name == difference.about())
    };
    let rest = reading.differences.iter().filter(move |difference| !is_solved(difference));
    let differences = rest.map(|difference| match difference {
        Difference::Way(choice, way) => format!("read choice {} {}", choice.key, way.word),
        Difference::Alternative { of, number, .. } => format!("read definition {of} {number}"),
        Difference::Copied(source) => format!("read copied {}", copied(source)),
        Difference::Scale { name, value, .. } => format!("read parameter {name} {value}"),
    });
    let parameters = solved
        .iter()
        .map(|parameter| format!("read parameter {} {}", parameter.name, parameter.simplest));
    differences.chain(parameters)
}

/// `DEFINITION@TABLE`, `DEFINITION@NAME=VALUE`, `DEFINITION@scheme#NUMBER`, `tolerance@line#NUMBER` or
/// `scheme@row#NUMBER`.
fn copied(source: &Copied) -> String {
    match source {
        Copied::Printed { of, table, .. } => format!("{of}@{table}"),
        Copied::Parameter { of, name, value } => format!("{of}@{name}={value}"),
        Copied::Scheme { of, number, .. } => format!("{of}@scheme#{}", number + 1),
        Copied::Tolerance { line, .. } => format!("tolerance@line#{}", line + 1),
        Copied::Numbers { first } => format!("scheme@row#{}", first + 1),
    }
}

/// A difference as `CHOICE=WAY`, `DEFINITION#NUMBER` or a quantity from another place; `None` for a
/// parameter.
pub(super) fn member(difference: &Difference) -> Option<String> {
    match difference {
        Difference::Way(choice, way) => Some(format!("{}={}", choice.key, way.word)),
        Difference::Alternative { of, number, .. } => Some(format!("{of}#{number}")),
        Difference::Copied(source) => Some(copied(source)),
        Difference::Scale { .. } => None,
    }
}
