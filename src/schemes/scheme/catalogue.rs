//! The schemes of the catalogue. Each is a small TOML file in the format of user files; a table `[catalogue]` at its end
//! says what is known of its rules beyond themselves.

use super::definition::{CatalogueFacts, SchemeDefinition};
use super::file::read_scheme;
use super::toml_file::from_toml;
use crate::diagnostic::SourceText;
use std::sync::OnceLock;

/// A catalogue entry.
pub type Entry = SchemeDefinition;

/// Every file of the folder `catalogue`, in the order of the names, as listed by
/// `build.rs`.
const FILES: &[(&str, &str)] = &include!(concat!(env!("OUT_DIR"), "/catalogue.rs"));

/// The schemes of the catalogue, in the order of their names.
///
/// # Panics
/// Never: the files are part of the program, and a test reads them all.
pub fn catalogue() -> &'static [Entry] {
    static CATALOGUE: OnceLock<Vec<Entry>> = OnceLock::new();
    CATALOGUE.get_or_init(|| {
        let read = |(name, text): &(&str, &str)| {
            let (rules, facts) = text.split_once("\n[catalogue]\n").unwrap_or((text, ""));
            let source = |text| SourceText::new(format!("catalogue/{name}.toml"), text);
            let facts: Result<CatalogueFacts, _> = from_toml(&source(facts));
            let read = facts.and_then(|facts| Ok(Entry { facts, ..read_scheme(&source(rules))? }));
            read.unwrap_or_else(|error| panic!("{error}"))
        };
        FILES.iter().map(read).collect()
    })
}

/// The scheme of the catalogue with this name, if there is one.
#[must_use]
pub fn find(name: &str) -> Option<&'static Entry> {
    catalogue().iter().find(|entry| entry.name == name)
}
