//! Certificates of joint spectral radii that keep every side condition, and such that violate exactly one.
//!
//! A file of `rejected` says in its last line, `#! LINE REASON`, where and why it is refused.

use std::collections::BTreeSet;
use std::path::Path;
use subcert_check::check_radius;

/// The names and texts of the certificates of a folder.
fn certificates(folder: &str) -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/radius").join(folder);
    let files = std::fs::read_dir(&folder).expect("a folder");
    let read = |path: &Path| std::fs::read_to_string(path).expect("a text");
    let paths = files.map(|file| file.expect("a file").path());
    let name = |path: &Path| path.file_stem().expect("a name").to_string_lossy().into_owned();
    paths.map(|path| (name(&path), read(&path))).collect()
}

#[test]
fn what_keeps_every_side_condition_is_accepted() {
    let found = certificates("accepted");
    assert!(found.len() >= 8);
    for (file, text) in found {
        if let Err(rejection) = check_radius(&text) {
            panic!("{file}:{}: {}", rejection.line, rejection.reason);
        }
    }
}

#[test]
fn what_violates_one_is_rejected_for_that() {
    let (mut reasons, mut wrong) = (BTreeSet::new(), Vec::new());
    for (file, text) in certificates("rejected") {
        let (_, expected) = text.rsplit_once("#! ").expect("an expectation");
        let Err(rejection) = check_radius(&text) else {
            wrong.push(format!("{file} is accepted"));
            continue;
        };
        let reason = format!("{:?}", rejection.reason);
        let reason = reason.split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default();
        if format!("{} {reason}", rejection.line) != expected.trim() {
            wrong.push(format!("{file}: {} {reason}: {}", rejection.line, rejection.reason));
        }
        reasons.insert(reason.to_owned());
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    // Every reason that there is has a certificate that is refused for it.
    let source = include_str!("../src/text/reject.rs");
    let (_, declared) = source.split_once("    RadiusReason:\n").expect("the reasons");
    let (declared, _) = declared.split_once("\n}").expect("their end");
    for line in declared.lines().map(str::trim) {
        let reason = line.split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default();
        assert!(reasons.contains(reason), "{reason} is never met");
    }
}

/// What is longer than the cap may be right.
#[test]
fn what_is_too_long_is_left_open() {
    let text = "subcert-radius 1\n".to_owned() + &"#\n".repeat(3 << 20);
    assert!(check_radius(&text).is_err_and(|rejection| rejection.given_up()));
}
