//! Lists the claim files of papers, from the oldest paper: the crate contains every TOML file of the
//! folder, which is a link to `proofs/claims`.

use std::error::Error;
use std::fs::{read_dir, read_to_string, write};
use std::path::Path;

const FOLDER: &str = "papers";

fn main() -> Result<(), Box<dyn Error>> {
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
