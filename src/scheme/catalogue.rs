//! The named schemes, each a small TOML file of the same form as a user's own.

use super::definition::SchemeDefinition;
use super::file::read_scheme;
use crate::diagnostic::SourceText;
use std::sync::OnceLock;

/// A catalogue entry.
pub type Entry = SchemeDefinition;

/// Every file of the folder `catalogue`, by name: `build.rs` lists them.
const FILES: &[(&str, &str)] = &include!(concat!(env!("OUT_DIR"), "/catalogue.rs"));

/// The named schemes, by name.
///
/// # Panics
/// Never: the files are part of the program, and a test reads them all.
pub fn catalogue() -> &'static [Entry] {
    static CATALOGUE: OnceLock<Vec<Entry>> = OnceLock::new();
    CATALOGUE.get_or_init(|| {
        let read = |(name, text): &(&str, &str)| {
            let source = SourceText::new(format!("catalogue/{name}.toml"), *text);
            read_scheme(&source).unwrap_or_else(|error| panic!("{error}"))
        };
        FILES.iter().map(read).collect()
    })
}

/// The scheme of this name.
#[must_use]
pub fn find(name: &str) -> Option<&'static Entry> {
    catalogue().iter().find(|entry| entry.name == name)
}
