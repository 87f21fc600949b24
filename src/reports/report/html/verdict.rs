//! How verdicts look: a class, which has a colour, and a sign, since colour is never alone.

use crate::report::parts::mark;
use maud::{Markup, html};

/// A look: its class, the sign, and what has it, in words.
pub(super) struct Look {
    /// The class of its elements.
    pub(super) class: &'static str,
    /// A verdict of it, which gives the sign.
    of: &'static str,
    /// What the verdicts of it mean.
    pub(super) says: &'static str,
}

/// The looks, the best first.
pub(super) const LOOKS: [Look; 7] = [
    Look { class: "right", of: "confirmed", says: "confirmed, holds, exact, proved" },
    Look {
        class: "reproduced",
        of: "reproduced",
        says: "reproduced at values that the paper does not state",
    },
    Look { class: "rounding", of: "rounding", says: "rounded otherwise" },
    Look { class: "misprint", of: "misprint", says: "misprint" },
    Look { class: "reading", of: "other-reading", says: "another reading" },
    Look { class: "wrong", of: "refuted", says: "refuted, fails, inexact" },
    Look { class: "open", of: "not-checkable", says: "not checkable, or open" },
];

/// The class of cells whose promise is broken.
pub(super) const BROKEN: &str = "broken";

impl Look {
    /// The look of a verdict.
    pub(super) fn of(verdict: &str) -> &'static Look {
        let place = match verdict {
            "confirmed" | "holds" | "exact" | "proved" | "kept" => 0,
            "reproduced" => 1,
            "rounding" => 2,
            "misprint" => 3,
            "other-reading" => 4,
            "refuted" | "fails" | "inexact" | "broken" => 5,
            _ => 6,
        };
        &LOOKS[place]
    }

    /// The sign.
    pub(super) fn sign(&self) -> &'static str {
        mark(self.of)
    }
}

/// The sign of a verdict, with its name for those who do not see it.
pub(super) fn badge(verdict: &str) -> Markup {
    let look = Look::of(verdict);
    html! {
        span class={ "sign " (look.class) } {
            span aria-hidden="true" { (look.sign()) }
            span.hidden { (verdict) }
        }
    }
}
