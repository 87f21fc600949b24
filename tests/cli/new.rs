//! Templates of claim files, claim files from the standard input, and what is denied of them.

use super::{assert_parts, refused, subcert, temporary, written};
use std::collections::BTreeSet;

const EVERY_FAULT: &str =
    "rounding,misprint,other-reading,refuted,not-checkable,fails,inexact,open,broken";

#[test]
fn the_template_audits_cleanly() {
    let text = written(["new", "roe-1", "-o", "-"]);
    assert!(!text.contains("KEY"), "{text}");
    let audit = ["audit", "-", "--certified", "--format", "json", "--deny", EVERY_FAULT];
    let assert = subcert(audit).stdin(text.as_str()).assert().success();
    let json: serde_json::Value =
        serde_json::from_slice(&assert.get_output().stdout).expect("JSON");
    let claims = json["papers"][0]["claims"].as_array().expect("claims");
    let kinds: BTreeSet<&str> = claims.iter().filter_map(|claim| claim["kind"].as_str()).collect();
    assert_eq!(kinds, BTreeSet::from(["equation", "number", "theorem"]));
    assert!(claims.iter().all(|claim| claim["certified"] == true), "{claims:?}");
    assert_eq!(json["papers"][0]["promises"]["kept"], 3);
    let coverage = ["coverage", "-", "--deny", "missing"];
    subcert(coverage).stdin(text.as_str()).assert().success();
}

/// What stands in comments as further tables is true too, with the value that is not stated found.
#[test]
fn the_commented_tables_of_the_template_audit_cleanly() {
    let mut within = false;
    let uncommented = |line: &str| {
        within = line.starts_with("# [[") || (within && line.starts_with('#'));
        let text = line.strip_prefix("# ").or(line.strip_prefix('#'));
        text.filter(|_| within).unwrap_or(line).to_owned() + "\n"
    };
    let text: String = written(["new", "roe-1", "-o", "-"]).lines().map(uncommented).collect();
    let audit = ["audit", "-", "--certified", "--format", "json", "--deny", EVERY_FAULT];
    let assert = subcert(audit).stdin(text.as_str()).assert().success();
    let json: serde_json::Value =
        serde_json::from_slice(&assert.get_output().stdout).expect("JSON");
    let claims = json["papers"][0]["claims"].as_array().expect("claims");
    let count = |verdict: &str| claims.iter().filter(|claim| claim["verdict"] == verdict).count();
    assert_eq!((count("confirmed"), count("reproduced"), count("holds")), (10, 3, 2));
    assert!(claims.iter().all(|claim| claim["certified"] == true), "{claims:?}");
}

/// The key of a paper that comes with the program gives its claim file.
#[test]
fn embedded_papers_are_copied() {
    let own = std::fs::read_to_string("proofs/claims/khan2019-newton.toml").expect("text");
    assert_eq!(written(["new", "khan2019-newton", "-o", "-"]), own);
}

#[test]
fn a_file_that_is_there_stays() {
    let folder = temporary("new");
    std::fs::create_dir_all(&folder).expect("a folder");
    let program = snapbox::cmd::cargo_bin!("subcert");
    let new = || {
        let mut command = std::process::Command::new(program);
        command.args(["new", "k"]).current_dir(&folder).output().expect("the program runs")
    };
    assert!(new().status.success());
    let first = std::fs::read_to_string(folder.join("k.toml")).expect("a file");
    std::fs::write(folder.join("k.toml"), format!("{first}# mine\n")).expect("a file");
    let second = new();
    let message = String::from_utf8_lossy(&second.stderr).into_owned();
    let kept = std::fs::read_to_string(folder.join("k.toml")).expect("a file");
    std::fs::remove_dir_all(&folder).expect("the folder is still there");
    assert_eq!(second.status.code(), Some(2));
    assert_parts(&message, &["`k.toml` is there already", "-o FILE"]);
    assert!(kept.ends_with("# mine\n"));
    assert_parts(&refused(["new", "../k"]), &["`../k` cannot be a key", "letters"]);
}

/// `-` is a claim file wherever one is accepted, and errors call it the standard input.
#[test]
fn the_standard_input_is_a_claim_file() {
    let text = std::fs::read_to_string("examples/my-paper.toml").expect("the example");
    for command in [
        &["audit", "-"][..],
        &["explain", "doe2026-corner:table-1", "-"],
        &["errata", "-"],
        &["coverage", "-"],
        &["prove", "-", "-o", "-"],
    ] {
        let assert = subcert(command.iter().copied()).stdin(text.as_str()).assert().success();
        assert!(!assert.get_output().stdout.is_empty(), "{command:?}");
    }
    let wrong = subcert(["audit", "-"]).stdin("key = 'k'\n").assert().code(2);
    let message = String::from_utf8_lossy(&wrong.get_output().stderr).into_owned();
    assert_parts(&message, &["standard input:1:1", "missing fields `paper` and `title`"]);
    // What is missing is named at once, also in a table of the file.
    let wrong = subcert(["audit", "-"]).stdin("[paper]\n[[table]]\nid = 't'\n").assert().code(2);
    let message = String::from_utf8_lossy(&wrong.get_output().stderr).into_owned();
    assert_parts(&message, &["missing fields `title` and `year`"]);
    let table = "key = 'k'\n[paper]\ntitle = 'T'\nyear = 2020\n[[table]]\nid = 't'\n";
    let wrong = subcert(["audit", "-"]).stdin(table).assert().code(2);
    let message = String::from_utf8_lossy(&wrong.get_output().stderr).into_owned();
    assert_parts(&message, &["`locus`"]);
    // TOML as people write it, and no more than is needed.
    let short = "key = 'k'\n[paper]\ntitle = 'T'\nyear = 2020\n[[table]]\nid = 't'\nlocus = 'Table 1'\nvalue = 'c + 1'\n\
                 columns = { name = 'c', values = [1, -2] }\ncells = [[2, -1]]\n";
    subcert(["audit", "-", "--deny", "refuted"]).stdin(short).assert().success();
    let twice = subcert(["audit", "-", "-"]).stdin(text.as_str()).assert().code(2);
    let message = String::from_utf8_lossy(&twice.get_output().stderr).into_owned();
    assert_parts(&message, &["empty or was read before"]);
}

#[test]
fn several_verdicts_are_denied_at_once() {
    let deny = ["audit", "examples/first-paper.toml", "--deny", "broken,refuted,fails"];
    let output = subcert(deny).assert().code(1);
    let message = String::from_utf8_lossy(&output.get_output().stderr).into_owned();
    assert_eq!(message, "subcert: 2 promises: broken, 1 claim: refuted\n");
    let none = ["audit", "examples/my-paper.toml", "--deny", "fails,inexact", "--deny", "misprint"];
    subcert(none).assert().success();
    let unknown = refused(["audit", "--deny", "refuted,brocken"]);
    assert_parts(&unknown, &["'brocken'", "similar value exists: 'broken'"]);
}
