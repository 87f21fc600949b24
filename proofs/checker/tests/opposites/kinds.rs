//! The claims of `tests/rules` that have valid certificates, and their opposites: another printed number, another
//! right side, a bound that is a million times as large or small.

use super::suite::{Claim, Falsehood, Pair, Suite};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

const CLAIMS: &str = include_str!("../rules/claims.toml");

/// Claims that no certificate shows or refutes.
const NEITHER: &str = r#"
[[theorem]]
id = "shallow"
scheme = "chaikin"
bounds = "depth"
by = '-7'
[[theorem]]
id = "shallow-not"
scheme = "chaikin"
bounds = "depth"
by = '-7*beta'
"#;

/// The most lines of a certificate, so that all are quick to check.
const MOST_LINES: usize = 60;

/// What stands in a claim, and in its opposite.
struct Change {
    claim: [String; 2],
    certificate: [String; 2],
    /// A verdict that is false of the opposite.
    wrong: &'static [&'static str],
    /// The lines that are about this.
    of: String,
}

/// The lines of the certificates that are accepted, by the kind and the id of their claims.
fn accepted() -> BTreeMap<String, Vec<String>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/rules/accepted");
    let mut blocks = BTreeMap::new();
    let mut files: Vec<_> = std::fs::read_dir(folder)
        .expect("a folder")
        .map(|file| file.expect("a file").path())
        .collect();
    files.sort();
    for file in files {
        let text = std::fs::read_to_string(file).expect("a text");
        let mut head = String::new();
        let lines =
            text.lines().skip(2).filter(|line| !line.starts_with('#') && !line.trim().is_empty());
        let mut block: Vec<String> = Vec::new();
        for line in lines {
            if line.starts_with(' ') {
                block.push(line.trim().to_owned());
            } else if let whole = std::mem::take(&mut block)
                && !head.is_empty()
            {
                blocks.insert(std::mem::replace(&mut head, line.to_owned()), whole);
            } else {
                line.clone_into(&mut head);
            }
        }
    }
    blocks.retain(|_, lines: &mut Vec<String>| lines.len() <= MOST_LINES);
    blocks
}

/// How many lines repeat texts of the claim file.
fn restated(kind: &str, lines: &[String]) -> usize {
    let last: &[&str] = match kind {
        "table" => &["value"],
        "equation" | "function" => &["right", "absent"],
        "relation" => &["states", "absent"],
        "range" => &["below", "at-most", "smoothness"],
        "theorem" => &["by", "says"],
        _ => &[],
    };
    let is_last = |line: &String| last.contains(&line.split(' ').next().unwrap_or_default());
    lines.iter().position(is_last).map_or(0, |place| place + 1)
}

/// What is said of what: the verdicts of cells, promises and claims.
fn said(kind: &str, lines: &[String]) -> BTreeMap<String, &'static str> {
    let mut said = BTreeMap::new();
    for line in lines {
        let words: Vec<&str> = line.split_whitespace().collect();
        let [word, rest @ ..] = &words[..] else { continue };
        let place = || rest.iter().take(2).copied().collect::<Vec<_>>().join(" ");
        match (*word, line.rsplit_once('"')) {
            ("cell", Some((_, found))) => {
                let class = match found.split_whitespace().nth(1).unwrap_or_default() {
                    "confirmed" | "reproduced" => "right",
                    "rounding" => "rounded",
                    "unknown" => "unknown",
                    _ => "other",
                };
                said.insert(format!("cell {}", place()), class);
            }
            ("kept", _) => _ = said.insert(format!("promise {}", place()), "kept"),
            ("broken", _) => _ = said.insert(format!("promise {}", place()), "broken"),
            _ => {}
        }
    }
    if kind != "table" {
        let words = ["holds", "fails", "exact", "rounding", "inexact", "proved", "refuted"];
        let is =
            |line: &String| words.iter().copied().find(|word| line.split(' ').next() == Some(word));
        let verdict = lines.iter().rev().find_map(is).unwrap_or_default();
        said.insert("verdict".to_owned(), verdict);
    }
    said
}

