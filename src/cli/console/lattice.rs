//! Masks on Z^d in words.

use super::quantity::{exponent_in_short, proved_continuity};
use subcert::report::json::LatticeSmoothnessForm;

/// What is proven of limits, in words.
pub(crate) fn smoothness_words(
    form: &LatticeSmoothnessForm,
    sum_rules: Option<u32>,
) -> Vec<(String, String)> {
    let mut facts = Vec::new();
    if let Some(accuracy) = form.accuracy.filter(|accuracy| Some(*accuracy) != sum_rules) {
        let text = format!("of order {accuracy}: the shifts of φ are dependent");
        facts.push(("accuracy".to_owned(), text));
    }
    let order = |m: Option<u32>| m.and_then(|m| usize::try_from(m).ok());
    let limits = proved_continuity(order(form.continuity), order(form.continuity_fails));
    facts.push(("limits".to_owned(), limits));
    let none = if form.continuity_fails == Some(0) { "none" } else { "open" };
    let exponent = form.hoelder.as_ref().map_or(none.to_owned(), exponent_in_short);
    facts.push(("Hölder exponent".to_owned(), exponent));
    facts
}

/// How smooth the limits are, in a sentence.
pub(crate) fn sentence(name: &str, form: &LatticeSmoothnessForm) -> String {
    let words = smoothness_words(form, form.accuracy);
    let texts: Vec<&str> = words.iter().map(|(_, text)| text.as_str()).collect();
    format!("{name}: {}; Hölder exponent: {}.", texts[0], texts[1])
}

/// A vector in text.
pub(crate) fn vector(vector: &[i64]) -> String {
    let words: Vec<String> = vector.iter().map(ToString::to_string).collect();
    format!("({})", words.join(","))
}

/// A matrix in text, as it is typed.
pub(crate) fn matrix(rows: &[Vec<i64>]) -> String {
    let row = |row: &Vec<i64>| {
        let words: Vec<String> = row.iter().map(ToString::to_string).collect();
        format!("[{}]", words.join(", "))
    };
    format!("[{}]", rows.iter().map(row).collect::<Vec<String>>().join(", "))
}
