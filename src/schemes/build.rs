//! Lists the schemes of the catalogue, and their wider rings: the crate contains every TOML file of these folders.

use std::error::Error;
use std::fs::{read_dir, write};
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    list("scheme/catalogue")?;
    list("spectrum/surroundings")
}

fn list(folder: &str) -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed={folder}");
    let mut names = Vec::new();
    for entry in read_dir(folder).map_err(|error| format!("cannot list {folder}: {error}"))? {
        let file = entry?.file_name().into_string();
        let file = file.map_err(|file| format!("{} is not UTF-8", file.display()))?;
        names.extend(file.strip_suffix(".toml").map(str::to_owned));
    }
    names.sort();
    let line = |name: &String| {
        let path = format!("/{folder}/{name}.toml");
        let text = format!("include_str!(concat!(env!(\"CARGO_MANIFEST_DIR\"), {path:?}))");
        format!("    ({name:?}, {text}),\n")
    };
    let lines: String = names.iter().map(line).collect();
    let file = Path::new(folder).with_extension("rs");
    let file = Path::new(&std::env::var("OUT_DIR")?).join(file.file_name().ok_or("no name")?);
    Ok(write(file, format!("[\n{lines}]\n"))?)
}
