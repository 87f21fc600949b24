//! The fields of masks on Z^d.

use super::lists;
use super::vectors::Vector;
use crate::formulas::{Definitions, formula, formulas, names};
use crate::text::{Stop, Toml};
use std::collections::BTreeSet;

/// The variables of symbols, with their exponents.
pub(super) const VARIABLES: [(&str, Vector); 3] =
    [("x", [1, 0, 0]), ("y", [0, 1, 0]), ("z", [0, 0, 1])];

/// The fields that such a mask may have, but for `origin`.
const FIELDS: [&str; 10] =
    ["name", "title", "source", "parameters", "let", "dilation", "edges", "symbol", "mask", "box"];

/// The fields of which it has one.
const MASKS: [&str; 3] = ["symbol", "mask", "box"];

/// Whether the table of a scheme is a mask on Z^d.
pub fn is_lattice(table: &Toml) -> bool {
    let has = |key: &&str| table.get(key).is_some();
    ["dilation", "origin", "box"].iter().any(has)
        || has(&"edges") && ["symbol", "mask"].iter().any(has)
        || table.text("mask").is_some_and(|text| lists::depth(text) > 1)
        || has_variable(table)
}

/// Whether x or y is a name in the symbol, or in what it names, and no name of the table.
fn has_variable(table: &Toml) -> bool {
    let Some(text) = table.text("symbol") else { return false };
    let own: BTreeSet<&str> = table.names("parameters").chain(table.names("let")).collect();
    let free: Vec<&str> = ["x", "y"].into_iter().filter(|name| !own.contains(name)).collect();
    let formulas = table.entries("let").iter().filter_map(|(_, text)| text.as_text());
    // Most symbols do not even have the letters.
    let letters = formulas.chain([text]).any(|text| free.iter().any(|name| text.contains(name)));
    letters
        && names_of(table, text).is_ok_and(|names| free.iter().any(|name| names.contains(*name)))
}

/// The names in a symbol and in what it names.
fn names_of(table: &Toml, text: &str) -> Result<BTreeSet<String>, Stop> {
    let definitions: Definitions = formulas(table.entries("let"))?;
    Ok(names(&formula(text)?, &definitions))
}

/// d.
pub(super) fn dimension(table: &Toml) -> Result<usize, Stop> {
    let d = match (table.get("dilation"), table.text("symbol"), table.text("mask")) {
        (Some(_), ..) => table.list("dilation").len(),
        (None, Some(text), _) => {
            if names_of(table, text)?.contains("z") {
                3
            } else {
                2
            }
        }
        (None, None, Some(text)) => lists::depth(text),
        _ if table.get("mask").is_some() => 2,
        _ => table.list("box").first().map_or(0, |direction| direction.as_list().len()),
    };
    if !(2..=3).contains(&d) {
        return Err(Stop::Wrong("a mask on Z^d has 2 or 3 dimensions".to_owned()));
    }
    Ok(d)
}

/// Checks the fields of a mask on Z^d, and gives the variables of its symbol.
pub fn variables(table: &Toml) -> Result<Vec<&'static str>, String> {
    let typed = table.get("mask").is_some();
    let strange = |name: &&str| !(FIELDS.contains(name) || typed && *name == "origin");
    if let Some(name) = table.as_table().iter().map(|(name, _)| &name[..]).find(strange) {
        return Err(format!("a mask on Z^d has no field `{name}`"));
    }
    if MASKS.iter().filter(|key| table.get(key).is_some()).count() != 1 {
        return Err("a mask on Z^d has one of the fields `symbol`, `mask` and `box`".to_owned());
    }
    if table.get("symbol").is_none() {
        return Ok(Vec::new());
    }
    // Without a dimension, the mask is wrong where it is used.
    let d = dimension(table).unwrap_or(3);
    Ok(VARIABLES.iter().take(d).map(|(name, _)| *name).collect())
}
