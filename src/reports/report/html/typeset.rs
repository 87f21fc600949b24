//! Texts as HTML: letters with their scripts, signs and code, which texts have as they are typed.

use super::names::plain;
use crate::report::words::notation::{Part, parts};
use maud::{Markup, html};

/// A text in a line.
pub(crate) fn typeset(text: &str) -> Markup {
    html! { @for part in parts(text) { (one(part)) } }
}

/// A letter stands for a variable, a word for itself.
fn letters(text: &str) -> Markup {
    let mut letters = text.chars();
    let one = letters.next().is_some_and(char::is_alphabetic) && letters.next().is_none();
    html! { @if one || plain(text) != text { var { (plain(text)) } } @else { (text) } }
}

fn script(text: &str) -> String {
    text.replace('-', "−")
}

fn one(part: Part<'_>) -> Markup {
    match part {
        Part::Plain(text) => html! { (text) },
        Part::Code(text) => html! { code { (text) } },
        Part::Minus => html! { "−" },
        Part::Scripts { base, below, above, .. } => html! {
            (letters(base))
            @if let Some(above) = above { sup { (letters(&script(above))) } }
            @if let Some(below) = below { sub { (letters(&script(below))) } }
        },
    }
}
