//! What the program says to someone who comes with a claim file, or with another file, of their own.

use super::{TemporaryFile, assert_parts, refused, subcert, temporary, written};

const PAPER: &str = r#"key = "roe2027"
[paper]
title = "A ternary scheme"
year = "2027"
[[scheme]]
name = "t4"
mask = [
    ['-1/18 - mu/6', '13/18 + mu/2', '7/18 - mu/2', '-1/18 + mu/6'],
    ['-1/18 + mu/6', '7/18 - mu/2', '13/18 + mu/2', '-1/18 - mu/6'],
    ['0', '0', '1', '0'],
]
offset = '-1'
parameters.mu = { about = "tension" }
[define]
bound = 'displacement(offset = -1)*T^k/(1 - T)'
T = 'contraction(1)'
[[table]]
id = "table-1"
locus = "Table 1"
scheme = "t4:mu=1/10"
value = 'bound'
promise = { level = 'k', spread = '1' }
columns = { name = "k", values = ['1', '4'] }
cells = [['0.1264', '0.031']]
[[theorem]]
id = "theorem-1"
locus = "Theorem 1"
scheme = "t4:mu=1/10"
bounds = "distance"
by = 'beta/(2*3^k)'
from = '0'
"#;

fn file(name: &str) -> TemporaryFile {
    TemporaryFile::new(name, PAPER)
}

/// A promised bound is never corrected to less than the definition gives.
#[test]
fn a_promise_is_corrected_upwards() {
    let file = file("upwards.toml");
    let errata = written(["errata", file.path()]);
    let line = errata.lines().find(|line| line.contains("0.031 → ")).expect("the cell");
    let corrected = line.split("0.031 → ").nth(1).and_then(|rest| rest.split(' ').next());
    let json = written(["audit", file.path(), "--format", "csv"]);
    let cell = json.lines().find(|line| line.contains("table-1:1:2")).expect("the cell");
    let decimal: f64 = cell.split(',').nth(3).and_then(|text| text.parse().ok()).expect("a number");
    let corrected: f64 = corrected.and_then(|text| text.parse().ok()).expect("a number");
    assert!(corrected >= decimal && corrected - decimal < 1e-3, "{corrected} for {decimal}");
    assert!((decimal * 1e3).round() / 1e3 < decimal, "{decimal} would be rounded up anyway");
}

#[test]
fn promises_at_other_parameters() {
    let file = file("parameters.toml");
    let report = written(["audit", file.path()]);
    assert_parts(
        &report.split_whitespace().collect::<Vec<&str>>().join(" "),
        &[
            "judged again with each point at its natural parameter, (i − 1/2)/3ᵏ",
            "not that of the claim file",
        ],
    );
    let mut words = report.split_whitespace().collect::<Vec<&str>>();
    words.truncate(40);
    assert_parts(&words.join(" "), &["with points at i/nᵏ, and kept at natural parameters"]);
}

#[test]
fn hints_name_the_file() {
    let file = file("hints.toml");
    let path = file.path();
    let report = written(["audit", path]).split_whitespace().collect::<Vec<&str>>().join(" ");
    assert_parts(&report, &[&format!("subcert explain ID {path}")]);
    assert_eq!(
        written(["explain", "table-1:1:2", path]),
        written(["explain", "roe2027:table-1:1:2", path])
    );
    let hint = format!("`subcert explain roe2027 {path}` lists its claims");
    for id in ["tabel-1", "roe2027:tabel-1"] {
        assert_parts(&refused(["explain", id, path]), &["no claim `tabel-1`", "`table-1`", &hint]);
    }
    assert_parts(&refused(["explain", "doe:table-1", path]), &["no paper has the key `doe`"]);
    let list =
        written(["explain", "roe2027", path]).split_whitespace().collect::<Vec<&str>>().join(" ");
    assert_parts(&list, &[&format!("`subcert explain roe2027:ID {path}` explains one claim")]);
}

#[test]
fn certificates_are_said_of_every_claim() {
    let file = file("certified.toml");
    let folder = temporary("own-pages");
    let path = folder.to_str().expect("a UTF-8 path");
    let pages = ["audit", file.path(), "--certified", "--format", "html", "-o", path];
    subcert(pages).assert().success();
    let page = std::fs::read_to_string(folder.join("roe2027.html")).expect("a page");
    std::fs::remove_dir_all(&folder).expect("the folder is still there");
    assert_parts(
        &page,
        &["subcert-check has found the certificate valid.", "<small class=\"exact\">"],
    );
    assert_parts(&written(["audit", file.path(), "--certified"]), &["certified: table-1"]);
    let csv = written(["audit", file.path(), "--certified", "--format", "csv"]);
    assert!(csv.starts_with("id,printed,exact,decimal,verdict,certificate\n"), "{csv}");
    assert!(csv.lines().skip(1).all(|line| line.ends_with(",valid")), "{csv}");
}

#[test]
fn files_that_are_no_claim_files() {
    for (name, text, what) in [
        ("t.csv", "mu,1,2\n1/11,0.4545,0.1625\n", "a table of numbers, CSV"),
        ("t.tex", "\\begin{tabular}{c|c}\n$1$ & 2 \\\\\n\\end{tabular}\n", "LaTeX"),
        ("t.json", "{\"key\": 1}\n", "JSON"),
        ("t.html", "<!DOCTYPE html>\n", "HTML or XML"),
    ] {
        let file = TemporaryFile::new(name, text);
        let message = refused(["audit", file.path()]);
        assert_parts(
            &message,
            &[&format!("this is {what}, and no claim file"), "subcert new", ":1:1"],
        );
    }
    let cells =
        TemporaryFile::new("cells.toml", &PAPER.replace("[['0.1264', '0.031']]", "\"t.csv\""));
    assert_parts(&refused(["audit", cells.path()]), &["a file is not read", "cells = \"t.csv\""]);
    let none = TemporaryFile::new("none.toml", "key = 'k'\n[paper]\ntitle = 't'\nyear = '2027'\n");
    assert_parts(&written(["errata", none.path()]), &["There is nothing to check"]);
}

#[test]
fn what_is_there_twice() {
    let row = TemporaryFile::new(
        "row.toml",
        &PAPER.replace("'-1/18 + mu/6'],\n    ['-1/18", "'mu'],\n    ['-1/18"),
    );
    let message = refused(["audit", row.path()]);
    assert_eq!(message.matches("sums to").count(), 1, "{message}");
    let smooth = |rest: &str| {
        format!(
            "[[smoothness]]\nid = '{}'\nlocus = 'S'\nscheme = 't4:mu=1/10'\n{rest}\n",
            &rest[..3]
        )
    };
    let text = format!("{PAPER}{}{}", smooth("continuous = '2'"), smooth("not_continuous = '2'"));
    let file = TemporaryFile::new("opposed.toml", &text);
    let report =
        written(["audit", file.path()]).split_whitespace().collect::<Vec<&str>>().join(" ");
    assert_parts(&report, &["Claims that contradict each other", "that not all are C²."]);
}
