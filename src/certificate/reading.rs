//! The reading of a table.

use super::block::Block;
use crate::audit::{
    AsRead, Difference, Direction, Explanation, FAMILY, Line, LineReading, Search, Slip,
    TableFinding,
};
use crate::claim::Paper;

/// The name of the rounding of decimals in reports, and in certificates.
pub(super) const ROUNDING: (&str, &str) = ("rounding of the decimals", "decimals");

/// The names of choices in reports, and in certificates.
const CHOICES: [(&str, &str); 10] = [
    ("order", "order"),
    ("suprema", "suprema"),
    ("norm of the difference mask", "contraction-terms"),
    ("norm of the displacement", "displacement-terms"),
    ("offset", "offset"),
    ("recursion", "recursion"),
    ("exponent", "exponent"),
    ("rounding of the depth", "rounded"),
    ROUNDING,
    ("tolerance", "tolerance"),
];

/// How a single cell may be rounded, as a verdict has it.
const ROUNDED: [(&str, Option<Direction>); 3] = [
    ("", None),
    (" rounding cut", Some(Direction::Cut)),
    (" rounding away", Some(Direction::Away)),
];

/// The readings of a table, and of its rows and columns.
pub(super) struct Readings<'f> {
    /// Those of the cells that need no assumptions, if there are any, and otherwise of all.
    first: Part<'f>,
    /// Where there are others, those of the cells that need some.
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

    /// Whether everything is as printed that needs no assumptions.
    pub(super) fn is_empty(&self) -> bool {
        self.first.is_empty()
    }

    /// The lines `read …`, and those of rows and columns.
    pub(super) fn write(&self, block: &mut Block, paper: &Paper) {
        self.first.write(block, paper);
        if !self.assumed.is_empty() {
            block.line("assumed".to_owned());
            self.assumed.write(block, paper);
        }
    }

    /// How a cell comes from the reading that it is read by: rounded otherwise, and by
    /// the reading of which row or column; `slip` is the one that is left.
    pub(super) fn by(
        &self,
        read: &AsRead,
        slip: Option<&Slip>,
        at: (usize, usize),
    ) -> Result<(&'static str, String), String> {
        let found = self.first.by(read, slip, at).or_else(|| self.assumed.by(read, slip, at));
        found.ok_or_else(|| {
            "a cell is read otherwise than the table, its row and its column".to_owned()
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

    fn write(&self, block: &mut Block, paper: &Paper) {
        if let Some(reading) = self.table {
            for line in lines(paper, reading) {
                block.try_line(line);
            }
        }
        for (i, line) in self.lines.iter().enumerate() {
            let name = name(line);
            if self.lines[..i].iter().any(|other| self::name(other) == name) {
                block.give_up(format!("{name} has two readings"));
            }
            block.line(name);
            for line in lines(paper, &line.best) {
                block.try_line(line);
            }
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
        // A shift is the slip of all cells that it explains.
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
            for (words, direction) in ROUNDED {
                let more = direction.map_or(String::new(), |direction| format!("; {direction}"));
                if read.differs == format!("{}{more}", reading.differs()) {
                    return Some((words, by));
                }
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
fn lines(paper: &Paper, reading: &Explanation) -> Vec<Result<String, String>> {
    let solved = &reading.solved;
    // What is solved for has a line of its own.
    let rest = reading
        .differences
        .iter()
        .filter(|difference| solved.iter().all(|parameter| parameter.name != difference.choice));
    let differences = rest.map(|difference| {
        if let Some(value) = &difference.value {
            return Ok(format!("read parameter {} {value}", difference.choice));
        }
        let way = way(paper, difference)?;
        Ok(match way.split_once('=') {
            Some((choice, word)) => format!("read choice {choice} {word}"),
            None => format!("read definition {}", way.replace('#', " ")),
        })
    });
    let parameters = solved
        .iter()
        .map(|parameter| Ok(format!("read parameter {} {}", parameter.name, parameter.simplest)));
    differences.chain(parameters).collect()
}

/// A difference as `CHOICE=WAY` or `DEFINITION#NUMBER`.
pub(super) fn way(paper: &Paper, difference: &Difference) -> Result<String, String> {
    let Difference { choice, says, .. } = difference;
    let known = FAMILY.iter().find(|known| known.name == choice);
    let way = known.and_then(|known| known.ways.iter().find(|way| way.says == says));
    let name = CHOICES.iter().find(|(name, _)| name == choice);
    if let (Some(way), Some((_, name))) = (way, name) {
        return Ok(format!("{name}={}", way.word));
    }
    let mut alternatives = paper.alternatives.iter().filter(|other| other.of == *choice);
    match alternatives.position(|other| other.label == *says) {
        Some(place) => Ok(format!("{choice}#{}", place + 1)),
        None => Err(format!("the format has no words for the reading `{choice}: {says}`")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_choice_has_a_name() {
        for choice in FAMILY {
            assert!(CHOICES.iter().any(|(name, _)| *name == choice.name), "{}", choice.name);
        }
    }
}
