//! Lists the schemes of the catalogue: the crate contains every TOML file of the folder.

use std::error::Error;
use std::fs::{read_dir, write};
use std::path::Path;

const FOLDER: &str = "scheme/catalogue";

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed={FOLDER}");
    println!("cargo::rerun-if-changed=build.rs");
    let mut names = Vec::new();
    for entry in read_dir(FOLDER).map_err(|error| format!("cannot list {FOLDER}: {error}"))? {
        let file = entry?.file_name().into_string();
        let file = file.map_err(|file| format!("{} is not UTF-8", file.display()))?;
        names.extend(file.strip_suffix(".toml").map(str::to_owned));
    }
    names.sort();
    let line = |name: &String| {
        let path = format!("/{FOLDER}/{name}.toml");
        let text = format!("include_str!(concat!(env!(\"CARGO_MANIFEST_DIR\"), {path:?}))");
        format!("    ({name:?}, {text}),\n")
    };
    let lines: String = names.iter().map(line).collect();
    let folder = std::env::var("OUT_DIR")?;
    Ok(write(Path::new(&folder).join("catalogue.rs"), format!("[\n{lines}]\n"))?)
}
