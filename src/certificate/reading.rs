//! The reading of a table.

use super::block::Block;
use crate::audit::{AsRead, Difference, Direction, Explanation, FAMILY, Line, TableFinding};
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
    table: Option<&'f Explanation>,
    lines: Vec<(Line, &'f Explanation)>,
}

impl<'f> Readings<'f> {
    pub(super) fn of(finding: &'f TableFinding<'_>) -> Readings<'f> {
        let search = finding.search.as_ref();
        let table = search.and_then(|search| search.best.first());
        let lines = search.into_iter().flat_map(|search| &search.lines);
        // The format has no words for values that stand in the next row or column.
        let lines = lines.filter(|line| line.shift == (0, 0));
        Readings { table, lines: lines.map(|line| (line.line, &line.best)).collect() }
    }

    /// The lines `read …`, and those of rows and columns.
    pub(super) fn write(&self, block: &mut Block, paper: &Paper) {
        if let Some(reading) = self.table {
            for line in lines(paper, reading) {
                block.try_line(line);
            }
        }
        for (i, (line, reading)) in self.lines.iter().enumerate() {
            if self.lines[..i].iter().any(|(other, _)| other == line) {
                block.give_up(format!("{} has two readings", name(*line)));
            }
            block.line(name(*line));
            for line in lines(paper, reading) {
                block.try_line(line);
            }
        }
    }

    /// How a cell comes from the reading that it is read by: rounded otherwise, and by
    /// the reading of which row or column.
    pub(super) fn by(
        &self,
        read: &AsRead,
        at: (usize, usize),
    ) -> Result<(&'static str, String), String> {
        let table = self.table.map(|reading| (reading, String::new()));
        let lines = self.lines.iter().filter(|(line, _)| match line {
            Line::Row(row) => *row == at.0,
            Line::Column(column) => *column == at.1,
        });
        let lines = lines.map(|(line, reading)| (*reading, format!(" by {}", name(*line))));
        for (reading, by) in table.into_iter().chain(lines) {
            if reading.values[at.0][at.1].as_ref() != Some(&read.value) {
                continue;
            }
            for (words, direction) in ROUNDED {
                let more = direction.map_or(String::new(), |direction| format!("; {direction}"));
                if read.differs == format!("{}{more}", reading.differs()) {
                    return Ok((words, by));
                }
            }
        }
        Err("a cell is read otherwise than the table, its row and its column".to_owned())
    }
}

/// `row 1` or `column 1`.
fn name(line: Line) -> String {
    match line {
        Line::Row(row) => format!("row {}", row + 1),
        Line::Column(column) => format!("column {}", column + 1),
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
