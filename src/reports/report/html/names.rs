//! Names of the formula language as mathematicians write them.

use crate::report::words::greek::greek;
use maud::{Markup, html};

/// A name: Greek where it names a letter, which may have an index, as in `beta_1` or `p0`; other names as
/// they are, as `error_bound`.
pub(super) fn name(text: &str) -> Markup {
    let digits = text.trim_end_matches(|c: char| c.is_ascii_digit()).len();
    let (base, index) = match text.split_once('_') {
        Some(parts) => parts,
        None => text.split_at(digits),
    };
    if index.is_empty() || !is_letter(base) {
        return letter(text);
    }
    html! { msub { (letter(base)) (letter(index)) } }
}

/// A name as text: Greek where it names a letter.
pub(super) fn plain(text: &str) -> &str {
    greek(text).unwrap_or(text)
}

fn is_letter(text: &str) -> bool {
    text.chars().count() == 1 || greek(text).is_some()
}

fn letter(text: &str) -> Markup {
    if text.bytes().all(|byte| byte.is_ascii_digit()) {
        return html! { mn { (text) } };
    }
    html! { mi { (plain(text)) } }
}
