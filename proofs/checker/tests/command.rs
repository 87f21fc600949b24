//! What the program says by its exit code.

use std::process::Command;

/// The exit code for a certificate of the rules' claims.
fn code(arguments: &[&str], certificate: &str) -> Option<i32> {
    let rules = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/rules");
    Command::new(env!("CARGO_BIN_EXE_subcert-check"))
        .args(arguments)
        .arg(format!("{rules}/claims.toml"))
        .arg(format!("{rules}/{certificate}.cert"))
        .output()
        .expect("the program runs")
        .status
        .code()
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
