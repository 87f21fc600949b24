//! The family of readings of a table: how many cells each of them explains, and its values
//! in the cells that none does.

use super::block::{Block, closed, words};
use super::reading::{self, ROUNDING};
use crate::audit::{Difference, Explanation};
use crate::claim::Paper;
use std::collections::BTreeMap;

/// The cells that a member explains with decimals to the nearest, cut, and away, and its
/// values in the refuted ones.
type Member = (BTreeMap<usize, usize>, Vec<String>);

/// The lines `family`, `scale`, `values` and `member`, from every reading of the table.
pub(super) fn lines(
    block: &mut Block,
    paper: &Paper,
    readings: &[Explanation],
    best: Option<&Explanation>,
    scale: Option<&str>,
    refuted: &[(usize, usize)],
) {
    let most = readings.iter().map(Explanation::count).max().unwrap_or(0);
    block.line(format!("family {}", best.map_or(most, Explanation::count)));
    if let Some(scale) = scale {
        block.line(format!("scale {scale}"));
    }
    // By their differences, the fewest first.
    let mut members: BTreeMap<(usize, Vec<String>), Member> = BTreeMap::new();
    // Those at another scale are covered by the line `scale`.
    for reading in readings.iter().filter(|reading| reading.solved.is_empty()) {
        let value = |(row, column): &(usize, usize)| {
            reading.values[*row][*column].as_ref().map_or("undefined".to_owned(), closed)
        };
        match differences(paper, reading) {
            Ok((differences, rounding)) => {
                let member = members.entry((differences.len(), differences)).or_default();
                member.0.insert(rounding, reading.count());
                member.1 = refuted.iter().map(value).collect();
            }
            Err(why) => return block.give_up(why),
        }
    }
    // Each value is named once, in the order of the members.
    let mut listed: Vec<Vec<&str>> = vec![Vec::new(); refuted.len()];
    let mut numbers = Vec::new();
    for (_, values) in members.values() {
        let places = listed.iter_mut().zip(values).map(|(listed, value)| {
            let known = listed.iter().position(|known| known == value);
            let place = known.unwrap_or_else(|| {
                listed.push(value);
                listed.len() - 1
            });
            (place + 1).to_string()
        });
        numbers.push(places.collect::<Vec<String>>().join(" "));
    }
    for ((row, column), values) in refuted.iter().zip(&listed) {
        block.line(format!("values {} {} {}", row + 1, column + 1, values.join(" ")));
    }
    for (((_, differences), (counts, _)), numbers) in members.iter().zip(&numbers) {
        let counts: Vec<String> = counts.values().map(ToString::to_string).collect();
        let line = format!("member {} : {}", differences.join(" "), counts.join(" "));
        let numbers = if refuted.is_empty() { String::new() } else { format!(" : {numbers}") };
        block.line(words(&format!("{line}{numbers}")));
    }
}

/// The differences of a reading, and the place of its rounding of decimals.
fn differences(paper: &Paper, reading: &Explanation) -> Result<(Vec<String>, usize), String> {
    let is_rounding = |difference: &&Difference| difference.choice == ROUNDING.0;
    let rounding = reading.differences.iter().find(is_rounding);
    let rounding = match rounding.map(|rounding| reading::way(paper, rounding)).transpose()? {
        None => 0,
        Some(way) if way.ends_with("cut") => 1,
        Some(_) => 2,
    };
    let others = reading.differences.iter().filter(|difference| !is_rounding(difference));
    let mut names =
        others.map(|other| reading::way(paper, other)).collect::<Result<Vec<String>, String>>()?;
    names.sort();
    Ok((names, rounding))
}