/// What changes a claim of this kind into its opposite.
fn change(kind: &str, claim: &str, lines: &[String]) -> Option<Change> {
    let found = said(kind, lines);
    let verdict = found.get("verdict").copied().unwrap_or_default();
    let line = |word: &str| claim.lines().find(|line| line.starts_with(&format!("{word} = '")));
    let text = |word: &str| Some(line(word)?.split_once('\'')?.1.rsplit_once('\'')?.0);
    let of = |word: &str, now: &str, wrong, keyword: &str| {
        let was = text(word)?;
        Some(Change {
            claim: [line(word)?.to_owned(), format!("{word} = '{now}'")],
            certificate: [format!("{keyword} {was}"), format!("{keyword} {now}")],
            wrong,
            of: "verdict".to_owned(),
        })
    };
    match (kind, verdict) {
        ("table", _) => {
            // The first cell that is confirmed, with another digit.
            let cell = lines
                .iter()
                .find(|line| line.starts_with("cell ") && line.ends_with(" confirmed"))?;
            let (place, rest) = cell.split_once(" \"")?;
            let (printed, _) = rest.split_once('"')?;
            let (last, digit) = printed.char_indices().rev().find(|(_, c)| c.is_ascii_digit())?;
            let other = char::from_digit((digit.to_digit(10)? + 5) % 10, 10)?;
            let now = format!("{}{other}{}", &printed[..last], &printed[last + 1..]);
            let (before, cells) = claim.split_once("\ncells = ")?;
            // The first cell that is printed so is in the same row.
            let changed = cells.replacen(&format!("'{printed}'"), &format!("'{now}'"), 1);
            let first = lines
                .iter()
                .find(|line| line.starts_with("cell ") && line.contains(&format!("\"{printed}\"")));
            (first == Some(cell) && changed != cells && before.len() > 1).then(|| Change {
                claim: [format!("\ncells = {cells}"), format!("\ncells = {changed}")],
                certificate: [format!("{place} \"{printed}\""), format!("{place} \"{now}\"")],
                wrong: &["right"],
                of: place.to_owned(),
            })
        }
        ("equation" | "function", "holds") => {
            of("right", &format!("({}) + 1", text("right")?), &["holds"], "right")
        }
        ("equation" | "function", "fails") => of("right", text("left")?, &["fails"], "right"),
        ("relation", "holds") => {
            // The first sign is that of the opposite, and the other signs are as they were.
            let states = text("states")?;
            let signs = [" = ", " ≠ ", " < ", " ≥ ", " > ", " ≤ "];
            let at = |sign: &&&str| states.find(**sign).unwrap_or(usize::MAX);
            let first = signs.iter().min_by_key(at).filter(|sign| states.contains(**sign))?;
            let place = signs.iter().position(|sign| sign == first)?;
            of("states", &states.replacen(first, signs[place ^ 1], 1), &["holds"], "states")
        }
        ("range", _) => {
            // The complement. No two intervals are one.
            let (word, other) =
                if line("below").is_some() { ("below", "at_most") } else { ("at_most", "below") };
            let (value, limit) = (text("value")?, text(word)?);
            let keyword = |word: &str| word.replace('_', "-");
            Some(Change {
                claim: [
                    format!("value = '{value}'\n{word} = '{limit}'"),
                    format!("value = '-({value})'\n{other} = '-({limit})'"),
                ],
                certificate: [
                    format!("value {value}\n{} {limit}", keyword(word)),
                    format!("value -({value})\n{} -({limit})", keyword(other)),
                ],
                wrong: &["exact", "rounding"],
                of: "verdict".to_owned(),
            })
        }
        ("theorem", "proved") => of("by", &format!("({})/10^6", text("by")?), &["proved"], "by"),
        ("theorem", "refuted") if text("bounds").is_none() => {
            let bounds = claim.lines().find(|line| line.starts_with("bounds = "))?;
            // Of schemes that do not diverge, and of no levels that a certificate may name.
            let most = if bounds.contains("depth") { "65" } else { "10^6*beta" };
            let diverges = claim.contains("four-point:w=1") || claim.contains("id = \"net\"");
            if diverges { None } else { of("by", most, &["refuted"], "by") }
        }
        _ => None,
    }
}

