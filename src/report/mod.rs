//! Findings as text, Markdown and JSON.

mod audit;
mod coverage;
mod equation;
mod explain;
mod function;
mod json;
mod reading;
mod sheet;
mod text;
mod theorem;

pub use audit::{audit_sheet, table_values};
pub use coverage::{coverage_json, coverage_sheet};
pub use explain::explain_sheet;
pub use json::{audit_json, exact_json};
pub use sheet::{Block, Grid, Sheet};

/// The mark of a verdict in a table.
#[must_use]
pub fn mark(verdict: &str) -> &'static str {
    match verdict {
        "confirmed" | "holds" | "exact" => "✓",
        "rounding" => "≈",
        "misprint" => "±",
        "other-reading" => "⇄",
        "refuted" | "fails" | "inexact" => "✗",
        _ => "?",
    }
}
