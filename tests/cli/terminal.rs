//! Widths, colours, quiet runs, and what every command says of itself.

use super::{subcert, temporary, written};
use crate::common::papers::AUDITS;
use serde_json::Value;
use subcert::report::coverage_sheet;

/// Commands whose answers are wide: exact numbers, tables of many columns, long titles.
const WIDE: [&[&str]; 10] = [
    &["audit", "examples/my-paper.toml", "--all", "--certified"],
    &["explain", "khan2019-newton"],
    &["explain", "mustafa2007-bajaj:theorem-2"],
    &["errata", "examples/my-paper.toml", "--format", "text"],
    &["coverage", "proofs/claims/khan2019-newton.toml"],
    &["constants", "newton:j=1,n=3"],
    &["constants", "catmull-clark:N=7", "-c", "2"],
    &["depth", "four-point", "--tolerance", "1/100", "--polygon", "examples/polygon.csv"],
    &["certify", "quinary-three-point", "-c", "2"],
    &["schemes"],
];

#[test]
fn nothing_is_wider_than_the_terminal() {
    let fits = |what: &[&str], text: &str, width: usize| {
        for line in text.lines() {
            let wide = line.chars().count();
            assert!(wide <= width, "{what:?}: {wide} characters, not {width}: {line}");
        }
    };
    for width in [60, 80, 120] {
        for arguments in WIDE {
            let command = subcert(arguments.iter().copied()).env("COLUMNS", width.to_string());
            let output = command.assert().success();
            let text = String::from_utf8_lossy(&output.get_output().stdout).into_owned();
            fits(arguments, &text, width);
        }
        let coverage = coverage_sheet(&AUDITS).to_text(Some(width));
        let plain = anstream::adapter::strip_str(&coverage).to_string();
        fits(&["coverage of all papers"], &plain, width);
    }
}

/// A table that is split or stacked still has every number.
#[test]
fn narrow_tables_lose_nothing() {
    let arguments = ["certify", "quinary-three-point", "-c", "2"];
    let wide = written(arguments);
    for width in ["30", "60", "80"] {
        let output = subcert(arguments).env("COLUMNS", width).assert().success();
        let narrow = String::from_utf8_lossy(&output.get_output().stdout).into_owned();
        let letters = |text: &str| text.split_whitespace().collect::<String>();
        let flat = letters(&narrow);
        let numbers =
            wide.split_whitespace().filter(|word| word.contains(|c: char| c.is_ascii_digit()));
        for number in numbers {
            assert!(flat.contains(number), "{number} at width {width}: {narrow}");
        }
    }
}

/// Lines of the source, which stand behind `|`, and words that are longer stay as they are.
#[test]
fn errors_are_no_wider_than_the_terminal() {
    let commands: [(&[&str], &str); 3] = [
        (&["depth", "chaikin", "--tolerance", "0"], "--tolerance must be positive, and is 0"),
        (&["explain", "khan2019-newton:table-1:9:99"], "a row from 1 to 3 and a column from 1 to"),
        (&["audit", "-"], "unknown field `colums`, expected one of"),
    ];
    for (arguments, said) in commands {
        let command = subcert(arguments.iter().copied()).env("COLUMNS", "60");
        let assert = command.stdin("key = 'k'\n[[table]]\ncolums = 1\n").assert().code(2);
        let message = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
        let flat = message.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(flat.contains(said), "{message}");
        for line in message.lines().filter(|line| !line.contains('|')) {
            assert!(line.chars().count() <= 60, "{line}");
        }
    }
}

/// A negative number is out of range, and no option.
#[test]
fn negative_numbers_are_told_the_range() {
    for (arguments, range) in [
        (["oracle", "chaikin", "--seed", "-1"], "from 0 to 2^64 − 1"),
        (["oracle", "chaikin", "--points", "-1"], "from 0 on"),
        (["oracle", "chaikin", "--level", "-1"], "-1 is not in 0..="),
        (["constants", "chaikin", "-c", "-1"], "-1 is not in 1..=256"),
    ] {
        let assert = subcert(arguments).assert().code(2);
        let message = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
        assert!(message.contains(range) && !message.contains("unexpected"), "{message}");
    }
}

#[test]
fn a_long_audit_ends_as_it_begins() {
    let audit = ["audit", "examples/my-paper.toml", "examples/first-paper.toml"];
    let short = written(audit);
    // What is said of a single paper stands once.
    assert!(!written(["audit", "examples/my-paper.toml"]).contains("All papers"));
    let on_screen = |lines: &str| {
        let output = subcert(audit).env("LINES", lines).assert().success();
        String::from_utf8_lossy(&output.get_output().stdout).into_owned()
    };
    let (low, high) = (on_screen("10"), on_screen("1000"));
    assert!(!high.contains("All papers") && short.contains("All papers"));
    let (before, after) = low.split_once("All papers\n").expect("a summary at the end");
    let head: Vec<&str> = after.lines().skip(1).collect();
    assert!(before.starts_with(&head.join("\n")), "{after}");
}