/// What an accepted block says otherwise than the valid one.
fn against(kind: String, known: BTreeMap<String, &'static str>) -> Falsehood {
    Box::new(move |lines| {
        let found = said(&kind, lines);
        let other = found
            .iter()
            .find(|(of, verdict)| known.get(*of).is_some_and(|known| known != *verdict));
        other.map(|(of, verdict)| format!("{of} is not {verdict}"))
    })
}

/// What is false of the opposite.
fn wrong(kind: String, change: &Change) -> Falsehood {
    let (of, wrong) = (change.of.clone(), change.wrong);
    Box::new(move |lines| {
        let found = said(&kind, lines);
        let verdict = found.get(&of).filter(|verdict| wrong.contains(verdict));
        verdict.map(|verdict| format!("{of} is not {verdict}"))
    })
}

/// Depths below 0: data refute no such bound.
fn neither(depth: &[String]) -> Pair {
    let claim = |id: &str, by: &str| Claim {
        head: format!("theorem {id}"),
        restated: vec!["bounds depth".to_owned(), format!("by {by}")],
        seeds: vec![depth[2..].iter().filter(|line| !line.starts_with("let ")).cloned().collect()],
        lies: vec!["refuted".to_owned(), "proved".to_owned()],
        replaced: Default::default(),
        falsehood: Box::new(|_| Some("it is not decided".to_owned())),
    };
    let claims = [claim("shallow", "-7"), claim("shallow-not", "-7*beta")];
    Pair { claims, exclusive: false, complementary: false }
}

/// The pairs.
pub fn suite() -> Suite {
    let accepted = accepted();
    let mut claims = format!("{CLAIMS}{NEITHER}");
    let mut pairs = vec![neither(&accepted["theorem depth"])];
    for segment in CLAIMS.split("\n[[").skip(1) {
        let Some((kind, claim)) = segment.split_once("]]\n") else { continue };
        let Some(id) = claim.split("id = \"").nth(1).and_then(|rest| rest.split('"').next()) else {
            continue;
        };
        let head = format!("{kind} {id}");
        let Some(lines) = accepted.get(&head) else { continue };
        // These rest on other claims.
        if lines.iter().any(|line| line.contains(" from ") && line.starts_with("recovered ")) {
            continue;
        }
        let (repeated, body) = lines.split_at(restated(kind, lines));
        let claim = claim.split("\n#").next().unwrap_or_default().trim_end();
        let Some(change) = change(kind, claim, lines) else { continue };
        let opposite = claim.replacen(&change.claim[0], &change.claim[1], 1);
        let opposite =
            opposite.replacen(&format!("id = \"{id}\""), &format!("id = \"{id}-not\""), 1);
        let _ = write!(claims, "\n[[{kind}]]\n{opposite}\n");
        let [was, now] = &change.certificate;
        let otherwise = repeated.join("\n").replacen(&was[..], now, 1);
        let last: Vec<String> =
            body.last().filter(|_| kind != "table").cloned().into_iter().collect();
        let replaced = |from: &String, to: &String| {
            if kind == "table" { [from.clone(), to.clone()] } else { Default::default() }
        };
        let one = Claim {
            head,
            restated: repeated.to_vec(),
            seeds: vec![body.to_vec()],
            lies: Vec::new(),
            replaced: replaced(now, was),
            falsehood: against(kind.to_owned(), said(kind, lines)),
        };
        let other = Claim {
            head: format!("{kind} {id}-not"),
            restated: otherwise.lines().map(str::to_owned).collect(),
            seeds: vec![body.to_vec()],
            lies: last,
            replaced: replaced(was, now),
            falsehood: wrong(kind.to_owned(), &change),
        };
        pairs.push(Pair { claims: [one, other], exclusive: false, complementary: false });
    }
    Suite { about: "paper rules", claims, pairs }
}
