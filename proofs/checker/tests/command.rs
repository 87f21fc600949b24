//! What the program says by its exit code.

use std::process::{Command, Output};

/// The exit code for a certificate of the rules' claims.
fn code(arguments: &[&str], certificate: &str) -> Option<i32> {
    run(arguments, certificate).status.code()
}

fn text(output: &[u8]) -> String {
    String::from_utf8_lossy(output).into_owned()
}

/// What the program does with a certificate of the rules' claims.
fn run(arguments: &[&str], certificate: &str) -> Output {
    let rules = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/rules");
    Command::new(env!("CARGO_BIN_EXE_subcert-check"))
        .args(arguments)
        .arg(format!("{rules}/claims.toml"))
        .arg(format!("{rules}/{certificate}.cert"))
        .output()
        .expect("the program runs")
}

/// What is cited or open passes only where that is accepted.
#[test]
fn exit_codes() {
    let counted = ["--only", "counted"];
    let cited = "accepted/theorem-cited";
    assert_eq!(code(&counted, cited), Some(1));
    assert_eq!(code(&["--only", "counted", "--accept", "cited"], cited), Some(0));
    assert_eq!(code(&["--only", "counted", "--accept", "open"], cited), Some(1));
    assert_eq!(code(&["--accept", "cited"], cited), Some(1), "the other claims are asked for");
    let invalid = "rejected/theorem-no-statement";
    assert_eq!(code(&["--accept", "cited", "--accept", "open"], invalid), Some(1));
    assert_eq!(code(&["--accept", "all"], cited), Some(2));
    assert_eq!(code(&counted, "accepted/no-such-file"), Some(2));
}

/// Cases that were tried prove nothing; that they were passes only where open claims are accepted.
#[test]
fn what_is_tried_is_open() {
    let tried = "rejected/relation-open";
    let only = ["--only", "powers-of-two"];
    assert_eq!(code(&only, tried), Some(1));
    // A claim at least has to be certified or cited.
    assert_eq!(code(&["--only", "powers-of-two", "--accept", "open"], tried), Some(1));
    let shown = text(&run(&only, tried).stdout);
    assert!(shown.contains("incomplete  rules:powers-of-two: the claim is open"), "{shown}");
    let every = text(&run(&["--only", "cubic"], "accepted/relation-cubic").stdout);
    assert!(every.contains("certified   rules:cubic: fails in a case"), "{every}");
    let every = text(&run(&["--only", "members"], "accepted/relation-members").stdout);
    assert!(every.contains("certified   rules:members: holds in all cases"), "{every}");
}

/// What is certified is the verdict, not that the claim is right.
#[test]
fn verdicts_are_shown_with_both_sides() {
    let refuted = run(&["--only", "rules:distance"], "accepted/theorem-distance");
    assert_eq!(
        text(&refuted.stdout),
        "certified   rules:distance: refuted: 1/16 > 1/28\n1 certified, 0 cited, 0 invalid, 0 incomplete\n"
    );
    let table = run(&["--only", "plain"], "accepted/table-plain");
    assert_eq!(
        text(&table.stdout),
        "certified   rules:plain: 1 confirmed, 2 rounding\n1 certified, 0 cited, 0 invalid, 0 incomplete\n"
    );
    let unequal = text(&run(&["--only", "unequal"], "accepted/function-unequal").stdout);
    assert!(unequal.contains(": fails: ") && unequal.contains(" is not "), "{unequal}");
    let cited = text(&run(&["--only", "counted"], "accepted/theorem-cited").stdout);
    assert!(cited.contains(", says THEOREMS.md, "), "{cited}");
}

/// A certificate in place of the claim file is named as what it is.
#[test]
fn a_missing_claim_file_is_named() {
    let tests = concat!(env!("CARGO_MANIFEST_DIR"), "/tests");
    let cases = [
        ("rules/accepted/theorem-cited", "subcert-check CLAIMS.toml "),
        ("radius/accepted/fourpoint", "subcert-check --radius "),
    ];
    for (certificate, remedy) in cases {
        let output = Command::new(env!("CARGO_BIN_EXE_subcert-check"))
            .arg(format!("{tests}/{certificate}.cert"))
            .output()
            .expect("the program runs");
        assert_eq!(output.status.code(), Some(2));
        assert!(text(&output.stderr).contains(remedy), "{}", text(&output.stderr));
    }
}

/// `--only` takes the names that are printed, and nothing that is no name.
#[test]
fn selections() {
    let cited = "accepted/theorem-cited";
    let shown = text(&run(&[], cited).stdout);
    let line = shown.lines().find(|line| line.starts_with("cited")).expect("a cited claim");
    let name = line.split_whitespace().nth(1).expect("a name").trim_end_matches(':');
    assert!(name.contains(':'), "{name}");
    assert_eq!(code(&["--only", name, "--accept", "cited"], cited), Some(0));
    for wrong in [&["--only", "no-such-claim"][..], &["--only", "--accept"], &["--frobnicate"]] {
        let output = run(wrong, cited);
        assert_eq!(output.status.code(), Some(2), "{wrong:?}");
        assert!(output.stdout.is_empty() && !output.stderr.is_empty(), "{wrong:?}");
    }
}

#[test]
fn help_and_version_are_answers() {
    for (flag, begins) in [("--help", "usage: subcert-check"), ("-V", "subcert-check 0.")] {
        let output = Command::new(env!("CARGO_BIN_EXE_subcert-check")).arg(flag).output();
        let output = output.expect("the program runs");
        assert_eq!(output.status.code(), Some(0));
        assert!(text(&output.stdout).starts_with(begins) && output.stderr.is_empty());
    }
    let nothing = Command::new(env!("CARGO_BIN_EXE_subcert-check")).output();
    assert_eq!(nothing.expect("the program runs").status.code(), Some(2));
}

/// A file that no certificate can be is not read to its end.
#[test]
fn large_files_are_refused() {
    let path = std::env::temp_dir().join(format!("subcert-check-{}", std::process::id()));
    let file = std::fs::File::create(&path).expect("a file");
    file.set_len((64 << 20) + 1).expect("a large file");
    for flag in [Some("--depth"), Some("--radius"), None] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_subcert-check"));
        let output = command.args(flag).arg(&path).output().expect("the program runs");
        assert_eq!(output.status.code(), Some(2), "{flag:?}");
        let said = text(&output.stderr);
        assert!(said.contains("beyond a cap of the checker: 64 MiB of a file"), "{said}");
    }
    std::fs::remove_file(&path).expect("it is removed");
}
