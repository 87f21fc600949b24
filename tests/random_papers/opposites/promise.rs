//! Promises that are kept and broken: the data of a table with other printed numbers.

use crate::random_papers::draft::{Claim, Draft};
use crate::random_papers::program::{Block, blocks, written};

const WORDS: [&str; 11] = [
    "witness",
    "polygon",
    "net",
    "row",
    "ring",
    "weights",
    "at",
    "kept",
    "broken",
    "flow",
    "undecided",
];

fn is_promise(line: &str) -> bool {
    let word = line.split(' ').next().unwrap_or_default();
    // `row N` of a reading has no witness before it.
    WORDS.contains(&word) && !line.contains(" from ")
}

/// The table with every printed cell the same, and its certificate.
fn twin(draft: &Draft, claim: &Claim, printed: &str) -> Option<Block> {
    let (before, cells) = claim.text.split_once("cells = [[")?;
    let count = |row: &str| row.matches("', '").count() + row.matches("}, ").count() + 1;
    let rows: Vec<String> = cells
        .split("], [")
        .map(|row| format!("[{}]", vec![format!("'{printed}'"); count(row)].join(", ")))
        .collect();
    let text = format!("{before}cells = [{}]\n", rows.join(", "));
    let twin = Claim { text, ..claim.clone() };
    blocks(&written(&draft.with([&twin]))?).pop()
}

/// The block with the promise of one cell judged as in the twin: of a table of bounds the witness of
/// a broken promise of 0, and what keeps one of 10,000.
pub fn against(draft: &Draft, claim: &Claim, own: &Block) -> Vec<Block> {
    if claim.text.contains("tolerance =")
        || !claim.text.contains("promise =")
        || claim.text.contains("note")
    {
        return Vec::new();
    }
    let lines: Vec<&str> = own.lines();
    let printed = |row: &str, column: &str| {
        let cell = format!("cell {row} {column} \"");
        let line = lines.iter().find_map(|line| line.strip_prefix(&cell))?;
        Some(line.split('"').next()?.to_owned())
    };
    let mut others = Vec::new();
    for (number, verdict) in [("0.0000001", "broken"), ("10000", "kept")] {
        let Some(twin) = twin(draft, claim, number) else { continue };
        let twins = twin.lines();
        let mut taken = 0;
        for (at, line) in lines.iter().enumerate() {
            let words: Vec<&str> = line.split(' ').collect();
            let [own_verdict @ ("kept" | "broken"), row, column, ..] = words[..] else { continue };
            if own_verdict == verdict || taken == 2 {
                continue;
            }
            let head = format!("{verdict} {row} {column}");
            let Some(place) = twins
                .iter()
                .position(|twin| *twin == head || twin.starts_with(&format!("{head} ")))
            else {
                continue;
            };
            taken += 1;
            let Some(printed) = printed(row, column) else { continue };
            let mut new: Vec<String> = lines.iter().map(|line| (*line).to_owned()).collect();
            let end = |list: &[&str], at: usize| {
                at + 1 + list[at + 1..].iter().take_while(|line| line.starts_with("flow ")).count()
            };
            let mut other: Vec<String> =
                twins[place..end(&twins, place)].iter().map(|line| (*line).to_owned()).collect();
            let mut witness = Vec::new();
            if verdict == "broken" {
                let mut words: Vec<String> = other[0].split(' ').map(str::to_owned).collect();
                let name = std::mem::replace(&mut words[3], "other".to_owned());
                printed.trim_start_matches('-').clone_into(&mut words[5]);
                other[0] = words.join(" ");
                let Some(first) = twins.iter().position(|line| *line == format!("witness {name}"))
                else {
                    continue;
                };
                witness.push("witness other".to_owned());
                let rest = twins[first + 1..].iter();
                witness.extend(
                    rest.take_while(|line| {
                        is_promise(line)
                            && !line.starts_with("witness")
                            && !line.starts_with("kept")
                            && !line.starts_with("broken")
                            && !line.starts_with("undecided")
                    })
                    .map(|line| (*line).to_owned()),
                );
            }
            let first = lines.iter().position(|line| {
                ["witness", "kept", "broken", "undecided"]
                    .contains(&line.split(' ').next().unwrap_or_default())
            });
            new.splice(at..end(&lines, at), other);
            new.splice(first.unwrap_or(at)..first.unwrap_or(at), witness);
            others.push(own.with_lines(&new));
        }
    }
    others
}
