//! The names of a claim file. In a claim each name has one meaning (FORMAT.md, Names).

use crate::formulas::is_name;
use crate::schemes::{is_lattice, variables};
use crate::text::Toml;
use std::collections::BTreeSet;

/// The names that theorems about bounds and depths define: the spreads of the data, the level and
/// the tolerance.
pub const OF_THEOREMS: [&str; 6] = ["beta", "beta_1", "beta_2", "beta_3", "k", "epsilon"];

/// The indices in the formulas of the entries of a mask, and of the weights of a ring.
const OF_ENTRIES: [&str; 2] = ["alpha", "r"];
const OF_WEIGHTS: [&str; 2] = ["i", "j"];

/// The variable of a symbol.
const OF_SYMBOLS: [&str; 1] = ["z"];

/// Checks that no name has two meanings. Each claim has names of its own.
pub fn misuse<'a>(file: &Toml, claims: impl Iterator<Item = Vec<&'a str>>) -> Result<(), String> {
    distinct("scheme", file.list("scheme").iter().filter_map(|scheme| scheme.text("name")))?;
    distinct("name", file.names("define").chain(file.names("given")))?;
    for scheme in file.list("scheme") {
        of_scheme(scheme)?;
    }
    for own in claims {
        if let Some(name) = own.iter().find(|name| !is_name(name) || **name == "pi") {
            return Err(format!("`{name}` cannot be a name"));
        }
        distinct("name", own.iter().copied().chain(file.names("define")))?;
    }
    Ok(())
}

/// Checks that the parameters, named formulas, variables and indices of a scheme have different names.
fn of_scheme(scheme: &Toml) -> Result<(), String> {
    let lattice = if is_lattice(scheme) { Some(variables(scheme)?) } else { None };
    let indices: &[&str] = match (scheme.get("entry"), scheme.get("orbits")) {
        _ if lattice.is_some() => lattice.as_deref().unwrap_or_default(),
        _ if scheme.get("symbol").is_some() => &OF_SYMBOLS,
        (Some(_), _) => &OF_ENTRIES,
        (_, Some(_)) => &OF_WEIGHTS,
        _ => &[],
    };
    let named = scheme.names("parameters").chain(scheme.names("let"));
    distinct("name", named.chain(indices.iter().copied()))
}

/// Checks that no two names are the same.
fn distinct<'n>(what: &str, names: impl Iterator<Item = &'n str>) -> Result<(), String> {
    let mut known = BTreeSet::new();
    for name in names {
        if !known.insert(name) {
            return Err(format!("the {what} `{name}` has two meanings"));
        }
    }
    Ok(())
}
