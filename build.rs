//! Lists the schemes of the catalogue and the claim files of papers. Each is one TOML file; the
//! program contains every such file of the two folders.

use std::error::Error;
use std::fs::{read_dir, read_to_string, write};
use std::path::{Path, PathBuf};

type Result<T> = std::result::Result<T, Box<dyn Error>>;

fn main() -> Result<()> {
    println!("cargo::rerun-if-changed=build.rs");
    let schemes = toml_files("src/scheme/catalogue")?;
    list("catalogue.rs", &schemes, |name, text| format!("({name}, {text})"))?;
    let mut papers = Vec::new();
    for file in toml_files("proofs/claims")? {
        papers.push((year(&file.path)?, file));
    }
    papers.sort();
    let papers: Vec<File> = papers.into_iter().map(|(_, file)| file).collect();
    list("papers.rs", &papers, |key, text| format!("EmbeddedPaper {{ key: {key}, text: {text} }}"))
}

/// A file; its name without the extension comes first, so that files are sorted by name.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct File {
    name: String,
    /// The path from the root of the package.
    path: PathBuf,
}

/// The TOML files of a folder, by name.
fn toml_files(folder: &str) -> Result<Vec<File>> {
    println!("cargo::rerun-if-changed={folder}");
    let mut files = Vec::new();
    for entry in read_dir(folder).map_err(|error| format!("cannot list {folder}: {error}"))? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "toml") {
            let name = path.file_stem().and_then(|name| name.to_str());
            let name = name.ok_or_else(|| format!("{} is not UTF-8", path.display()))?.to_owned();
            files.push(File { name, path });
        }
    }
    files.sort();
    Ok(files)
}

/// The year of a paper: the line `year = "2007"` of its claim file.
fn year(path: &Path) -> Result<String> {
    let text = read_to_string(path)?;
    let years = text.lines().filter_map(|line| {
        let value = line.strip_prefix("year")?.trim_start().strip_prefix('=')?;
        Some(value.trim().trim_matches(['"', '\'']).to_owned())
    });
    let year = years.into_iter().next();
    Ok(year.ok_or_else(|| format!("{} has no line `year = \"2007\"`", path.display()))?)
}

/// Writes an array with an entry for each file, made of its name and its text as Rust expressions.
fn list(output: &str, files: &[File], entry: impl Fn(&str, &str) -> String) -> Result<()> {
    let line = |file: &File| {
        let path = format!("/{}", file.path.display());
        let text = format!("include_str!(concat!(env!(\"CARGO_MANIFEST_DIR\"), {path:?}))");
        format!("    {},\n", entry(&format!("{:?}", file.name), &text))
    };
    let lines: String = files.iter().map(line).collect();
    let folder = std::env::var("OUT_DIR")?;
    Ok(write(Path::new(&folder).join(output), format!("[\n{lines}]\n"))?)
}
