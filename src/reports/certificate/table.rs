//! Tables: the value of every cell, and the verdict on the printed number.

use super::block::{Block, Certified, closed};
use super::reading::Readings;
use super::{constant, family, promise};
use crate::audit::{
    CellFinding, CellKind, Direction, Missing, RecoveredFrom, Search, Slip, SoundCell,
    TableFinding, Verdict, Word, evidence, promise_evidence, readings,
};
use crate::claim::{Cell, Paper, Promise};

impl Certified for TableFinding<'_> {
    fn block(&self, paper: &Paper) -> Block {
        let table = self.table;
        let mut block = Block::new("table", &table.id);
        let readings = Readings::of(self);
        let refuted = refuted(self);
        let otherwise = !refuted.is_empty() || !readings.is_empty() || !self.recovered.is_empty();
        let evidence = match evidence(paper, self, otherwise) {
            Ok(evidence) => evidence,
            Err(error) => {
                block.give_up(error.message);
                return block;
            }
        };
        evidence.searched.iter().for_each(|constant| constant::searched(&mut block, constant));
        if let Some(scheme) = &table.scheme {
            block.restate("scheme", &scheme.reference.to_string());
        }
        block.restate("value", &table.value.text);
        for (name, recovered) in &self.recovered {
            let from = match &recovered.from {
                RecoveredFrom::Table { id, .. } => format!(" from {id}"),
                RecoveredFrom::Solved(..) | RecoveredFrom::Tried => String::new(),
            };
            block.line(format!("recovered {name} {}{from}", recovered.value));
        }
        readings.write(&mut block);
        for (row, cells) in self.cells.iter().enumerate() {
            for (column, cell) in cells.iter().enumerate() {
                let line = line(cell, &readings, (row, column));
                block.try_line(line.map(|line| format!("cell {} {} {line}", row + 1, column + 1)));
            }
        }
        evidence.attained.iter().for_each(|constant| block.line(constant::attained(constant)));
        evidence.sound.iter().for_each(|cell| block.line(sound(cell)));
        match promise_evidence(paper, self) {
            Ok(evidence) => {
                let is_depth = matches!(table.promise, Some(Promise::Depth { .. }));
                let printed = |row: usize, column: usize| match &table.cells[row][column] {
                    Cell::Printed(printed) if is_depth => {
                        let value = printed.decimal.value();
                        let level = value.numerator().to_i64().filter(|_| value.is_integer());
                        level.and_then(|level| u32::try_from(level).ok())
                    }
                    _ => None,
                };
                promise::lines(&mut block, &evidence, printed);
            }
            Err(error) => block.give_up(error.message),
        }
        families(&mut block, paper, self, (&readings, &refuted), evidence.scale.as_deref());
        block
    }
}

/// The places of the refuted cells.
fn refuted(finding: &TableFinding<'_>) -> Vec<(usize, usize)> {
    let places = finding.cells.iter().enumerate().flat_map(|(row, cells)| {
        cells.iter().enumerate().map(move |(column, cell)| ((row, column), cell))
    });
    let refuted = places.filter(|(_, cell)| cell.verdict == Verdict::Refuted);
    refuted.map(|(place, _)| place).collect()
}

fn sound(cell: &SoundCell) -> String {
    let SoundCell { row, column, levels, block, value } = cell;
    format!("sound {} {} {levels} {block} {value}", row + 1, column + 1)
}

