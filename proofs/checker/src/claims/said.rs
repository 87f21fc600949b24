//! The verdict that a certificate states for its claim, in a few words. It is true only if the
//! certificate is valid.

use crate::text::{Block, Promise, Verdict};

/// The longest number that is shown whole.
const LONGEST: usize = 60;

/// The verdict; for a table, how many cells have each verdict; for a refuted theorem, with both
/// sides.
pub fn said(kind: &str, block: &Block<'_>) -> String {
    if kind == "table" {
        return cells(block);
    }
    let (mut verdict, mut failing) = (None, 0);
    let mut sides = Vec::new();
    for line in block.lines() {
        match line.word() {
            ("case", _) => failing += 1,
            ("sides", both) => sides.extend(both.split_once(' ')),
            (word, rest) => verdict = Verdict::named(word).map(|word| (word, rest)).or(verdict),
        }
    }
    let words: Vec<&str> = verdict.map_or("", |(_, rest)| rest).split_whitespace().collect();
    let verdict = match (verdict, &words[..]) {
        (None, _) => "not checkable".to_owned(),
        // For a function: the parameter, and both sides there.
        (Some((word, _)), [at, left, right]) => {
            format!("{word}: {} is not {}, at {at}", shortened(left), shortened(right))
        }
        (Some((Verdict::Rounding, how)), [_, ..]) => format!("{}, {how}", Verdict::Rounding),
        (Some((word, _)), [] | ["1" | "reals"]) => word.to_string(),
        (Some((Verdict::Fails, "all")), _) => format!("{} in a case", Verdict::Fails),
        (Some((Verdict::Fails, cases)), _) => {
            format!("{} in {failing} of {cases} cases", Verdict::Fails)
        }
        (Some((word, cases)), _) => format!("{word} in {cases} cases"),
    };
    let sides: Vec<String> = sides
        .into_iter()
        .map(|(left, right)| format!("{} > {}", shortened(left), shortened(right)))
        .collect();
    if sides.is_empty() { verdict } else { format!("{verdict}: {}", sides.join(", and ")) }
}

/// `12 confirmed, 3 refuted; promises: 8 kept, 1 broken`.
fn cells(block: &Block<'_>) -> String {
    let (mut cells, mut promises) = (Counts::default(), Counts::default());
    for line in block.lines() {
        match line.word() {
            // After the printed text, the exact value, the verdict, and what belongs to it.
            ("cell", rest) => match rest.rsplit_once('"') {
                Some((_, found)) => {
                    let mut words = found.split_whitespace().skip(1);
                    let verdict = words.next().unwrap_or_default();
                    let assumed = words.any(|word| word == "assuming")
                        && Verdict::named(verdict) != Some(Verdict::Reproduced);
                    let assumed = if assumed { ", assuming" } else { "" };
                    cells.add(&format!("{verdict}{assumed}"));
                }
                // Nothing is claimed where nothing is printed.
                None if rest.split_whitespace().nth(2) == Some("blank") => {}
                None => cells.add("lost"),
            },
            (word, _) => {
                if let Some(promise @ (Promise::Kept | Promise::Broken)) = Promise::named(word) {
                    promises.add(promise.name());
                }
            }
        }
    }
    match promises.text() {
        none if none.is_empty() && cells.0.is_empty() => "nothing is printed".to_owned(),
        none if none.is_empty() => cells.text(),
        promises => format!("{}; promises: {promises}", cells.text()),
    }
}

/// How often each word occurs, in the order of their first occurrences.
#[derive(Default)]
pub struct Counts(Vec<(String, usize)>);

impl Counts {
    /// Counts a word.
    pub fn add(&mut self, word: &str) {
        match self.0.iter_mut().find(|(known, _)| *known == word) {
            Some((_, count)) => *count += 1,
            None => self.0.push((word.to_owned(), 1)),
        }
    }

    /// `12 confirmed, 3 refuted`.
    pub fn text(&self) -> String {
        let texts = self.0.iter().map(|(word, count)| format!("{count} {word}"));
        texts.collect::<Vec<String>>().join(", ")
    }
}

/// A number, or the first characters of a long one.
fn shortened(number: &str) -> String {
    if number.chars().count() <= LONGEST {
        return number.to_owned();
    }
    let start: String = number.chars().take(LONGEST).collect();
    format!("{start}…")
}
