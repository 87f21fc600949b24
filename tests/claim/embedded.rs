//! The papers that are part of the program: every claim file of the folder, by year.

use std::collections::BTreeSet;
use std::fs::read_dir;
use subcert::claim::embedded_papers;
use subcert::scheme::catalogue;

/// The TOML files of a folder, without the extension.
fn files(folder: &str) -> BTreeSet<String> {
    let root = env!("CARGO_MANIFEST_DIR");
    let entries = read_dir(format!("{root}/{folder}")).expect("the folder");
    let names = entries.map(|entry| entry.expect("a file").file_name());
    let names = names.map(|name| name.into_string().expect("a name in UTF-8"));
    names.filter_map(|name| name.strip_suffix(".toml").map(str::to_owned)).collect()
}

#[test]
fn every_claim_file_is_embedded_under_its_key_by_year() {
    let papers = embedded_papers().unwrap_or_else(|error| panic!("{error}"));
    let keys: BTreeSet<String> = papers.iter().map(|paper| paper.key.clone()).collect();
    assert_eq!(keys, files("proofs/claims"));
    assert!(papers.is_sorted_by_key(|paper| (&paper.bibliography.year, &paper.key)));
}

#[test]
fn every_scheme_file_is_in_the_catalogue_by_name() {
    let names: BTreeSet<String> = catalogue().iter().map(|entry| entry.name.clone()).collect();
    assert_eq!(names, files("src/schemes/scheme/catalogue"));
    assert!(catalogue().is_sorted_by_key(|entry| &entry.name));
}
