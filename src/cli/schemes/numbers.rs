//! Numbers among the facts of schemes.

use crate::cli::console::quantity::{LONGEST, is_fraction};
use subcert::report::json::Exact;

/// T_c or Λ_c.
pub(crate) fn level(values: &[Exact], c: usize) -> String {
    values.get(c - 1).map_or("open".to_owned(), decimal)
}

/// The digits of a decimal.
const DIGITS: usize = 12;

/// The exact value where that is a short fraction, or else a decimal.
pub(crate) fn number(value: &Exact) -> String {
    let fraction = is_fraction(&value.exact) && value.exact.len() <= LONGEST;
    if fraction { value.exact.clone() } else { decimal(value) }
}

/// A decimal, cut to a few digits.
pub(super) fn decimal(value: &Exact) -> String {
    shortened(&value.decimal)
}

/// A decimal without the digits beyond a few places, which are cut.
pub(super) fn shortened(decimal: &str) -> String {
    if decimal.contains('e') {
        return decimal.to_owned();
    }
    match decimal.split_once('.') {
        Some((whole, places)) if places.len() > DIGITS => {
            let places = places[..DIGITS].trim_end_matches('0');
            format!("{whole}.{places}…")
        }
        _ => decimal.to_owned(),
    }
}
