//! The commands on claim files of projects.

use super::{TemporaryFile, assert_parts, refused, subcert, temporary, written};

const WEIGHTS: &str = "examples/weights.toml";

#[test]
fn what_denies() {
    for (words, code) in [
        ("refuted", 0),
        ("misprint", 1),
        ("cut,refuted", 1),
        ("open,otherwise,ulps", 0),
        ("nearest", 1),
        ("confirmed", 2),
    ] {
        let run = subcert(["audit", WEIGHTS, "--deny", words]).assert().code(code);
        let message = String::from_utf8_lossy(&run.get_output().stderr).into_owned();
        assert_eq!(message.contains("1 table: misprint"), words == "misprint", "{message}");
    }
    let message = refused(["audit", "--deny", "cut"]);
    assert_parts(&message, &["said only of constants that programs ship"]);
}

#[test]
fn files_of_two_kinds_and_commands_of_papers_are_refused() {
    assert_parts(
        &refused(["audit", WEIGHTS, "examples/my-paper.toml"]),
        &["once for the projects"],
    );
    assert_parts(
        &refused(["prove", "khan2019-newton", WEIGHTS, "-o", "-"]),
        &["once for the projects"],
    );
    assert_parts(&refused(["prove", WEIGHTS, "--coq", "target"]), &["without --coq"]);
    assert_parts(&refused(["coverage", WEIGHTS]), &["about papers", "audit, explain, errata"]);
    assert_parts(
        &refused(["audit", WEIGHTS, WEIGHTS]),
        &["two of the files have the key `weights`"],
    );
    assert_parts(&refused(["explain", "weights:edge", WEIGHTS]), &["did you mean `edges`?"]);
    assert_parts(&refused(["explain", "weight:edges", WEIGHTS]), &["did you mean `weights`?"]);
}

#[test]
fn every_format() {
    assert_parts(
        &written(["audit", WEIGHTS]),
        &["± mis", "weights.c, neighbour_weight", "Right to the last bit"],
    );
    assert_parts(&written(["audit", WEIGHTS, "--certified"]), &["weights:neighbours   certified"]);
    let csv = written(["audit", WEIGHTS, "--format", "csv"]);
    assert_eq!(csv.lines().count(), 11, "{csv}");
    assert_parts(&csv, &["weights,neighbours,n=8,0.040086f,misprint,0.0400678098159402923968"]);
    let json: serde_json::Value =
        serde_json::from_str(&written(["audit", WEIGHTS, "--format", "json"])).expect("JSON");
    assert_eq!(json["projects"][0]["tables"][0]["numbers"][5]["slip"], "exchanged");
    assert_eq!(json["projects"][0]["tables"][0]["numbers"][5]["line"], 11);
    let explained = written(["explain", "weights:neighbours", WEIGHTS, "--format", "json"]);
    let explained: serde_json::Value = serde_json::from_str(&explained).expect("JSON");
    assert_eq!((&explained["schema"], &explained["id"]), (&1.into(), &"neighbours".into()));
    assert_eq!(explained["numbers"], json["projects"][0]["tables"][0]["numbers"]);
    assert_parts(&written(["audit", WEIGHTS, "--format", "latex"]), &["\\begin{tabular}"]);
    assert_parts(&written(["errata", WEIGHTS]), &["# Constants in A small program", "0.04006781"]);
    assert_parts(&written(["explain", "weights", WEIGHTS]), &["neighbours", "edges"]);
    assert_parts(&written(["explain", "weights:edges", WEIGHTS]), &["3.0 / 8.0", "k = 4"]);
    let page = written(["explain", "weights:edges", WEIGHTS, "--format", "html"]);
    assert_parts(
        &page,
        &["<!DOCTYPE html>", "As written in weights.c, all 4 numbers are the nearest f64."],
    );
}

#[test]
fn pages_and_the_standard_input() {
    let folder = temporary("projects");
    let path = folder.to_str().expect("a UTF-8 path");
    subcert(["audit", WEIGHTS, "--certified", "--format", "html", "-o", path]).assert().success();
    let index = std::fs::read_to_string(folder.join("index.html")).expect("an index");
    assert_parts(&index, &["href=\"weights.html\"", "weights:edges"]);
    let page = std::fs::read_to_string(folder.join("weights.html")).expect("a page");
    assert_parts(&page, &["id=\"neighbours\"", "All numbers"]);
    std::fs::remove_dir_all(&folder).expect("the folder is still there");
    // Paths of source files are then relative to the folder at hand.
    let text = std::fs::read_to_string(WEIGHTS).expect("a file");
    let text = text.replace("file = \"weights.c\"", "file = \"examples/weights.c\"");
    subcert(["audit", "-", "--deny", "refuted"]).stdin(text).assert().success();
}

#[test]
fn a_source_that_is_not_read_is_named_with_its_line() {
    let source = TemporaryFile::new("macro.c", "float a[2] = {\n 0.5f,\n HALF };\n");
    let claims = std::fs::read_to_string(WEIGHTS).expect("a file");
    let (head, _) = claims.split_once("[[shipped]]").expect("a table");
    let text = format!(
        "{head}[[shipped]]\nid = \"a\"\nlocus = \"a\"\ntitle = \"a\"\ntype = \"f32\"\nindices = [\"k = 1..2\"]\n\
         equals = '1/2'\ncells_from = {{ file = \"{}\", after = \"a\" }}\n",
        source.path()
    );
    let claims = TemporaryFile::new("macro.toml", &text);
    assert_parts(&refused(["audit", claims.path()]), &["macro.c:3:2", "HALF"]);
}
