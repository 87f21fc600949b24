//! The formulas of a claim file, and the names that stand for formulas.

use super::formula::{Expr, Head, MAX_LENGTH, is_name, parse};
use crate::text::{Stop, Toml};
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// Formulas by their names.
pub type Definitions = BTreeMap<String, Rc<Expr>>;

/// Reads a formula of a file.
pub fn formula(text: &str) -> Result<Expr, Stop> {
    parse(text, MAX_LENGTH).map_err(Stop::Wrong)
}

/// Reads the formula of a key of a claim.
pub fn formula_of(claim: &Toml, key: &str) -> Result<Expr, Stop> {
    formula(claim.text(key).ok_or_else(|| Stop::Wrong(format!("`{key}` is missing")))?)
}

/// Reads the named formulas of a file.
pub fn formulas(entries: &[(String, Toml)]) -> Result<Definitions, Stop> {
    let read = |(name, text): &(String, Toml)| match text.as_text() {
        Some(text) if is_name(name) && name != "pi" => Ok((name.clone(), Rc::new(formula(text)?))),
        _ => Err(Stop::Wrong(format!("`{name}` is no named formula"))),
    };
    entries.iter().map(read).collect()
}

/// All names in a formula and in the definitions that it leads to.
pub fn names(expr: &Expr, definitions: &Definitions) -> BTreeSet<String> {
    let (mut names, mut waiting) = (BTreeSet::new(), vec![expr]);
    while let Some(expr) = waiting.pop() {
        for node in expr.nodes() {
            let found: Vec<&String> = match node {
                Expr::Name(name) | Expr::Of(Head::Member(name), _) => vec![name],
                Expr::Of(Head::Call(_, options), _) => options.iter().map(|(_, it)| it).collect(),
                Expr::Number(_) | Expr::Of(..) => Vec::new(),
            };
            for name in found.into_iter().filter(|name| names.insert((*name).clone())) {
                waiting.extend(definitions.get(name).map(|definition| &**definition));
            }
        }
    }
    names
}

/// The names of numbers in a formula, other than `pi` and the indices of sums.
pub fn free(expr: &Expr) -> BTreeSet<String> {
    match expr {
        Expr::Number(_) => BTreeSet::new(),
        Expr::Name(name) => Some(name.clone()).filter(|name| name != "pi").into_iter().collect(),
        Expr::Of(head, parts) => {
            let mut names = parts.iter().map(free);
            let ends: BTreeSet<String> = match head {
                Head::Over(..) => names.by_ref().take(2).flatten().collect(),
                _ => BTreeSet::new(),
            };
            let mut names: BTreeSet<String> = names.flatten().collect();
            if let Head::Over(_, index) = head {
                names.remove(index);
            }
            names.extend(ends);
            names
        }
    }
}
