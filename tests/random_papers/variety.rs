//! The papers are of all kinds: none of the properties is about nothing.

use crate::random_papers::draft::{Draft, Known};
use crate::random_papers::program::{blocks, judged, read, written};
use std::collections::BTreeMap;

/// What there is at least once.
pub const NEEDED: [&str; 26] = [
    "Clear",
    "Shadowing",
    "Ambiguous",
    "cell confirmed",
    "cell misprint",
    "cell other-reading",
    "cell refuted",
    "cell differs",
    "table kept",
    "table broken",
    "table flow",
    "equation holds",
    "equation fails",
    "function holds",
    "function fails",
    "range inexact",
    "theorem difference Curve proved",
    "theorem difference Curve refuted",
    "theorem difference Net refuted",
    "theorem difference LocalRules proved",
    "theorem difference LocalRules refuted",
    "theorem step Curve refuted",
    "theorem step LocalRules proved",
    "theorem distance Curve refuted",
    "theorem distance LocalRules refuted",
    "theorem depth Curve refuted",
];

/// How often each verdict stands in these papers, by the kind of claim, and of theorems by what they
/// bound and of what scheme.
pub fn counts(drafts: &[Draft]) -> BTreeMap<String, usize> {
    let mut counts = BTreeMap::new();
    let mut count = |what: String| *counts.entry(what).or_insert(0) += 1;
    for draft in drafts {
        let text = draft.text();
        count(format!("{:?}", draft.names.mood));
        let Ok(paper) = read(&text) else {
            count("refused".to_owned());
            continue;
        };
        if let Err(error) = judged(&paper) {
            count(format!("not judged: {}", error.lines().next().unwrap_or_default()));
            continue;
        }
        for block in blocks(&written(&text).unwrap_or_default()) {
            let claim = draft.claims.iter().find(|claim| claim.id == block.id).expect("a claim");
            let shape = match &claim.known {
                Known::Bound(bound) => {
                    let shape = format!("{:?}", bound.instances[0].shape);
                    let shape = shape.split('(').next().unwrap_or_default().to_owned();
                    format!("{} {shape} ", bound.quantity)
                }
                _ => String::new(),
            };
            match claim.kind {
                "table" => {
                    for line in block.lines() {
                        let word = |at: usize| line.split_whitespace().nth(at).unwrap_or_default();
                        count(match word(0) {
                            "cell" => format!("cell {}", word(5)),
                            word => format!("table {word}"),
                        });
                    }
                }
                kind => {
                    let verdict = block.verdict().split(' ').next().unwrap_or_default().to_owned();
                    let word = block
                        .lines()
                        .iter()
                        .map(|line| line.split(' ').next().unwrap_or_default().to_owned())
                        .find(|word| ["holds", "fails"].contains(&&word[..]))
                        .unwrap_or(verdict);
                    count(format!("{kind} {shape}{word}"));
                }
            }
        }
    }
    counts
}
