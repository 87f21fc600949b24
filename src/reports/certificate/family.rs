//! The family of readings of a table: the number of cells that each of them explains, and its
//! values in the refuted cells.

use super::block::{Block, closed, words};
use super::reading;
use crate::audit::{Difference, Effect, Explanation};
use std::collections::BTreeMap;

/// The numbers of cells that a member explains with decimals to the nearest, cut, and away, and its
/// values in the refuted cells.
type Member = (BTreeMap<usize, usize>, Vec<String>);

/// Writes the lines `family`, `scale`, `values` and `member`. They are about all readings of the
/// table if this is the `whole` family, and otherwise about those that take no quantity from
/// another place of the paper.
pub(super) fn lines(
    block: &mut Block,
    readings: &[Explanation],
    whole: bool,
    scale: Option<&str>,
    refuted: &[(usize, usize)],
) {
    let copied = |reading: &&Explanation| reading.differences.iter().any(Difference::is_copied);
    let most = |of: bool| {
        let part = readings.iter().filter(|reading| copied(reading) == of);
        part.map(Explanation::count).max()
    };
    let best = [most(false), most(true).filter(|_| whole)].into_iter().flatten();
    let best: Vec<String> = best.map(|most| most.to_string()).collect();
    block.line(format!("family {}", best.join(" ")));
    if let Some(scale) = scale {
        block.line(format!("scale {scale}"));
    }
    // Members are sorted by the number of their differences, and then by these.
    let mut members: BTreeMap<(usize, Vec<String>), Member> = BTreeMap::new();
    // The line `scale` covers the readings with another scale.
    let listed = |reading: &&Explanation| reading.solved.is_empty() && (whole || !copied(reading));
    for reading in readings.iter().filter(listed) {
        let value = |(row, column): &(usize, usize)| {
            reading.values[*row][*column].as_ref().map_or("undefined".to_owned(), closed)
        };
        match differences(reading) {
            Ok((differences, rounding)) => {
                let member = members.entry((differences.len(), differences)).or_default();
                member.0.insert(rounding, reading.count());
                member.1 = refuted.iter().map(value).collect();
            }
            Err(why) => return block.give_up(why),
        }
    }
    // Each value is listed once, in the order of the members.
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

/// The differences of a reading apart from its rounding of decimals, and the place of that rounding
/// among the ways of its choice.
fn differences(reading: &Explanation) -> Result<(Vec<String>, usize), String> {
    let (mut names, mut rounding) = (Vec::new(), 0);
    for difference in &reading.differences {
        match difference {
            Difference::Way(choice, way) if choice.effect == Effect::Decimal => {
                let place = choice.ways.iter().position(|other| other == *way);
                rounding = place.unwrap_or(0);
            }
            other => {
                let name = reading::member(other);
                names.push(name.ok_or("a parameter is read differently, which is no member")?);
            }
        }
    }
    names.sort();
    Ok((names, rounding))
}
