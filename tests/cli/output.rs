//! What the commands write.

use super::{TemporaryFile, subcert, temporary, written};
use crate::common::papers::AUDITS;
use snapbox::{assert_data_eq, file};
use subcert::audit::audit;
use subcert::claim::read_paper_file;
use subcert::report::audit_sheet;

const PAPER: &str = "examples/my-paper.toml";

#[test]
fn audit_of_the_embedded_papers() {
    subcert(["audit"]).assert().success().stdout_eq(file!["snapshots/audit.txt"]);
    let wide = subcert(["audit"]).env("COLUMNS", "80").assert().success();
    let text = String::from_utf8(wide.get_output().stdout.clone()).expect("text");
    assert!(text.lines().count() <= 60, "{text}");
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
}

/// Without files, `--full`, `--all`, a paper and a format for programs ask for more.
#[test]
fn the_report_of_the_embedded_papers() {
    for more in [&["--full"][..], &["--paper", "khan2019-newton"]] {
        let text = written([&["audit"], more].concat());
        assert!(text.contains("Summary\n") && text.contains("Read differently"), "{more:?}");
    }
}

/// The report of the embedded papers, and what the program adds to that of a small file.
#[test]
fn audit_in_full() {
    let small = read_paper_file(PAPER.as_ref()).expect("a file").expect("claims");
    let report = audit_sheet(&[audit(&small).expect("an audit")], true).to_markdown();
    let whole = written(["audit", PAPER, "--all", "--format", "markdown"]);
    let added = whole.strip_prefix(&report).expect("the report first");
    let whole = audit_sheet(&AUDITS, true).to_markdown() + added;
    assert_data_eq!(whole, file!["snapshots/audit-all.md"]);
}

