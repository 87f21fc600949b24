//! Pages of audits: files in a folder, whole or not at all.

use super::{TemporaryFile, assert_parts, refused, written};
use std::fs::{read_dir, read_to_string, remove_dir_all, write};

const PAPER: &str = "examples/my-paper.toml";

#[test]
fn a_page_for_each_paper_and_an_index() {
    let folder = std::env::temp_dir().join(format!("subcert-{}-pages", std::process::id()));
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
    let message = refused(["audit", PAPER, "-o", "pages"]);
    assert_parts(&message, &["-o is the folder of --format html"]);
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
    let folder = std::env::temp_dir().join(format!("subcert-{}-index", std::process::id()));
    let path = folder.to_str().expect("a UTF-8 path");
    let message = refused(["audit", file.path(), "--format", "html", "-o", path]);
    assert_parts(&message, &["a paper of the key `index`", "another key"]);
    assert!(!folder.exists(), "half-written");
}