/// Writes the families that show that cells are refuted, and that a reading is no luck: of the
/// cells whose parameters are all stated, and of the cells that are reproduced.
fn families(
    block: &mut Block,
    paper: &Paper,
    finding: &TableFinding<'_>,
    (read, refuted): (&Readings<'_>, &[(usize, usize)]),
    scale: Option<&str>,
) {
    let cells = || finding.cells.iter().flatten();
    let plain = cells().any(|cell| cell.printed.is_some() && cell.is_plain());
    let mut family = |kind, scale, refuted: &[(usize, usize)]| {
        let search = finding.search_of(kind);
        let whole = !refuted.is_empty() || search.is_some_and(Search::takes_from_elsewhere);
        if let Some(uncomputed) = search.and_then(|search| search.uncomputed.as_ref()) {
            block.give_up(uncomputed.cap.to_string());
            return;
        }
        match readings(paper, finding, kind) {
            Ok(readings) => family::lines(block, &readings, whole, scale, refuted),
            Err(error) => block.give_up(error.message),
        }
    };
    if plain && !(refuted.is_empty() && read.is_empty()) {
        family(CellKind::Plain, scale, refuted);
    }
    if cells().any(|cell| cell.verdict == Verdict::Reproduced) {
        family(CellKind::Assumed, None, &[]);
    }
}

/// The line of a cell after its row and column.
fn line(cell: &CellFinding, readings: &Readings<'_>, at: (usize, usize)) -> Result<String, String> {
    let value = cell.exact.as_ref().map_or("undefined".to_owned(), closed);
    let judged = cell.verdict_if_assumed.as_ref().unwrap_or(&cell.verdict);
    let mut line = match &cell.printed {
        None if cell.is_blank() => format!("blank {value}"),
        None => format!("lost {value}"),
        Some(printed) => format!("\"{printed}\" {value} {}", verdict(cell, judged, readings, at)?),
    };
    if !cell.is_plain() {
        line.push_str(" assuming");
        let names = cell.assumed.iter().map(|(name, _)| name).chain(&cell.unknown);
        names.for_each(|name| line.extend([" ", name]));
    }
    Ok(line)
}

fn verdict(
    cell: &CellFinding,
    verdict: &Verdict,
    readings: &Readings<'_>,
    at: (usize, usize),
) -> Result<String, String> {
    let read = |slip: Option<&Slip>| {
        let read = cell.as_read.as_ref().ok_or("a cell is read differently, without a value")?;
        let (rounding, by) = readings.by(read, slip, at)?;
        let slip = slip.map_or(String::new(), |slip| format!(" misprint {}", name(slip)));
        Ok::<String, String>(format!("other-reading {}{rounding}{slip}{by}", closed(&read.value)))
    };
    Ok(match verdict {
        Verdict::Confirmed => Word::Confirmed.into(),
        Verdict::Rounding(direction) => format!("rounding {}", way(*direction)),
        Verdict::Misprint(slip) if cell.as_read.is_some() => read(Some(slip))?,
        Verdict::Misprint(slip) => format!("misprint {}", name(slip)),
        Verdict::OtherReading => read(None)?,
        Verdict::Reproduced => match &cell.as_read {
            None => Word::Reproduced.into(),
            Some(read) => {
                let (_, by) = readings.by(read, None, at)?;
                format!("reproduced {}{by}", closed(&read.value))
            }
        },
        Verdict::Refuted if cell.verdict_if_assumed.is_some() => "differs".to_owned(),
        Verdict::Refuted => Word::Refuted.into(),
        Verdict::NotCheckable(_) if cell.unknown.is_some() => "unknown".to_owned(),
        Verdict::NotCheckable(Missing::Capacity(cap)) => return Err(cap.to_string()),
        Verdict::NotCheckable(missing) => return Err(format!("a cell is not judged: {missing}")),
    })
}

fn way(direction: Direction) -> &'static str {
    match direction {
        Direction::Cut => "cut",
        Direction::Away => "away",
        Direction::DepthDown => "down",
        Direction::DepthNearest => "nearest",
    }
}

fn name(slip: &Slip) -> String {
    match slip {
        Slip::Digit { position, .. } => format!("digit {position}"),
        Slip::Swap(position) => format!("swap {position}"),
        Slip::Exponent(places) => format!("exponent {places}"),
        Slip::Sign => "sign".to_owned(),
        Slip::Neighbour(rows, columns) => format!("neighbour {rows} {columns}"),
        Slip::Exchanged(rows, columns) => format!("exchanged {rows} {columns}"),
    }
}
