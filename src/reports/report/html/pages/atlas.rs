//! The atlas as pages: an index of schemes, and a page for each entry of the catalogue.

use super::finding::Picture;
use crate::report::html::document::{document, document_with_script};
use crate::report::html::sheet::blocks;
use crate::report::html::typeset::typeset;
use crate::report::words::notation::unicode;
use crate::report::words::sheet::Sheet;
use maud::{Markup, html};

/// What adds a field to search and buttons to sort.
const SCRIPT: &str = include_str!("atlas.js");

/// A scheme in the index.
#[derive(Clone, Debug)]
pub struct AtlasRow {
    /// The entry, whose page is NAME.html.
    pub name: String,
    /// The scheme as it is given to a command: the entry with its parameters.
    pub scheme: String,
    /// What it is.
    pub title: String,
    /// Each cell of [`ATLAS_HEADER`] after the first: its text, and the key by which it is sorted, a number or a text, empty
    /// where there is none.
    pub cells: Vec<(String, String)>,
}

/// The columns of the index.
pub const ATLAS_HEADER: [&str; 7] =
    ["scheme", "arity", "points", "kind", "limits", "Hölder exponent", "of"];

/// A scheme on the page of its entry.
#[derive(Clone, Debug)]
pub struct SchemeSection {
    /// The scheme as it is given to a command.
    pub scheme: String,
    /// Its facts; its heading is that of the section.
    pub facts: Sheet,
    /// Its pictures.
    pub pictures: Vec<Picture>,
    /// Source code by language, or why there is none.
    pub code: Vec<(String, Result<String, String>)>,
}

/// A scheme or a family, of the catalogue or one's own.
#[derive(Clone, Debug)]
pub struct EntryPage {
    /// Its name in SCHEME.
    pub name: String,
    /// What it is.
    pub title: String,
    /// Where it was published.
    pub source: String,
    /// Its parameters with what they are.
    pub parameters: Vec<(String, String)>,
    /// Pictures of the whole family.
    pub family: Vec<Picture>,
    /// The schemes that stand for it.
    pub schemes: Vec<SchemeSection>,
    /// Claims of papers about it: what they say, and the address of a page.
    pub claims: Vec<(String, String)>,
}

/// The index of schemes. A reader without scripts has the whole table.
///
/// ```
/// use subcert::report::html::atlas_page;
///
/// assert!(atlas_page(&[]).contains("The atlas of schemes"));
/// ```
#[must_use]
pub fn atlas_page(rows: &[AtlasRow]) -> String {
    let main = html! {
        header {
            h1 { "The atlas of schemes" }
            p { "What is proven of each scheme, families at the values that stand for them. Each has a page with all facts, with pictures and with code." }
        }
        main.index id="page:main" tabindex="-1" {
            div.scroll tabindex="0" role="group" aria-label="schemes" {
                table.atlas {
                    thead { tr { @for name in ATLAS_HEADER { th scope="col" { (name) } } } }
                    tbody { @for row in rows { (index_row(row)) } }
                }
            }
        }
    };
    document_with_script("The atlas of schemes · subcert", &main, SCRIPT)
}

fn index_row(row: &AtlasRow) -> Markup {
    let texts = row.cells.iter().map(|(text, _)| text.as_str());
    let words = std::iter::once(row.scheme.as_str()).chain([row.title.as_str()]).chain(texts);
    // As it is typed, and as it is shown.
    let words = words.collect::<Vec<&str>>().join(" ");
    let words = format!("{words} {}", unicode(&words)).to_lowercase();
    html! {
        tr data-words=(words) {
            th scope="row" data-key=(row.scheme) {
                a href={ (row.name) ".html#" (anchor(&row.scheme)) } title=(row.title) { (row.scheme) }
            }
            @for ((text, key), name) in row.cells.iter().zip(&ATLAS_HEADER[1..]) {
                td data-key=(key) data-label=(name) { (typeset(text)) }
            }
        }
    }
}

/// The page of an entry, in one file that loads nothing and runs no script.
#[must_use]
pub fn entry_page(entry: &EntryPage) -> String {
    let main = html! {
        header {
            h1 { (entry.name) }
            @if !entry.title.is_empty() { p { (typeset(&entry.title)) ". " span.title { (entry.source) } } }
            p { a href="index.html" { "All schemes" } }
        }
        main id="page:main" tabindex="-1" {
            div.beside {
                @if !entry.parameters.is_empty() {
                    section {
                        h2 { "Parameters" }
                        dl { @for (name, about) in &entry.parameters { div { dt { (typeset(name)) } dd { (typeset(about)) } } } }
                    }
                }
                @if !entry.claims.is_empty() {
                    section {
                        h2 { "Claims of papers" }
                        ul { @for (text, address) in &entry.claims { li { a href=(address) { (typeset(text)) } } } }
                    }
                }
                @for Picture(picture) in &entry.family { (picture) }
            }
            @for scheme in &entry.schemes { (section(scheme)) }
        }
    };
    document(&format!("{} · the atlas · subcert", entry.name), &main)
}

/// The place of a scheme on its page. An address has no blanks.
fn anchor(scheme: &str) -> String {
    scheme.split_whitespace().collect::<Vec<&str>>().join("_")
}

fn section(scheme: &SchemeSection) -> Markup {
    html! {
        section.claim.pictured id=(anchor(&scheme.scheme)) {
            (blocks(&scheme.facts, 1))
            @for Picture(picture) in &scheme.pictures { (picture) }
            @for (language, code) in &scheme.code {
                @match code {
                    Ok(code) => details.certificate { summary { "Code: " (language) } pre tabindex="0" { (code) } },
                    Err(reason) => p.note { "There is no code in " (language) ": " (typeset(reason)) "." },
                }
            }
            p.command {
                "Reproduce: " code { "subcert scheme " (crate::report::html::command::quoted(&scheme.scheme)) } " and "
                code { "subcert plot " (crate::report::html::command::quoted(&scheme.scheme)) }
            }
        }
    }
}
