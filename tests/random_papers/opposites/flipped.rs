//! The same block with another verdict.

use crate::random_papers::program::Block;

/// Verdicts that say that a printed number is right, and that it is wrong.
const RIGHT: [&str; 1] = ["confirmed"];
const ROUNDED: [&str; 4] = ["rounding cut", "rounding away", "rounding down", "rounding nearest"];
const SLIPS: [&str; 5] = [
    "misprint sign",
    "misprint exponent 1",
    "misprint exponent -1",
    "misprint digit 1",
    "misprint neighbour 0 1",
];
const WRONG: [&str; 2] = ["refuted", "differs"];

/// All verdicts that exclude this one.
fn exclude(verdict: &str) -> Vec<&'static str> {
    let groups: [&[&str]; 4] = [&RIGHT, &ROUNDED, &SLIPS, &WRONG];
    let own = verdict.split(' ').next().unwrap_or_default();
    let of = |group: &[&str]| group.iter().any(|other| other.starts_with(own));
    let others = groups.iter().filter(|group| !of(group));
    if own == "other-reading" {
        Vec::new()
    } else {
        others.flat_map(|group| group.iter().copied()).collect()
    }
}

/// Blocks with one line changed, or with the lines of failing cases left out or made up.
pub fn against(block: &Block) -> Vec<Block> {
    let lines: Vec<String> = block.lines().into_iter().map(str::to_owned).collect();
    let mut others = Vec::new();
    let mut change = |lines: &[String]| others.push(block.with_lines(lines));
    match &block.kind[..] {
        "table" => {
            for (at, line) in lines.iter().enumerate() {
                let Some((before, verdict)) =
                    line.starts_with("cell ").then(|| line.rsplit_once('"')).flatten().and_then(
                        |(before, rest)| {
                            let (value, verdict) = rest.trim().split_once(' ')?;
                            Some((format!("{before}\" {value}"), verdict))
                        },
                    )
                else {
                    continue;
                };
                let (verdict, assumed) = match verdict.split_once(" assuming") {
                    Some((verdict, names)) => (verdict, format!(" assuming{names}")),
                    None => (verdict, String::new()),
                };
                // Each cell has one turn in four, by its place.
                if at % 4 != lines.len() % 4 {
                    continue;
                }
                for other in exclude(verdict) {
                    let mut lines = lines.clone();
                    lines[at] = format!("{before} {other}{assumed}");
                    change(&lines);
                }
            }
        }
        "equation" => {
            let shorter = |word: &str| -> Vec<String> {
                let kept = lines.iter().filter(|line| !line.starts_with("case "));
                let flip = |line: &String| match line.split_once(' ') {
                    Some(("holds" | "fails", cases)) => format!("{word} {cases}"),
                    _ => line.clone(),
                };
                kept.map(flip).collect()
            };
            if lines.iter().any(|line| line.starts_with("fails ")) {
                change(&shorter("holds"));
            } else {
                for case in ["case = 1", "case 1 = 1", "case = a", "case 0 = a", "case 2 = a"] {
                    change(&[shorter("fails"), vec![case.to_owned()]].concat());
                }
            }
        }
        "range" | "function" => {
            let verdict = block.verdict().to_owned();
            let before = &lines[..lines.len() - 1];
            let with = |last: &str| [before, &[last.to_owned()]].concat();
            let words: &[&str] = match verdict.split(' ').next() {
                Some("holds") => &["fails 0 0 1", "fails 1 1 0"],
                Some("fails") => &["holds"],
                Some("exact") => &["rounding", "inexact"],
                Some("rounding") => &["exact", "inexact"],
                _ => &["exact", "rounding"],
            };
            for word in words {
                change(&with(word));
            }
            // The claim that it has one sign everywhere.
            if verdict.starts_with("fails") {
                let kept = before
                    .iter()
                    .filter(|line| !line.starts_with("breaks") && !line.starts_with("signs"));
                let kept: Vec<String> = kept.cloned().collect();
                change(
                    &[kept, vec!["breaks".to_owned(), "signs 0".to_owned(), "holds".to_owned()]]
                        .concat(),
                );
            }
        }
        _ => {}
    }
    others
}
