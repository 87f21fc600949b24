//! Lists the claim files of papers, from the oldest paper: the crate contains every TOML file of the
//! folder, which is a link to `proofs/claims`. Lists the findings that are theorems of Coq: those of the
//! folder `theorems`, a link to `proofs/coq/papers`, which `.ci/coq.py` compiles.

use std::error::Error;
use std::fs::{read_dir, read_to_string, write};
use std::path::Path;

const FOLDER: &str = "papers";
const THEOREMS: &str = "theorems";

/// How the second comment of a theorem begins, and the variant of `KernelProof` that it proves.
const PROVES: [(&str, &str); 8] = [
    ("It is this constant.", "Value"),
    ("It rests on this constant.", "Constant"),
    ("This bound holds.", "Sound"),
    ("This depth suffices.", "Sound"),
    ("Broken at level ", "Broken"),
    ("Broken at natural parameters ", "BrokenNaturally"),
    ("Refuted for ", "Refuted"),
    ("Refuted at natural parameters ", "RefutedNaturally"),
];

fn main() -> Result<(), Box<dyn Error>> {
    theorems()?;
    papers()
}

fn papers() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed={FOLDER}");
    println!("cargo::rerun-if-changed=build.rs");
    let mut papers = Vec::new();
    for entry in read_dir(FOLDER).map_err(|error| format!("cannot list {FOLDER}: {error}"))? {
        let file = entry?.file_name().into_string();
        let file = file.map_err(|file| format!("{} is not UTF-8", file.display()))?;
        if let Some(key) = file.strip_suffix(".toml") {
            println!("cargo::rerun-if-changed={FOLDER}/{file}");
            papers.push((year(&Path::new(FOLDER).join(&file))?, key.to_owned()));
        }
    }
    papers.sort();
    let line = |(_, key): &(String, String)| {
        let path = format!("/{FOLDER}/{key}.toml");
        let text = format!("include_str!(concat!(env!(\"CARGO_MANIFEST_DIR\"), {path:?}))");
        format!("    EmbeddedPaper {{ key: {key:?}, text: {text} }},\n")
    };
    let lines: String = papers.iter().map(line).collect();
    let folder = std::env::var("OUT_DIR")?;
    Ok(write(Path::new(&folder).join("papers.rs"), format!("[\n{lines}]\n"))?)
}

/// The year of a paper: the line `year = "2007"` of its claim file.
fn year(path: &Path) -> Result<String, Box<dyn Error>> {
    let text = read_to_string(path)?;
    let mut years = text.lines().filter_map(|line| {
        let value = line.strip_prefix("year")?.trim_start().strip_prefix('=')?;
        Some(value.trim().trim_matches(['"', '\'']).to_owned())
    });
    Ok(years.next().ok_or_else(|| format!("{} has no line `year = \"2007\"`", path.display()))?)
}

/// Writes a line `("KEY", "CLAIM", Some((ROW, COLUMN)), KernelProof::…),` for each theorem, sorted.
fn theorems() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed={THEOREMS}");
    let mut lines = Vec::new();
    for paper in read_dir(THEOREMS).map_err(|error| format!("cannot list {THEOREMS}: {error}"))? {
        let paper = paper?.path();
        println!("cargo::rerun-if-changed={}", paper.display());
        for file in read_dir(&paper)? {
            let file = file?.path();
            if file.extension().is_some_and(|extension| extension == "v") {
                println!("cargo::rerun-if-changed={}", file.display());
                let read = theorems_of(&read_to_string(&file)?);
                lines.extend(
                    read.ok_or_else(|| format!("{}: a comment is missing", file.display()))?,
                );
            }
        }
    }
    lines.sort();
    lines.dedup();
    let folder = std::env::var("OUT_DIR")?;
    Ok(write(Path::new(&folder).join("theorems.rs"), format!("[\n{}]\n", lines.concat()))?)
}

/// The lines for the theorems of a file, whose comments say what each is about.
fn theorems_of(text: &str) -> Option<Vec<String>> {
    let said: Vec<&str> = text.lines().collect();
    let head = said.first()?.strip_prefix("(** ")?;
    let (key, claim) = head.split_once(" (written by ")?.0.split_once(", ")?;
    let (_, claim) = claim.split_once(' ')?;
    let theorems = (0..said.len()).filter(|at| said[*at].starts_with("Theorem "));
    let line = |at: usize| {
        let [place, about] = [at.checked_sub(2)?, at - 1].map(|at| said[at].strip_prefix("(* "));
        let (_, proves) =
            PROVES.iter().find(|(begins, _)| about.unwrap_or("").starts_with(begins))?;
        let cell = place?.strip_prefix("row ").and_then(|place| {
            let (row, rest) = place.split_once(", column ")?;
            Some((row.parse::<usize>().ok()?, rest.split_once(':')?.0.parse::<usize>().ok()?))
        });
        Some(format!("    ({key:?}, {claim:?}, {cell:?}, KernelProof::{proves}),\n"))
    };
    theorems.map(line).collect()
}
