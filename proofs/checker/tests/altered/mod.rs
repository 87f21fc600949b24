//! The committed certificates, claim by claim, and how they can be altered.

use subcert_check::{Outcome, check};

/// A claim file and its certificate.
pub struct Paper {
    /// The paper's key.
    pub key: &'static str,
    /// The claim file.
    pub claims: &'static str,
    /// The committed certificate.
    pub certificate: &'static str,
}

macro_rules! paper {
    ($key:literal) => {
        Paper {
            key: $key,
            claims: include_str!(concat!("../../../claims/", $key, ".toml")),
            certificate: include_str!(concat!("../../../certificates/", $key, ".cert")),
        }
    };
}

/// The five papers.
pub fn papers() -> [Paper; 5] {
    [
        paper!("mustafa2007-bajaj"),
        paper!("mustafa2007-ternary"),
        paper!("khan2019-newton"),
        paper!("mustafa2020-nary"),
        paper!("khan2022-doo-sabin"),
    ]
}

/// What a certificate says of a claim: its first line names it.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// The lines.
    pub lines: Vec<String>,
}

impl Block {
    /// The id of the claim.
    pub fn id(&self) -> &str {
        self.lines[0].split_once(' ').expect("a kind and an id").1
    }

    /// The lines as a text.
    pub fn text(&self) -> String {
        self.lines.join("\n")
    }
}

/// The blocks of a certificate.
pub fn blocks(certificate: &str) -> Vec<Block> {
    let mut blocks: Vec<Block> = Vec::new();
    for line in certificate.lines().skip(2).filter(|line| !line.starts_with('#')) {
        match blocks.last_mut() {
            Some(block) if line.starts_with(' ') => block.lines.push(line.to_owned()),
            _ => blocks.push(Block { lines: vec![line.to_owned()] }),
        }
    }
    let footer = blocks.pop().expect("a footer");
    assert_eq!(footer.lines, [format!("end {}", blocks.len())]);
    blocks
}

/// A certificate with one block.
pub fn certificate(paper: &Paper, block: &Block) -> String {
    format!("subcert-certificate 4\npaper {}\n{}\nend 1\n", paper.key, block.text())
}

/// Whether a certificate with this block proves a claim, or cites its proof.
pub fn accepted(paper: &Paper, block: &Block) -> bool {
    let report = check(paper.claims, &[&certificate(paper, block)]).expect("a claim file");
    let accepts = |outcome: &Outcome| matches!(outcome, Outcome::Valid | Outcome::Cited(_));
    report.claims.iter().any(|(_, _, outcome)| accepts(outcome))
}

/// Words of the format that may stand in each other's place.
pub const WORDS: [&[&str]; 25] = [
    &["confirmed", "refuted", "differs", "undefined", "lost"],
    &["confirmed", "rounding cut", "rounding away", "rounding down", "rounding nearest"],
    &[
        "misprint sign",
        "misprint exponent 1",
        "misprint neighbour 0 1",
        "misprint digit 1",
        "refuted",
    ],
    &["cut", "away", "down", "nearest"],
    &["holds", "fails"],
    &["exact", "rounding", "inexact"],
    &["equal", "belonging", "nearest", "cut", "away", "last-inside", "apart"],
    &["+", "-", "0"],
    &["adjoint", "forward"],
    &["each", "total"],
    &["contraction-terms", "displacement-terms", "order", "suprema", "recursion", "offset"],
    &["derived", "printed"],
    &["exact", "less", "more"],
    &["below", "at-most", "at-least"],
    &["naturally", "in-every-shift"],
    &["proved", "refuted", "open"],
    &["proved-by", "refuted-by", "says"],
    &["difference", "step", "distance", "depth"],
    &["kept", "broken", "undecided", "naturally"],
    &["polygon", "net", "row", "ring", "weights"],
    &["level", "tolerance", "at", "let"],
    &["grows", "times", "flow", "weights", "level"],
    &["positive", "negative", "modulus"],
    &["continuous", "not-continuous"],
    &["confirmed", "refuted", "rounding cut", "rounding away", "open"],
];

/// Every alteration of a block: lines dropped, repeated and exchanged; of every field
/// digits, signs and words changed, and fields dropped, repeated and exchanged.
pub fn alterations(block: &Block) -> Vec<Block> {
    let mut all = Vec::new();
    for i in 0..block.lines.len() {
        let mut dropped = block.clone();
        if i > 0 {
            dropped.lines.remove(i);
            all.push(dropped);
            let mut repeated = block.clone();
            repeated.lines.insert(i, block.lines[i].clone());
            all.push(repeated);
        }
        if i > 0 && i + 1 < block.lines.len() {
            let mut swapped = block.clone();
            swapped.lines.swap(i, i + 1);
            all.push(swapped);
        }
        for line in lines(&block.lines[i]) {
            let mut altered = block.clone();
            altered.lines[i] = line;
            all.push(altered);
        }
    }
    all.retain(|altered| altered != block);
    all
}

/// Every alteration of a line.
fn lines(line: &str) -> Vec<String> {
    let indent = if line.starts_with(' ') { "  " } else { "" };
    let fields: Vec<&str> = line.split_whitespace().collect();
    let mut all = Vec::new();
    for (i, field) in fields.iter().enumerate() {
        let mut with = |middle: &[&str], skip: usize| {
            let fields = [&fields[..i], middle, &fields[i + skip..]].concat();
            all.push(format!("{indent}{}", fields.join(" ")));
        };
        with(&[], 1);
        with(&[field, field], 1);
        if let Some(next) = fields.get(i + 1) {
            with(&[next, field], 2);
        }
        for other in characters(field) {
            with(&[&other], 1);
        }
        for words in WORDS.iter().filter(|words| words.contains(field)) {
            words.iter().for_each(|word| with(&[word], 1));
        }
    }
    all
}

/// Every digit made another, every sign the other, and a sign in front.
fn characters(field: &str) -> Vec<String> {
    let mut all = vec![match field.strip_prefix('-') {
        Some(rest) => rest.to_owned(),
        None => format!("-{field}"),
    }];
    for (i, c) in field.char_indices() {
        let rest = &field[i + c.len_utf8()..];
        let other = match c {
            '0'..='8' => char::from(c as u8 + 1),
            '9' => '0',
            '+' => '-',
            '-' => '+',
            _ => continue,
        };
        all.push(format!("{}{other}{rest}", &field[..i]));
    }
    all
}
