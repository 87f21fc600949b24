//! The schemes of the catalogue. Each is a small TOML file in the format of user files; a table `[catalogue]` at its end
//! says what is known of its rules beyond themselves.

use super::definition::{CatalogueFacts, SchemeDefinition};
use super::file::read_scheme_with;
use super::reference::split_name;
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
            let read = facts.and_then(|facts| {
                Ok(Entry { facts, ..read_scheme_with(&source(rules), &|_| None)? })
            });
            read.unwrap_or_else(|error| panic!("{error}"))
        };
        FILES.iter().map(read).collect()
    })
}

/// What is to be told of the numbers of a scheme: that they are those of several steps, where its rules are.
///
/// ```
/// use subcert::scheme::notes;
///
/// assert!(notes("sqrt3:N=5")[0].starts_with("one level is 2 steps of sqrt3"));
/// assert!(notes("loop").is_empty());
/// ```
#[must_use]
pub fn notes(scheme: &str) -> Vec<String> {
    let (name, _) = split_name(scheme);
    let steps = find(name).and_then(|entry| entry.facts.steps.as_ref());
    let told = |steps: &String| {
        format!(
            "one level is {steps} steps of {name}: all weights and eigenvalues are those of {steps} steps"
        )
    };
    steps.map(told).into_iter().collect()
}

/// The most schemes that a name describes.
const MAX_DESCRIBED: usize = 6;

/// Numbers as the names of schemes have them.
const NUMBERS: [&str; 9] = ["one", "two", "three", "four", "five", "six", "seven", "eight", "nine"];

/// The schemes that this may be another name of: whose name is the same with numbers in words, or whose name, title and
/// source have all of its words; none where these are many.
pub(super) fn described(name: &str) -> Vec<&'static Entry> {
    let name = name.to_lowercase();
    let word = |c: char| {
        let number =
            c.to_digit(10).and_then(|d| NUMBERS.get(usize::try_from(d).ok()?.checked_sub(1)?));
        number.map_or_else(|| c.to_string(), |word| format!("{word}-"))
    };
    let spelled = name.replace('√', "sqrt");
    let in_words: String = name.chars().map(word).collect::<String>().replace("--", "-");
    if let Some(entry) = find(&spelled).or_else(|| find(&in_words)) {
        return vec![entry];
    }
    let words: Vec<&str> = name
        .split(|c: char| !c.is_alphanumeric())
        .filter(|word| word.chars().count() > 2)
        .collect();
    let has_all = |entry: &&Entry| {
        let text = format!("{} {} {}", entry.name, entry.title, entry.citation).to_lowercase();
        words.iter().all(|word| text.contains(word))
    };
    let found: Vec<&Entry> = catalogue().iter().filter(has_all).collect();
    if words.is_empty() || found.len() > MAX_DESCRIBED { Vec::new() } else { found }
}

/// The scheme of the catalogue with this name, if there is one.
#[must_use]
pub fn find(name: &str) -> Option<&'static Entry> {
    catalogue().iter().find(|entry| entry.name == name)
}
