//! The names of a claim file. In a claim each name has one meaning (FORMAT.md, Names).

use super::shape::KINDS;
use crate::formulas::formula::is_name;
use crate::text::toml::Toml;
use std::collections::BTreeSet;

/// The names that theorems about bounds and depths define: the spreads of the data, the level and
/// the tolerance.
pub const OF_THEOREMS: [&str; 6] = ["beta", "beta_1", "beta_2", "beta_3", "k", "epsilon"];

/// The indices in the formulas of the entries of a mask, and of the weights of a ring.
const OF_ENTRIES: [&str; 2] = ["alpha", "r"];
const OF_WEIGHTS: [&str; 2] = ["i", "j"];

/// Checks that no name has two meanings.
pub fn misuse(file: &Toml) -> Result<(), String> {
    let names = |key: &str| file.entries(key).iter().map(|(name, _)| name.as_str());
    distinct("scheme", file.list("scheme").iter().filter_map(|scheme| scheme.text("name")))?;
    distinct("name", names("define").chain(names("given")))?;
    for scheme in file.list("scheme") {
        of_scheme(scheme)?;
    }
    for (kind, claim) in KINDS.iter().flat_map(|kind| file.list(kind).iter().map(|c| (*kind, c))) {
        let own = own(kind, claim);
        if let Some(name) = own.iter().find(|name| !is_name(name) || **name == "pi") {
            return Err(format!("`{name}` cannot be a name"));
        }
        distinct("name", own.iter().copied().chain(names("define")))?;
    }
    Ok(())
}

/// The names that a claim defines.
fn own<'a>(kind: &str, claim: &'a Toml) -> Vec<&'a str> {
    let keys = |key: &str| claim.entries(key).iter().map(|(name, _)| name.as_str());
    let name = |axis: &'a Toml| axis.text("name");
    match kind {
        "table" => {
            let axes = ["rows", "columns"].iter().filter_map(|key| claim.get(key)).filter_map(name);
            let open = claim.texts("unstated");
            axes.chain(keys("given")).chain(keys("unstated")).chain(open).collect()
        }
        "equation" => {
            let symbols = claim.texts("symbols");
            symbols.chain(claim.list("indices").iter().filter_map(name)).collect()
        }
        "smoothness" | "exponent" => keys("given").collect(),
        "theorem" if claim.get("by").is_some() => keys("values").chain(OF_THEOREMS).collect(),
        "theorem" => keys("values").collect(),
        _ => claim.text("variable").into_iter().collect(),
    }
}

/// Checks that the parameters, named formulas and indices of a scheme have different names.
fn of_scheme(scheme: &Toml) -> Result<(), String> {
    let keys = |key: &str| scheme.entries(key).iter().map(|(name, _)| name.as_str());
    let indices: &[&str] = match (scheme.get("entry"), scheme.get("orbits")) {
        (Some(_), _) => &OF_ENTRIES,
        (_, Some(_)) => &OF_WEIGHTS,
        _ => &[],
    };
    distinct("name", keys("parameters").chain(keys("let")).chain(indices.iter().copied()))
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