/// The form; what is found in the five papers stands in the ledger of tests/audit.
#[test]
fn audit_as_json() {
    subcert(["audit", "examples/my-paper.toml", "--format", "json"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/audit.json": Text]);
}

#[test]
fn audit_of_a_claim_file() {
    subcert(["audit", "examples/my-paper.toml"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/my-paper.txt"]);
}

#[test]
fn errata_of_a_claim_file() {
    let file = "examples/my-paper.toml";
    subcert(["errata", file]).assert().success().stdout_eq(file!["snapshots/errata.md"]);
    let folder = concat!(env!("CARGO_TARGET_TMPDIR"), "/errata");
    subcert(["errata", file, "--format", "json", "-o", folder]).assert().success().stdout_eq("");
    let saved = std::fs::read_dir(folder).expect("the folder").count();
    assert_eq!(saved, 1);
    subcert(["errata", file, "-o", "Cargo.toml"]).assert().code(2);
}

#[test]
fn coverage_of_a_claim_file() {
    subcert(["coverage", "examples/my-paper.toml", "--deny", "missing"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/coverage.txt"]);
    let paper = ["coverage", "proofs/claims/mustafa2007-bajaj.toml"];
    let denied = ["--format", "json", "--deny", "unclaimed"];
    let output = subcert(paper.into_iter().chain(denied)).assert().code(1);
    let output = output.get_output();
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(json["papers"][0]["items"][0]["item"], "(1)");
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(message.contains("numbered items: unclaimed"), "{message}");
}

#[test]
fn explain_a_cell_an_equation_and_a_theorem() {
    subcert(["explain", "mustafa2020-nary:table-2:4:7"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/explain-cell.txt"]);
    subcert(["explain", "khan2022-doo-sabin:table-3:1:1"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/explain-ring-cell.txt"]);
    subcert(["explain", "khan2019-newton:eq-3.8-derivation"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/explain-equation.txt"]);
    subcert(["explain", "mustafa2007-bajaj:theorem-2"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/explain-theorem.txt"]);
}

/// A table of smoothness has each of its cells in full, and a cell has two names.
#[test]
fn explain_a_table_of_smoothness() {
    let explain = |id: &str, format: &str| {
        let id = format!("doe2026-smoothness:{id}");
        written(["explain", &id, "examples/smoothness.toml", "--format", format])
    };
    let table = explain("table-1", "text");
    let order = explain("table-1:1:1", "text");
    assert_eq!(order, explain("table-1.1.order", "text"));
    let words = |text: &str| text.split_whitespace().collect::<Vec<&str>>().join(" ");
    let whole = words(&table);
    // All lines of a cell but its title and the rule below it.
    for (cell, text) in [("1.order", order), ("3.exponent", explain("table-1:3:2", "text"))] {
        assert!(whole.contains(&format!("doe2026-smoothness:table-1.{cell} · Table 1")), "{table}");
        let facts = text.split_once("\n  ").expect("facts").1;
        assert!(facts.contains("matrices"), "{facts}");
        assert!(whole.contains(&words(facts)), "{facts} is not in {table}");
    }
    let form: serde_json::Value = serde_json::from_str(&explain("table-1", "json")).expect("JSON");
    let ids: Vec<&str> = form["claims"]
        .as_array()
        .expect("claims")
        .iter()
        .filter_map(|c| c["id"].as_str())
        .collect();
    let all = ["1.order", "2.order", "3.order", "1.exponent", "3.exponent"];
    assert_eq!(ids.len(), all.len(), "{ids:?}");
    assert!(all.iter().all(|id| ids.contains(&&format!("doe2026-smoothness:table-1.{id}")[..])));
    let page = explain("table-1", "html");
    assert!(page.contains("4 of the 5 statements of Table 1 are confirmed."), "{page}");
}

/// What a link leads to is written, whether it is there already or not; the link stays.
#[cfg(unix)]
#[test]
fn a_link_is_written_through() {
    let folder = temporary("links");
    std::fs::create_dir_all(&folder).expect("a folder");
    let (file, link, round) = (folder.join("file.txt"), folder.join("link"), folder.join("round"));
    std::os::unix::fs::symlink("file.txt", &link).expect("a link");
    std::os::unix::fs::symlink("round", &round).expect("a link");
    let write = |to: &std::path::Path| {
        subcert(["schemes", "-o", to.to_str().expect("a path")])
            .output()
            .expect("the program runs")
            .status
            .code()
    };
    for _ in 0..2 {
        assert_eq!(write(&link), Some(0));
        assert!(std::fs::read_to_string(&file).expect("the file").contains("chaikin"));
        assert!(link.is_symlink() && !file.is_symlink());
        std::fs::write(&file, "old").expect("the file");
    }
    assert_eq!(write(&round), Some(2));
    assert!(round.is_symlink());
    std::fs::remove_dir_all(&folder).expect("the folder is there");
}

#[test]
fn constants_of_a_curve_and_of_a_surface() {
    subcert(["constants", "newton:j=1,n=3", "--forward"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/constants.txt"]);
    subcert(["constants", "chaikin x four-point", "-c", "2", "--forward", "--format", "json"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/constants-surface.json": Text]);
}

#[test]
fn depth_of_a_scheme() {
    subcert(["depth", "six-point:w=3/256", "--tolerance", "1/1000", "--spread", "1/10"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/depth.txt"]);
}

#[test]
fn range_of_a_parameter() {
    subcert(["range", "six-point", "--param", "w", "-c", "5"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/range.txt"]);
    subcert(["range", "ternary-three-point", "--param", "a", "-c", "2", "--function"])
        .args(["--format", "markdown"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/range-function.md"]);
    subcert(["range", "four-point", "--param", "w", "-c", "2", "--function", "--format", "json"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/range.json": Text]);
}

#[test]
fn depth_of_a_control_polygon() {
    let polygon =
        ["depth", "four-point", "--tolerance", "1/100", "--polygon", "examples/polygon.csv"];
    subcert(polygon).assert().success().stdout_eq(file!["snapshots/depth-polygon.txt"]);
    let open = ["depth", "four-point:w=1/10", "--tolerance", "0.005", "--boundary", "open"];
    let file = ["--polygon", "examples/polygon.json", "--width", "1e-9", "--format", "json"];
    subcert(open.into_iter().chain(file))
        .assert()
        .success()
        .stdout_eq(file!["snapshots/depth-polygon.json": Text]);
}

/// Where the distance is not known exactly, or there is none, the other answers remain.
#[test]
fn depth_without_an_exact_answer() {
    subcert(["depth", "four-point:w=1", "--tolerance", "1/100", "-c", "2"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/depth-no-limit.txt"]);
    let surface = ["depth", "chaikin x chaikin", "--tolerance", "1/100", "--format", "markdown"];
    subcert(surface).assert().success().stdout_eq(file!["snapshots/depth-surface.md"]);
}

#[test]
fn depth_of_a_ring() {
    subcert(["depth", "doo-sabin:n=5", "--tolerance", "1/1000"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/ring-depth.txt"]);
    subcert(["depth", "examples/loop.toml:N=5", "--tolerance", "1/100", "--format", "json"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/ring-depth.json": Text]);
}

#[test]
fn certify_a_scheme() {
    subcert(["certify", "quinary-three-point", "-c", "2"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/certify.txt"]);
}

#[test]
fn oracle_as_csv() {
    subcert(["oracle", "chaikin", "--level", "1", "-c", "2", "--format", "csv"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/oracle.csv": Text]);
}

#[test]
fn rings() {
    subcert(["constants", "doo-sabin:n=5"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/ring-constants.txt"]);
    subcert(["constants", "catmull-clark:N=7", "-c", "2", "--format", "markdown"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/ring-constants.md"]);
    subcert(["constants", "examples/loop.toml:N=5", "-c", "2", "--format", "json"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/ring-constants.json": Text]);
    subcert(["certify", "examples/loop.toml:N=5", "-c", "2"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/ring-certify.txt"]);
    subcert(["certify", "doo-sabin:n=3", "-c", "1", "--format", "json"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/ring-certify.json": Text]);
    subcert(["oracle", "doo-sabin:n=5", "--level", "2", "-c", "1", "--format", "csv"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/ring-oracle.csv": Text]);
}

#[test]
fn schemes_of_the_catalogue() {
    subcert(["schemes"]).assert().success().stdout_eq(file!["snapshots/schemes.txt"]);
}

#[test]
fn a_denied_verdict_gives_exit_code_1_after_the_results() {
    // A range that is exact, and one that is not.
    let text = std::fs::read_to_string(PAPER).expect("the example");
    let narrow = text.replace("to = '0.5'", "to = '0.4'");
    assert_ne!(narrow, text);
    let narrow = TemporaryFile::new("narrow.toml", &narrow);
    for (file, verdict, code, says) in [
        (PAPER, "confirmed", 1, "subcert: 7 claims: confirmed\n"),
        (PAPER, "refuted", 1, "subcert: 1 claim: refuted\n"),
        (PAPER, "exact", 1, "subcert: 1 claim: exact\n"),
        (PAPER, "inexact", 0, ""),
        (narrow.path(), "inexact", 1, "subcert: 1 claim: inexact\n"),
        (narrow.path(), "exact", 0, ""),
    ] {
        let output = subcert(["audit", file, "--deny", verdict]).assert().code(code);
        let output = output.get_output();
        assert!(!output.stdout.is_empty());
        assert_eq!(String::from_utf8_lossy(&output.stderr), says, "{verdict}");
    }
}

#[test]
fn colour_goes_to_terminals_only() {
    let coloured = |command: snapbox::cmd::Command| {
        command.assert().success().get_output().stdout.contains(&0x1b)
    };
    assert!(!coloured(subcert(["audit", PAPER])));
    assert!(coloured(subcert(["audit", PAPER]).env("CLICOLOR_FORCE", "1")));
    assert!(!coloured(subcert(["audit", PAPER]).env("NO_COLOR", "1")));
}

#[test]
fn help_and_completions() {
    subcert(["--help"]).assert().success();
    subcert(["completions", "bash"]).assert().success();
    subcert(std::iter::empty()).assert().code(2);
}

/// A reader that goes away early, such as `head`, is no error.
#[cfg(unix)]
#[test]
fn a_closed_pipe_is_success() {
    use std::process::{Command, Stdio};
    for arguments in [&["audit", PAPER, "--format", "json"][..], &["--help"]] {
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        let child = Command::new(snapbox::cmd::cargo_bin!("subcert"))
            .args(arguments)
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .stdout(writer)
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let output = child.wait_with_output().expect("the program ends");
        assert!(output.status.success(), "{arguments:?}: {:?}", output.status);
        assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    }
}

#[test]
fn certificates_of_a_claim_file() {
    subcert(["audit", "examples/my-paper.toml", "--certified"])
        .assert()
        .success()
        .stdout_eq(file!["snapshots/certified.txt"]);
    let folder = temporary("prove");
    let path = folder.to_str().expect("a UTF-8 path");
    for _ in 0..2 {
        // The second time, there is something to be replaced.
        subcert(["prove", "examples/my-paper.toml", "-o", path]).assert().success();
    }
    let files: Vec<_> = std::fs::read_dir(&folder).expect("a folder").collect();
    assert_eq!(files.len(), 1, "{files:?}");
    let written = std::fs::read_to_string(folder.join("doe2026-corner.cert")).expect("a file");
    std::fs::remove_dir_all(&folder).expect("the folder is still there");
    let shown = subcert(["prove", "examples/my-paper.toml", "-o", "-"]).assert().success();
    assert_eq!(String::from_utf8_lossy(&shown.get_output().stdout), written);
}

#[test]
fn certified_claims_as_json() {
    let output = subcert(["audit", "examples/my-paper.toml", "--certified", "--format", "json"]);
    let output = output.assert().success();
    let json: serde_json::Value =
        serde_json::from_slice(&output.get_output().stdout).expect("JSON");
    let claims = json["papers"][0]["claims"].as_array().expect("claims");
    for claim in claims {
        let expected = claim["kind"] != "theorem";
        assert_eq!(claim["certified"], expected, "{claim}");
        assert_eq!(claim["certificate"] == "valid", expected, "{claim}");
    }
}
