//! One table of flags for all commands: who takes which, and that they do what they say.

use super::{subcert, written};
use serde_json::Value;
use snapbox::assert_data_eq;
use std::collections::BTreeMap;

/// The formats of every report.
const REPORT: [&str; 5] = ["text", "json", "markdown", "csv", "latex"];

/// Commands that answer with a report, and an answer that is found quickly.
const REPORTS: [(&str, &[&str]); 14] = [
    ("audit", &["audit", "examples/my-paper.toml"]),
    ("explain", &["explain", "doe2026-corner:eq-3", "examples/my-paper.toml"]),
    ("errata", &["errata", "examples/my-paper.toml"]),
    ("coverage", &["coverage", "examples/my-paper.toml"]),
    ("constants", &["constants", "chaikin", "-c", "1"]),
    ("depth", &["depth", "chaikin", "--tolerance", "1/10"]),
    ("range", &["range", "four-point", "w", "-c", "1"]),
    ("smoothness", &["smoothness", "chaikin"]),
    ("spectrum", &["spectrum", "doo-sabin", "--valence", "5"]),
    ("jsr", &["jsr", "examples/pair.txt"]),
    ("certify", &["certify", "chaikin", "-c", "1"]),
    ("schemes", &["schemes"]),
    ("scheme", &["scheme", "chaikin"]),
    ("atlas", &["atlas", "chaikin"]),
];

/// What answers otherwise: geometry, values and source code.
const OTHERS: [(&str, &[&str]); 4] = [
    ("oracle", &["json", "csv", "table", "matlab", "c", "rust"]),
    ("refine", &["obj", "off", "ply", "stl", "usda", "vtk", "medit", "json", "csv"]),
    ("limit", &["obj", "off", "ply", "stl", "usda", "vtk", "medit", "json", "csv"]),
    ("table", &["c", "cpp", "rust", "python", "glsl", "hlsl", "wgsl", "json"]),
];

/// What only writes files or one kind of text, or what shells read.
const WITHOUT: [&str; 6] = ["prove", "new", "plot", "serve", "completions", "man"];

/// The flags that mean one thing wherever they stand, and the commands for which they make sense.
const SHARED: [(&str, &[&str]); 11] = [
    ("paper", &["audit", "errata", "coverage"]),
    ("deny", &["audit", "coverage"]),
    ("all", &["audit", "explain"]),
    ("tolerance", &["depth", "certify"]),
    ("spread", &["depth", "certify"]),
    ("levels", &["constants", "depth", "range", "certify", "oracle"]),
    ("mesh", &["depth", "oracle", "refine", "limit"]),
    ("weld", &["depth", "oracle", "refine", "limit"]),
    ("certificate", &["depth", "smoothness", "jsr"]),
    ("valences", &["range", "smoothness", "table"]),
    ("corner", &["spectrum", "table"]),
];

type Table = BTreeMap<String, (Vec<String>, Vec<String>)>;

fn table() -> Table {
    let found: Value = serde_json::from_str(&written(["flags", "--format", "json"])).expect("JSON");
    let texts = |value: &Value| {
        let entries = value.as_array().expect("a list").iter();
        entries.map(|text| text.as_str().expect("a text").to_owned()).collect()
    };
    let row = |command: &Value| {
        let name = command["name"].as_str().expect("a name").to_owned();
        (name, (texts(&command["flags"]), texts(&command["formats"])))
    };
    found["commands"].as_array().expect("a list").iter().map(row).collect()
}

#[test]
fn commands_share_their_flags() {
    let mut table = table();
    for (flag, commands) in SHARED {
        let has = |(_, (flags, _)): &(&String, &(Vec<String>, _))| flags.iter().any(|f| f == flag);
        let mut found: Vec<&str> =
            table.iter().filter(has).map(|(name, _)| name.as_str()).collect();
        let mut expected = commands.to_vec();
        found.sort_unstable();
        expected.sort_unstable();
        assert_eq!(found, expected, "--{flag}");
    }
    for (name, _) in REPORTS {
        let (flags, mut formats) = table.remove(name).expect(name);
        formats.retain(|format| format != "html");
        let mut expected = REPORT.to_vec();
        formats.sort_unstable();
        expected.sort_unstable();
        assert_eq!(formats, expected, "{name}");
        assert!(flags.contains(&"output".to_owned()), "{name} has no --output");
    }
    for (name, expected) in OTHERS {
        let (flags, formats) = table.remove(name).expect(name);
        assert_eq!(formats, expected, "{name}");
        assert!(flags.contains(&"output".to_owned()), "{name} has no --output");
    }
    let rest: Vec<&String> = table.keys().collect();
    assert_eq!(rest.len(), WITHOUT.len(), "commands that stand in no list: {rest:?}");
    assert!(rest.iter().all(|name| WITHOUT.contains(&name.as_str())), "{rest:?}");
}

/// The page shows the table.
#[test]
fn the_page_of_flags_is_up_to_date() {
    let page = std::fs::read_to_string("docs/flags.md").expect("the page");
    assert_data_eq!(written(["flags", "--format", "markdown"]), page);
}

/// Each format of each report is what it says, and a file holds the same as the standard output.
#[test]
fn reports_come_in_every_format() {
    let file = concat!(env!("CARGO_TARGET_TMPDIR"), "/report");
    for (name, arguments) in REPORTS {
        for format in REPORT {
            let formatted = [arguments, &["--format", format]].concat();
            let text = written(formatted.iter().copied());
            let what = format!("{name} --format {format}: {text}");
            assert!(!text.trim().is_empty(), "{what}");
            match format {
                "json" => assert!(serde_json::from_str::<Value>(&text).is_ok(), "{what}"),
                "csv" => assert!(is_csv(&text), "{what}"),
                "latex" => assert!(text.contains('\\'), "{what}"),
                _ => {}
            }
            if name == "errata" {
                // A text for each paper, into a folder.
                continue;
            }
            let to_file = [&formatted[..], &["-o", file]].concat();
            subcert(to_file.iter().copied()).assert().success().stdout_eq("");
            let saved = std::fs::read_to_string(file).expect(file);
            // On a screen a long audit repeats its summary at the end.
            let repeats = (name, format) == ("audit", "text");
            assert!(saved == text || repeats && text.starts_with(&saved), "{what}\n\n{saved}");
        }
    }
}

/// Whether each row has as many fields as the header; quoted fields may have commas and lines.
fn is_csv(text: &str) -> bool {
    let (mut quoted, mut fields, mut rows) = (false, 1, Vec::new());
    for c in text.chars() {
        match c {
            '"' => quoted = !quoted,
            ',' if !quoted => fields += 1,
            '\n' if !quoted => rows.push(std::mem::replace(&mut fields, 1)),
            _ => {}
        }
    }
    !quoted && rows.len() > 1 && rows.iter().all(|row| *row == rows[0])
}