#[test]
fn colours_follow_the_flag() {
    let has_colour = |arguments: &[&str], variable: &str| {
        let output = subcert(arguments.iter().copied()).env(variable, "1").assert();
        let output = output.get_output();
        [&output.stdout, &output.stderr].map(|text| text.contains(&0x1b))
    };
    let audit = |flag| ["audit", "examples/my-paper.toml", "--color", flag];
    assert!(has_colour(&audit("always"), "NO_COLOR")[0]);
    assert!(!has_colour(&audit("never"), "CLICOLOR_FORCE")[0]);
    assert!(has_colour(&audit("auto"), "CLICOLOR_FORCE")[0]);
    for wrong in [&["audit", "Cargo.toml"][..], &["audit", "--frobnicate"]] {
        let with = |flag| [&["--color", flag], wrong].concat();
        assert_eq!(has_colour(&with("always"), "NO_COLOR"), [false, true], "{wrong:?}");
        assert_eq!(has_colour(&with("never"), "CLICOLOR_FORCE"), [false, false], "{wrong:?}");
    }
}

#[test]
fn quiet_leaves_errors_files_and_the_exit_code() {
    for arguments in WIDE.into_iter().chain([&["oracle", "chaikin"][..]]) {
        subcert(arguments.iter().copied().chain(["--quiet"])).assert().success().stdout_eq("");
    }
    let denied = ["-q", "audit", "examples/my-paper.toml", "--deny", "refuted"];
    let output = subcert(denied).assert().code(1).stdout_eq("");
    let message = String::from_utf8_lossy(&output.get_output().stderr).into_owned();
    assert_eq!(message, "subcert: 1 claim: refuted\n");
    assert!(!written(["new", "k", "-o", "-", "--quiet"]).is_empty());
}

/// The names of all commands.
fn commands() -> Vec<String> {
    let found: Value = serde_json::from_str(&written(["flags", "--format", "json"])).expect("JSON");
    let name = |command: &Value| command["name"].as_str().expect("a name").to_owned();
    found["commands"].as_array().expect("a list").iter().map(name).collect()
}

/// The help text of the program has every command in a group, with what it does and an example that parses.
#[test]
fn commands_stand_in_groups() {
    let help = written(["--help"]);
    let (_, groups) = help.split_once("\n\nAudit a paper").expect("the first group");
    let (groups, _) = groups.split_once("\nOptions:\n").expect("the options");
    for command in commands() {
        let lines = groups.lines().filter(|line| line.starts_with(&format!("  {command} ")));
        let lines: Vec<&str> = lines.collect();
        assert!(!lines.is_empty(), "{command} is in no group:\n{groups}");
        assert!(lines.iter().all(|line| line.len() > 20), "{command} has no description");
    }
    assert_eq!(groups.matches("(`subcert ").count(), 5, "{groups}");
}

/// The examples of every help text run, those that write files apart.
#[test]
fn examples_of_the_help_run() {
    for command in commands() {
        let help = written([&command, "--help"]);
        let (_, examples) = help.split_once("Examples:\n").unwrap_or_else(|| panic!("{help}"));
        let examples: Vec<&str> = examples.lines().map(str::trim).collect();
        assert!((2..=5).contains(&examples.len()), "{help}");
        for example in examples {
            let line = example.strip_prefix("subcert ").expect("a command");
            let folder = line.contains("-o ") && !line.ends_with("-o -");
            // What the tests of the output run, and the check of generated files for docs/atlas.md.
            let elsewhere = line.starts_with("audit")
                || ["atlas", "explain mustafa2020-nary:table-2:4:7"].contains(&line);
            if folder || ["man", "new", "serve"].contains(&&*command) || elsewhere {
                continue;
            }
            // Only schemes with ` x ` are in quotes.
            let words: Vec<&str> = match line.split('\'').collect::<Vec<&str>>()[..] {
                [before, quoted, after] => {
                    let (before, after) = (before.split_whitespace(), after.split_whitespace());
                    before.chain([quoted]).chain(after).collect()
                }
                _ => line.split_whitespace().collect(),
            };
            assert!(!written(words).is_empty(), "{example}");
        }
    }
}

#[test]
fn man_pages_of_every_command() {
    let folder = temporary("man");
    written(["man", folder.to_str().expect("a UTF-8 path")]);
    let page = |name: &str| std::fs::read_to_string(folder.join(name));
    let whole = page("subcert.1").expect("a page");
    for command in commands() {
        assert!(whole.contains(&command), "{whole}");
        let page = page(&format!("subcert-{command}.1")).expect(&command);
        assert!(page.contains("Examples:"), "{page}");
    }
    std::fs::remove_dir_all(&folder).expect("the folder is still there");
}

#[test]
fn every_json_answer_has_a_version() {
    let file = "examples/my-paper.toml";
    let commands: [&[&str]; 15] = [
        &["audit", file],
        &["explain", "doe2026-corner", file],
        &["explain", "doe2026-corner:table-1", file],
        &["explain", "weights:neighbours", "examples/weights.toml"],
        &["scheme", "chaikin", "haar"],
        &["errata", file],
        &["coverage", file],
        &["constants", "chaikin", "-c", "1"],
        &["constants", "doo-sabin:n=3", "-c", "1"],
        &["depth", "chaikin", "--tolerance", "1"],
        &["depth", "doo-sabin:n=3", "--tolerance", "1"],
        &["range", "four-point", "--param", "w", "-c", "1"],
        &["certify", "chaikin", "-c", "1"],
        &["oracle", "chaikin"],
        &["schemes"],
    ];
    for command in commands {
        let text = written(command.iter().copied().chain(["--format", "json"]));
        let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        assert_eq!(json["schema"], 1, "{command:?}");
    }
}
