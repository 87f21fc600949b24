//! The family of readings behind a refuted cell: how many cells each of them explains.

use super::block::{Block, words};
use super::reading::{self, ROUNDING};
use crate::audit::{Difference, Explanation};
use crate::claim::Paper;
use std::collections::BTreeMap;

/// The differences of a member, and the cells that it explains with decimals to the
/// nearest, cut, and away.
type Members = BTreeMap<(usize, Vec<String>), BTreeMap<usize, usize>>;

/// The lines `family`, `scale` and `member`, from every reading of the table.
pub(super) fn lines(
    block: &mut Block,
    paper: &Paper,
    readings: &[Explanation],
    best: Option<&Explanation>,
    scale: Option<&str>,
) {
    let most = readings.iter().map(Explanation::count).max().unwrap_or(0);
    block.line(format!("family {}", best.map_or(most, Explanation::count)));
    if let Some(scale) = scale {
        block.line(format!("scale {scale}"));
    }
    let mut members = Members::new();
    // Those at another scale are covered by the line `scale`.
    for reading in readings.iter().filter(|reading| reading.solved.is_empty()) {
        match member(paper, reading) {
            Ok((differences, rounding)) => {
                let key = (differences.len(), differences);
                members.entry(key).or_default().insert(rounding, reading.count());
            }
            Err(why) => return block.give_up(why),
        }
    }
    for ((_, differences), counts) in members {
        let counts: Vec<String> = counts.values().map(ToString::to_string).collect();
        block.line(words(&format!("member {} : {}", differences.join(" "), counts.join(" "))));
    }
}

/// The differences of a reading, and the place of its rounding of decimals.
fn member(paper: &Paper, reading: &Explanation) -> Result<(Vec<String>, usize), String> {
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
