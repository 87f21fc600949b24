//! Certificates that keep every side condition, and such that violate exactly one.
//!
//! A file of `rejected` or `malformed` says in a comment, `#! LINE REASON`, where and why it
//! is refused.

use std::collections::BTreeSet;
use std::path::Path;
use subcert_check::{Outcome, Rejection, Report, check};

const CLAIMS: &str = include_str!("rules/claims.toml");

const PROJECT: &str = include_str!("rules/project.toml");

/// The claim file that a certificate of a folder is about. The tables of a paper share the luck that is allowed, so that
/// those that the certificate does not name are left out, unless it takes quantities from other places.
pub fn claims(folder: &str, certificate: &str) -> String {
    if folder.starts_with("project") {
        return PROJECT.to_owned();
    }
    let names: BTreeSet<&str> = certificate.split_whitespace().collect();
    // Other numbers of the points of a scheme stand in no other table.
    let elsewhere = certificate.replace("scheme@row", "").contains('@');
    let mut claims = String::new();
    for (place, part) in CLAIMS.split("\n[[").enumerate() {
        let id = part.lines().find_map(|line| line.strip_prefix("id = "));
        let named = id.is_some_and(|id| names.contains(id.trim_matches('"')));
        if !part.starts_with("table]]") || named || elsewhere {
            claims.push_str(if place > 0 { "\n[[" } else { "" });
            claims.push_str(part);
        }
    }
    claims
}

/// The names and texts of the certificates of a folder.
pub fn certificates(folder: &str) -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/rules").join(folder);
    let files = std::fs::read_dir(&folder).expect("a folder");
    let mut certificates: Vec<(String, String)> = files
        .map(|file| {
            let path = file.expect("a file").path();
            let text = std::fs::read_to_string(&path).expect("a text");
            (path.file_stem().expect("a name").to_string_lossy().into_owned(), text)
        })
        .collect();
    certificates.sort();
    certificates
}

/// What is refused in a report, and whether it is only left open.
fn refused(report: &Report) -> Vec<(&Rejection, bool)> {
    let claims = report.claims.iter().filter_map(|(_, _, outcome)| match outcome {
        Outcome::Invalid(_, rejection) => Some((rejection, false)),
        Outcome::Incomplete(rejection) => Some((rejection.as_ref()?, true)),
        Outcome::Valid | Outcome::Cited(_) => None,
    });
    report.broken.iter().map(|(_, rejection)| (rejection, false)).chain(claims).collect()
}

/// The name of a reason, without what it says.
fn name(rejection: &Rejection) -> String {
    let name = format!("{:?}", rejection.reason);
    name.split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default().to_owned()
}

#[test]
fn what_keeps_every_side_condition_is_accepted() {
    let mut count = 0;
    let of = |folder: &'static str| certificates(folder).into_iter().map(move |one| (folder, one));
    for (folder, (file, text)) in of("accepted").chain(of("project/accepted")) {
        let report = check(&claims(folder, &text), &[&text]).expect("a claim file");
        assert!(refused(&report).is_empty(), "{file}: {:?}", refused(&report));
        let accepted = |outcome: &Outcome| matches!(outcome, Outcome::Valid | Outcome::Cited(_));
        let count_accepted = report.claims.iter().filter(|(_, _, outcome)| accepted(outcome));
        assert!(text.contains(&format!("\nend {}\n", count_accepted.count())), "{file}");
        count += 1;
    }
    assert!(count >= 30);
}

#[test]
fn what_violates_one_is_rejected_for_that() {
    let (mut reasons, mut wrong) = (BTreeSet::new(), Vec::new());
    for folder in ["rejected", "malformed", "project/rejected"] {
        for (file, text) in certificates(folder) {
            let (_, expected) = text.rsplit_once("#! ").expect("an expectation");
            let report = check(&claims(folder, &text), &[&text]).expect("a claim file");
            let [(rejection, open)] = refused(&report)[..] else {
                wrong.push(format!("{folder}/{file}: {:?}", refused(&report)));
                continue;
            };
            let found = format!("{} {}", rejection.line, name(rejection));
            let left_open = ["endless", "open", "theorem-open", "unknown-field", "undecided"]
                .contains(&&*file)
                || file.starts_with("theorem-premise")
                || file.starts_with("relation-open")
                || file.starts_with("beyond-");
            if found != expected.trim() || open != left_open {
                wrong.push(format!("{folder}/{file}: {found}, {}", rejection.reason));
            }
            reasons.insert(name(rejection));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    // Every reason that there is has a certificate that is refused for it.
    let source = include_str!("../src/text/reject.rs");
    let (_, declared) = source.split_once("    Reason:\n").expect("the reasons");
    let (declared, _) = declared.split_once("\n}").expect("their end");
    // Those of files of theorems are met in the tests of these.
    let (declared, _) = declared.split_once("    Form(").expect("the reasons of theorems");
    for line in declared.lines().map(str::trim) {
        let reason = line.split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default();
        assert!(reason.is_empty() || reasons.contains(reason), "{reason} is never met");
    }
}
