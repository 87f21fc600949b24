//! The example of FORMAT.md is what it says, and its pages are complete.

use std::collections::BTreeSet;
use std::fs::{read_dir, read_to_string};
use std::path::Path;
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

/// Every page of `proofs/format` stands in FORMAT.md, and every link leads to a page and a heading of it.
#[test]
fn every_link_leads_to_a_page() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../format");
    let page = |name: &str| {
        let file = name.rsplit_once('/').map_or(name, |(_, file)| file);
        let path = if file == "FORMAT.md" { folder.join("..") } else { folder.clone() };
        read_to_string(path.join(file)).unwrap_or_else(|error| panic!("{name}: {error}"))
    };
    let mut names: BTreeSet<String> = read_dir(&folder)
        .expect("a folder")
        .map(|entry| entry.expect("a page").file_name().into_string().expect("a name"))
        .collect();
    names.insert("FORMAT.md".to_owned());
    for name in &names {
        assert!(
            name == "FORMAT.md" || page("FORMAT.md").contains(&format!("(format/{name})")),
            "{name}"
        );
        for link in page(name).split("](").skip(1).filter_map(|rest| rest.split_once(')')) {
            let (to, heading) = link.0.split_once('#').unwrap_or((link.0, ""));
            let text = page(if to.is_empty() { name } else { to });
            let mut headings = text.lines().filter(|line| line.starts_with('#'));
            let is = |line: &str| {
                line.trim_start_matches(['#', ' ']).to_lowercase().replace(' ', "-") == heading
            };
            assert!(heading.is_empty() || headings.any(is), "{name}: {}", link.0);
        }
    }
}
