//! Pages of audits: files in a folder, whole or not at all.

use super::{TemporaryFile, assert_parts, refused, temporary, written};
use std::fs::{read_dir, read_to_string, remove_dir_all, write};

const PAPER: &str = "examples/my-paper.toml";

#[test]
fn a_page_for_each_paper_and_an_index() {
    let folder = temporary("pages");
    let path = folder.to_str().expect("a UTF-8 path");
    // Twice: what is there is replaced.
    for _ in 0..2 {
        let said = written(["audit", PAPER, "--format", "html", "-o", path]);
        assert_eq!(said, format!("{path}: 1 page, and index.html, which leads to them\n"));
    }
    let mut names: Vec<String> = read_dir(&folder)
        .expect("the folder")
        .map(|entry| entry.expect("an entry").file_name().into_string().expect("UTF-8"))
        .collect();
    names.sort();
    assert_eq!(names, ["doe2026-corner.html", "index.html"]);
    let page = read_to_string(folder.join("doe2026-corner.html")).expect("the page");
    // The command names the claim file, without which the paper is not known.
    assert!(page.contains("subcert explain doe2026-corner:table-1:1:3 examples/my-paper.toml"));
    remove_dir_all(&folder).expect("the folder goes");
}

#[test]
fn a_folder_is_needed_and_nothing_else_is_touched() {
    let message = refused(["audit", PAPER, "--format", "html"]);
    assert_parts(&message, &["--format html writes files", "-o DIR"]);
    let message = refused(["audit", PAPER, "-o", "docs"]);
    assert_parts(&message, &["is for pages", "add --format html"]);
    for command in [&["audit", PAPER][..], &["atlas", "chaikin"]] {
        let message = refused([command, &["--format", "html", "-o", "-"]].concat());
        assert_parts(
            &message,
            &["`-` is the standard output", "name a folder for them with -o DIR"],
        );
        assert!(!std::path::Path::new("-").exists(), "a folder of this name");
    }
    // Of errata, `-` is the standard output too.
    assert_eq!(written(["errata", PAPER, "-o", "-"]), written(["errata", PAPER]));
    let file = TemporaryFile::new("no-folder", "mine");
    let message = refused(["audit", PAPER, "--format", "html", "-o", file.path()]);
    assert_parts(&message, &["is no folder", "name another one with -o DIR"]);
    let below = format!("{}/pages", file.path());
    let message = refused(["audit", PAPER, "--format", "html", "-o", &below]);
    assert_parts(&message, &["cannot write", "name another folder with -o DIR"]);
    assert_eq!(read_to_string(file.path()).expect("the file"), "mine");
}

#[test]
fn no_paper_takes_the_place_of_the_index() {
    let text = read_to_string(PAPER).expect("the example").replace("doe2026-corner", "index");
    let file = TemporaryFile::new("index.toml", "");
    write(file.path(), text).expect("the file");
    let folder = temporary("index");
    let path = folder.to_str().expect("a UTF-8 path");
    let message = refused(["audit", file.path(), "--format", "html", "-o", path]);
    assert_parts(&message, &["a paper of the key `index`", "another key"]);
    assert!(!folder.exists(), "half-written");
}

#[test]
fn a_finding_goes_to_the_output_to_a_file_or_into_a_folder() {
    let explain = ["explain", "doe2026-corner:table-1:1:3", PAPER, "--format", "html"];
    let page = written(explain);
    assert!(page.starts_with("<!DOCTYPE html>") && page.contains("doe2026-corner:table-1:1:3"));
    let folder = temporary("findings");
    let path = folder.to_str().expect("a UTF-8 path");
    let said = written(explain.into_iter().chain(["-o", path]));
    assert_eq!(said, format!("{path}/doe2026-corner.table-1.1.3.html\n"));
    let file = format!("{path}/own.html");
    assert_eq!(written(explain.into_iter().chain(["-o", &file])), format!("{file}\n"));
    assert_eq!(read_to_string(&file).expect("the page"), page);
    let depth = ["depth", "catmull-clark", "--mesh", "examples/cube.obj", "--tolerance", "1/100"];
    let said = written(depth.into_iter().chain(["--format", "html", "-o", path]));
    assert_eq!(said, format!("{path}/depth-cube.html\n"));
    let page = read_to_string(folder.join("depth-cube.html")).expect("the page");
    // The command is without the place of the page.
    let command = "subcert depth catmull-clark --mesh examples/cube.obj --tolerance 1/100</code>";
    assert!(page.contains(command), "no {command}");
    remove_dir_all(&folder).expect("the folder goes");
}

#[test]
fn pages_of_depths_have_their_pictures() {
    for (arguments, titles) in [
        (
            "depth chaikin --tolerance 0.01 --polygon examples/polygon.csv",
            &[
                "Control polygon and limit",
                "The place of the greatest distance",
                "Against the level",
            ][..],
        ),
        ("depth bicubic --mesh examples/roof.csv --tolerance 1/100", &["as colours"]),
        (
            "depth bicubic --mesh examples/roof.csv --tolerance 1/100 --distance parametric",
            &["as colours", "Against the level"],
        ),
        ("depth bajaj --mesh examples/star.vtk --tolerance 1/10", &["as colours"]),
        (
            "depth bajaj --mesh examples/star.vtk --tolerance 1/10 --distance parametric",
            &["as colours", "Against the level"],
        ),
        (
            "depth doo-sabin:n=5 --tolerance 1/10",
            &["Against the level", "Control ring, level and limit"],
        ),
        (
            "depth chaikin --tolerance 1/10 --spread 2",
            &["Against the level", "Control polygon, level and limit"],
        ),
    ] {
        let page = written(arguments.split(' ').chain(["--format", "html"]));
        for title in titles {
            let found = page
                .split("<title>")
                .skip(2)
                .any(|rest| rest.split("</title>").next().is_some_and(|own| own.contains(title)));
            assert!(found, "{arguments}: no {title}");
        }
    }
}

#[test]
fn places_of_findings_are_refused_before_anything_is_computed() {
    let depth = ["depth", "chaikin", "--tolerance", "1/10"];
    let message = refused(depth.into_iter().chain(["--format", "text", "-o", "x.html"]));
    assert_parts(&message, &["`x.html` is for pages", "add --format html"]);
    let file = TemporaryFile::new("page", "mine");
    let message = refused(depth.into_iter().chain(["--format", "html", "-o", file.path()]));
    assert_parts(&message, &["is no folder", "-o DIR"]);
    assert_eq!(read_to_string(file.path()).expect("the file"), "mine");
    let message = refused(["explain", "khan2019-newton", "--format", "html"]);
    assert_parts(
        &message,
        &["name a claim", "subcert audit --paper khan2019-newton --format html -o DIR"],
    );
}

#[test]
fn a_table_is_corrected_in_latex() {
    let latex = written(["explain", "khan2019-newton:table-1", "--format", "latex"]);
    assert_parts(
        &latex,
        &["\\begin{tabular}{lrrrrrr}", "1 & \\textbf{0.0180654}$^{*}$", "0 & 0.002500 &"],
    );
}
