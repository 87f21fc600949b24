//! What several parts of a report show.

use crate::audit::PaperAudit;
use crate::exact::{Enclosed, format::short};
use crate::formula::LocatedFormula;
use serde_json::{Value, json};
use std::fmt::Display;

/// How many significant digits a decimal beside an exact value has.
pub(super) const DECIMAL_DIGITS: u32 = 17;

/// The mark of a verdict in a table.
#[must_use]
pub fn mark(verdict: &str) -> &'static str {
    match verdict {
        "confirmed" | "holds" | "exact" | "proved" | "kept" => "✓",
        "rounding" => "≈",
        "misprint" => "±",
        "other-reading" => "⇄",
        "refuted" | "fails" | "inexact" | "broken" => "✗",
        _ => "?",
    }
}

/// The definitions that a formula uses.
pub(super) fn definitions(
    audit: &PaperAudit<'_>,
    formula: &LocatedFormula,
) -> impl Iterator<Item = (String, String)> {
    let used = audit.paper.definitions_in(formula).into_iter();
    used.map(|(name, formula)| (format!("where {name}"), formula.text.clone()))
}

/// An exact value with its decimal.
#[must_use]
pub fn exact_json(value: &(impl Enclosed + Display)) -> Value {
    json!({ "exact": value.to_string(), "decimal": short(value, DECIMAL_DIGITS) })
}
