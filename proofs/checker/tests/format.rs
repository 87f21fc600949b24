//! The example of FORMAT.md is what it says.

use subcert_check::{Outcome, check};

/// The code blocks of FORMAT.md of this language.
fn block(language: &str) -> &'static str {
    let text = include_str!("../../FORMAT.md");
    let (_, after) = text.split_once(&format!("```{language}\n")).expect("a code block");
    after.split_once("```").expect("its end").0
}

#[test]
fn the_example_is_valid() {
    let report = check(block("toml"), &[block("text")]).expect("a claim file");
    assert!(report.broken.is_empty(), "{:?}", report.broken);
    assert_eq!(report.claims.len(), 2);
    for (_, id, outcome) in &report.claims {
        assert_eq!(*outcome, Outcome::Valid, "{id}");
    }
}

#[test]
fn every_shortened_example_is_refused() {
    let text = block("text");
    for (end, _) in text.trim_end().char_indices() {
        let report = check(block("toml"), &[&text[..end]]).expect("a claim file");
        assert!(!report.broken.is_empty(), "cut after {end} bytes");
        let valid = report.claims.iter().filter(|(_, _, outcome)| *outcome == Outcome::Valid);
        assert_eq!(valid.count(), 0);
    }
}
