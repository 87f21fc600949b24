//! The texts that name schemes: `NAME:parameter=value,…`, and two of them with ` x ` between.

use crate::formulas::{formula, free};
use crate::text::Stop;
use std::collections::BTreeSet;

/// The names of the factors of a reference.
pub fn names(reference: &str) -> impl Iterator<Item = &str> {
    reference.split(" x ").map(|factor| split(factor).0)
}

/// The name and the parameters of a reference.
pub fn split(reference: &str) -> (&str, &str) {
    reference.trim().split_once(':').unwrap_or((reference.trim(), ""))
}

/// The names in the formulas of the parameters of a reference.
pub fn parameters_of(reference: &str) -> Result<BTreeSet<String>, Stop> {
    let mut names = BTreeSet::new();
    for factor in reference.split(" x ") {
        for (_, value) in arguments_of(split(factor).1).iter().filter_map(|it| it.split_once('=')) {
            names.extend(free(&formula(value.trim())?));
        }
    }
    Ok(names)
}

/// The arguments between commas outside of parentheses, without blank ones.
pub fn arguments_of(text: &str) -> Vec<&str> {
    let mut depth = 0_i64;
    let pieces = text.split(|c| {
        depth += i64::from(c == '(') - i64::from(c == ')');
        c == ',' && depth <= 0
    });
    pieces.filter(|piece| !piece.trim().is_empty()).collect()
}
