//! Tables: the value of every cell, and the verdict on what is printed.

use super::block::{Block, closed};
use super::reading::Readings;
use super::{family, promise};
use crate::audit::{
    CellFinding, Direction, Missing, Slip, SoundCell, TableFinding, Verdict, evidence,
    promise_evidence, readings,
};
use crate::claim::Paper;

pub(super) fn block(paper: &Paper, finding: &TableFinding<'_>) -> Block {
    let table = finding.table;
    let mut block = Block::new("table", &table.id);
    if let Some(scheme) = &table.scheme {
        block.restate("scheme", &scheme.reference.to_string());
    }
    block.restate("value", &table.value.text);
    let readings = Readings::of(finding);
    readings.write(&mut block, paper);
    for (row, cells) in finding.cells.iter().enumerate() {
        for (column, cell) in cells.iter().enumerate() {
            let line = line(cell, &readings, (row, column));
            block.try_line(line.map(|line| format!("cell {} {} {line}", row + 1, column + 1)));
        }
    }
    match evidence(paper, table) {
        Ok(evidence) => {
            evidence.sound.iter().for_each(|cell| block.line(sound(cell)));
            match promise_evidence(paper, finding) {
                Ok(evidence) => promise::lines(&mut block, &evidence),
                Err(error) => block.give_up(error.message),
            }
            if cells(finding).any(|cell| cell.verdict == Verdict::Refuted) {
                refuted(&mut block, paper, finding, evidence.scale.as_deref());
            }
        }
        Err(error) => block.give_up(error.message),
    }
    block
}

fn cells<'f>(finding: &'f TableFinding<'_>) -> impl Iterator<Item = &'f CellFinding> {
    finding.cells.iter().flatten()
}

fn sound(cell: &SoundCell) -> String {
    let SoundCell { row, column, levels, block, value } = cell;
    format!("sound {} {} {levels} {block} {value}", row + 1, column + 1)
}

/// What makes cells refuted: the whole family.
fn refuted(block: &mut Block, paper: &Paper, finding: &TableFinding<'_>, scale: Option<&str>) {
    if cells(finding).any(|cell| cell.printed.is_some() && !cell.assumed.is_empty()) {
        return block.give_up("some cells are refuted, and others need assumptions");
    }
    let best = finding.search.as_ref().and_then(|search| search.best.first());
    match readings(paper, finding) {
        Ok(readings) => family::lines(block, paper, &readings, best, scale),
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
    let read = |slip: &str| {
        let read = cell.as_read.as_ref().ok_or("a cell is read otherwise, without a value")?;
        let (rounding, by) = readings.by(read, at)?;
        Ok::<String, String>(format!("other-reading {}{rounding}{slip}{by}", closed(&read.value)))
    };
    Ok(match verdict {
        Verdict::Confirmed => "confirmed".to_owned(),
        Verdict::Rounding(direction) => format!("rounding {}", way(*direction)),
        Verdict::Misprint(slip) if cell.as_read.is_some() => {
            read(&format!(" misprint {}", name(slip)?))?
        }
        Verdict::Misprint(slip) => format!("misprint {}", name(slip)?),
        Verdict::OtherReading => read("")?,
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

fn name(slip: &Slip) -> Result<String, String> {
    Ok(match slip {
        Slip::Digit { position, .. } => format!("digit {position}"),
        Slip::Swap(position) => format!("swap {position}"),
        Slip::Exponent(places) => format!("exponent {places}"),
        Slip::Sign => "sign".to_owned(),
        Slip::Neighbour(rows, columns) => format!("neighbour {rows} {columns}"),
        Slip::Exchanged(..) => return Err("two cells are exchanged".to_owned()),
    })
}
