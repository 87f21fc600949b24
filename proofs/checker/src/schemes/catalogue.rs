//! The catalogue of schemes.

use crate::text::Toml;

/// The schemes that every claim file may name, as listed by `build.rs`. They are data.
const CATALOGUE: &[&str] = &include!(concat!(env!("OUT_DIR"), "/catalogue.rs"));

/// Reads the files of the catalogue.
pub fn catalogue() -> Result<Vec<Toml>, String> {
    CATALOGUE.iter().map(|text| Toml::read(text)).collect()
}
