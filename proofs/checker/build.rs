//! Lists the schemes of the catalogue: the crate contains every TOML file of the folder.

use std::error::Error;
use std::fs::{read_dir, write};
use std::path::Path;

const FOLDER: &str = "catalogue";

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed={FOLDER}");
    println!("cargo::rerun-if-changed=build.rs");
    let mut names = Vec::new();
    for entry in read_dir(FOLDER).map_err(|error| format!("cannot list {FOLDER}: {error}"))? {
        let path = entry?.path();
        if path.extension().is_some_and(|ending| ending == "toml") {
            names.push(path.file_name().ok_or("a file without a name")?.to_owned());
        }
    }
    names.sort();
    let line = |name: &std::ffi::OsString| {
        let path = format!("/{FOLDER}/{}", name.display());
        format!("    include_str!(concat!(env!(\"CARGO_MANIFEST_DIR\"), {path:?})),\n")
    };
    let lines: String = names.iter().map(line).collect();
    let folder = std::env::var("OUT_DIR")?;
    Ok(write(Path::new(&folder).join("catalogue.rs"), format!("[\n{lines}]\n"))?)
}
