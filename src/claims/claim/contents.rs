//! The numbered items of a paper: for each, the claims about it, or why there is none.

use std::fmt;

/// The most items that one list may name.
pub const MAX_LABELS: usize = 1_000;

/// The kinds of numbered items, beside equations.
const KINDS: [&str; 9] = [
    "Algorithm",
    "Corollary",
    "Definition",
    "Example",
    "Lemma",
    "Proposition",
    "Remark",
    "Table",
    "Theorem",
];

/// The words that end the items of a locus: `(3.4) against (3.27)` is about (3.4) only.
const UNTIL: [&str; 5] = ["with", "against", "under", "after", "before"];

/// A numbered item of a paper.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Item {
    /// What the paper calls it.
    pub label: Label,
    /// The ids of the claims whose locus names it.
    pub claims: Vec<String>,
    /// Why it asserts nothing that can be checked, when no claim names it.
    pub reason: Option<String>,
}

/// What a paper calls a numbered item: `(3)`, `(2.16a)`, `Theorem 2.1`.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Label {
    /// `Theorem`, `Table` and so on; `None` for an equation.
    kind: Option<&'static str>,
    /// The number, with those of its section before it: 2 and 16 for `2.16`.
    number: Vec<u32>,
    /// The letter behind the number: `a` in `2.16a`.
    part: Option<char>,
}

impl Label {
    /// The labels of a list such as `(1)-(37)`, `Theorem 1-2` or `(3.4a)-(3.4c), (3.5)`.
    ///
    /// A range runs over the last number, or over the letters of one number.
    ///
    /// # Errors
    /// When the text is no such list, a range runs backwards, or the list has more than
    /// [`MAX_LABELS`] labels; the text of the error says which.
    ///
    /// ```
    /// use subcert::claim::Label;
    /// let labels = Label::list("(2.16a)-(2.16c), Theorem 1-2")?;
    /// let texts: Vec<String> = labels.iter().map(Label::to_string).collect();
    /// assert_eq!(texts, ["(2.16a)", "(2.16b)", "(2.16c)", "Theorem 1", "Theorem 2"]);
    /// # Ok::<(), String>(())
    /// ```
    pub fn list(text: &str) -> Result<Vec<Label>, String> {
        let mut labels = Vec::new();
        for entry in text.split(',').map(str::trim) {
            match range(entry)? {
                Some((found, "")) => extend(&mut labels, found)?,
                _ => {
                    return Err(format!(
                        "`{entry}` is neither a numbered item nor a range of them"
                    ));
                }
            }
        }
        Ok(labels)
    }

    /// The labels that a locus names before the first of the words with, against, under, after and
    /// before; other text is skipped.
    ///
    /// # Errors
    /// As [`Label::list`], for the ranges in it.
    ///
    /// ```
    /// use subcert::claim::Label;
    /// let labels = Label::in_locus("(3.4), (3.6), the rule for q_0, with (2.6)")?;
    /// let texts: Vec<String> = labels.iter().map(Label::to_string).collect();
    /// assert_eq!(texts, ["(3.4)", "(3.6)"]);
    /// # Ok::<(), String>(())
    /// ```
    pub fn in_locus(text: &str) -> Result<Vec<Label>, String> {
        let mut labels = Vec::new();
        let mut rest = text;
        let mut inside_word = false;
        while let Some(next) = rest.chars().next() {
            if !inside_word {
                let word = rest.split(|c: char| !c.is_alphabetic()).next().unwrap_or_default();
                if UNTIL.contains(&word) {
                    break;
                }
                if let Some((found, after)) = range(rest)? {
                    extend(&mut labels, found)?;
                    rest = after;
                    continue;
                }
            }
            inside_word = next.is_alphanumeric() || next == '_';
            rest = &rest[next.len_utf8()..];
        }
        Ok(labels)
    }

    /// Whether `other` is this item or, if this item has no letter, a lettered part of it.
    #[must_use]
    pub fn covers(&self, other: &Label) -> bool {
        let whole = self.part.is_none() || self.part == other.part;
        self.kind == other.kind && self.number == other.number && whole
    }
}

impl fmt::Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let number: Vec<String> = self.number.iter().map(u32::to_string).collect();
        let (number, part) = (number.join("."), self.part.map(String::from).unwrap_or_default());
        match self.kind {
            None => write!(f, "({number}{part})"),
            Some(kind) => write!(f, "{kind} {number}{part}"),
        }
    }
}

fn extend(labels: &mut Vec<Label>, found: Vec<Label>) -> Result<(), String> {
    labels.extend(found);
    if labels.len() > MAX_LABELS {
        return Err(format!("more than {MAX_LABELS} numbered items"));
    }
    Ok(())
}

/// The label, or range of labels, at the beginning of a text, and what follows it.
fn range(text: &str) -> Result<Option<(Vec<Label>, &str)>, String> {
    let Some((first, after)) = label(text) else { return Ok(None) };
    let dash = after.trim_start().strip_prefix(['-', '–']).map(str::trim_start);
    // The end of a range need not repeat the kind: `Theorem 1-2`.
    let last = dash.and_then(|rest| label(rest).or_else(|| bare(first.kind?, rest)));
    let Some((last, after)) = last else { return Ok(Some((vec![first], after))) };
    let backwards = || format!("{first} to {last} is not a range");
    let (from, to) = (first.number.split_last(), last.number.split_last());
    let (Some((from, section)), Some((to, last_section))) = (from, to) else { return Ok(None) };
    if first.kind != last.kind || section != last_section {
        return Err(backwards());
    }
    if u64::from(to.saturating_sub(*from)) >= MAX_LABELS as u64 {
        return Err(format!("more than {MAX_LABELS} numbered items"));
    }
    let labels: Vec<Label> = match (first.part, last.part) {
        (None, None) => (*from..=*to)
            .map(|number| Label { number: [section, &[number]].concat(), ..first.clone() })
            .collect(),
        (Some(a), Some(b)) if from == to => {
            (a..=b).map(|part| Label { part: Some(part), ..first.clone() }).collect()
        }
        _ => return Err(backwards()),
    };
    if labels.is_empty() { Err(backwards()) } else { Ok(Some((labels, after))) }
}

/// The label at the beginning of a text, and what follows it.
fn label(text: &str) -> Option<(Label, &str)> {
    if let Some(inner) = text.strip_prefix('(') {
        let (label, rest) = numbered(None, inner)?;
        return Some((label, rest.strip_prefix(')')?));
    }
    KINDS.iter().find_map(|kind| bare(kind, text.strip_prefix(kind)?.strip_prefix(' ')?))
}

fn bare<'t>(kind: &'static str, text: &'t str) -> Option<(Label, &'t str)> {
    let (label, rest) = numbered(Some(kind), text)?;
    // `Theorem 2nd` names nothing.
    (!rest.starts_with(|c: char| c.is_alphanumeric())).then_some((label, rest))
}

/// A label that begins with its number, `3`, `2.1` or `2.16a`, and the text behind it.
fn numbered<'t>(kind: Option<&'static str>, text: &'t str) -> Option<(Label, &'t str)> {
    let mut number = Vec::new();
    let mut rest = text;
    loop {
        let digits = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        number.push(rest[..digits].parse().ok()?);
        rest = &rest[digits..];
        match rest.strip_prefix('.') {
            Some(after) if after.starts_with(|c: char| c.is_ascii_digit()) => rest = after,
            _ => break,
        }
    }
    let part = rest.chars().next().filter(char::is_ascii_lowercase);
    Some((Label { kind, number, part }, &rest[part.map_or(0, char::len_utf8)..]))
}
