//! The verdicts on pages.

use crate::audit::Word;
pub(super) use crate::report::words::look::{LOOKS, Look};
use maud::{Markup, html};

/// The class of cells whose promise is broken.
pub(super) const BROKEN: &str = Word::Broken.name();

/// The sign of a verdict, with its name for those who do not see it.
pub(super) fn badge(verdict: Word) -> Markup {
    let look = Look::of(verdict);
    html! {
        span class={ "sign " (look.class) } {
            span aria-hidden="true" { (look.sign()) }
            span.hidden { (verdict.name()) }
        }
    }
}
