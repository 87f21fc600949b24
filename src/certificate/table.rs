//! Tables: the value of every cell, and the verdict on what is printed.

use super::block::{Block, closed};
use super::reading::Readings;
use super::{constant, family, promise};
use crate::audit::{
    CellFinding, Direction, Missing, Slip, SoundCell, TableFinding, Verdict, evidence,
    promise_evidence, readings,
};
use crate::claim::{Cell, Paper, Promise};

pub(super) fn block(paper: &Paper, finding: &TableFinding<'_>) -> Block {
    let table = finding.table;
    let mut block = Block::new("table", &table.id);
    let readings = Readings::of(finding);
    let refuted = refuted(finding);
    let evidence = match evidence(paper, finding, !refuted.is_empty() || !readings.is_empty()) {
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
    readings.write(&mut block);
    for (row, cells) in finding.cells.iter().enumerate() {
        for (column, cell) in cells.iter().enumerate() {
            let line = line(cell, &readings, (row, column));
            block.try_line(line.map(|line| format!("cell {} {} {line}", row + 1, column + 1)));
        }
    }
    evidence.attained.iter().for_each(|constant| block.line(constant::attained(constant)));
    evidence.sound.iter().for_each(|cell| block.line(sound(cell)));
    match promise_evidence(paper, finding) {
        Ok(evidence) => {
            let is_depth = matches!(table.promise, Some(Promise::Depth { .. }));
            let printed = |row: usize, column: usize| match &table.cells[row][column] {
                Cell::Printed(printed) if is_depth => {
                    let level = printed.decimal.value().numerator().to_i64();
                    level.and_then(|level| u32::try_from(level).ok())
                }
                _ => None,
            };
            promise::lines(&mut block, &evidence, printed);
        }
        Err(error) => block.give_up(error.message),
    }
    family(&mut block, paper, finding, (&readings, &refuted), evidence.scale.as_deref());
    block
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

/// What makes cells refuted, and a reading better than luck: the whole family.
fn family(
    block: &mut Block,
    paper: &Paper,
    finding: &TableFinding<'_>,
    (read, refuted): (&Readings<'_>, &[(usize, usize)]),
    scale: Option<&str>,
) {
    let mut printed = finding.cells.iter().flatten().filter(|cell| cell.printed.is_some());
    let plain = printed.any(|cell| cell.assumed.is_empty());
    if !plain || refuted.is_empty() && read.is_empty() {
        return;
    }
    let best = finding.search.as_ref().and_then(|search| search.best.first());
    match readings(paper, finding) {
        Ok(readings) => family::lines(block, &readings, best, scale, refuted),
        Err(error) => block.give_up(error.message),
    }
}

/// What is said of a cell behind its place.
fn line(cell: &CellFinding, readings: &Readings<'_>, at: (usize, usize)) -> Result<String, String> {
    let value = cell.exact.as_ref().map_or("undefined".to_owned(), closed);
    let judged = cell.verdict_if_assumed.as_ref().unwrap_or(&cell.verdict);
    let mut line = match &cell.printed {
        None => format!("lost {value}"),
        Some(printed) => format!("\"{printed}\" {value} {}", verdict(cell, judged, readings, at)?),
    };
    if !cell.assumed.is_empty() {
        line.push_str(" assuming");
        cell.assumed.iter().for_each(|(name, _)| line.extend([" ", name]));
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
        let read = cell.as_read.as_ref().ok_or("a cell is read otherwise, without a value")?;
        let (rounding, by) = readings.by(read, slip, at)?;
        let slip = slip.map_or(String::new(), |slip| format!(" misprint {}", name(slip)));
        Ok::<String, String>(format!("other-reading {}{rounding}{slip}{by}", closed(&read.value)))
    };
    Ok(match verdict {
        Verdict::Confirmed => "confirmed".to_owned(),
        Verdict::Rounding(direction) => format!("rounding {}", way(*direction)),
        Verdict::Misprint(slip) if cell.as_read.is_some() => read(Some(slip))?,
        Verdict::Misprint(slip) => format!("misprint {}", name(slip)),
        Verdict::OtherReading => read(None)?,
        Verdict::Refuted if cell.verdict_if_assumed.is_some() => "differs".to_owned(),
        Verdict::Refuted => "refuted".to_owned(),
        Verdict::NotCheckable(Missing::Capacity(why)) => return Err(why.clone()),
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
