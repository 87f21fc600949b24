//! How verdicts look: a class, which has a colour on pages, and a sign, since colour is never alone.

use crate::audit::Word;

/// A look: its class, the sign, and what has it, in words.
pub(in crate::report) struct Look {
    /// The class of its elements.
    pub(in crate::report) class: &'static str,
    /// A verdict of it, which gives the sign.
    of: Word,
    /// What the verdicts of it mean.
    pub(in crate::report) says: &'static str,
}

/// The looks, the best first.
pub(in crate::report) const LOOKS: [Look; 7] = [
    Look { class: "right", of: Word::Confirmed, says: "confirmed, holds, exact, proved" },
    Look {
        class: Word::Reproduced.name(),
        of: Word::Reproduced,
        says: "reproduced at values that the paper does not state",
    },
    Look { class: Word::Rounding.name(), of: Word::Rounding, says: "rounded differently" },
    Look { class: Word::Misprint.name(), of: Word::Misprint, says: Word::Misprint.name() },
    Look { class: "reading", of: Word::OtherReading, says: "another reading" },
    Look { class: "wrong", of: Word::Refuted, says: "refuted, fails, inexact" },
    Look { class: Word::Open.name(), of: Word::NotCheckable, says: "not checkable, or open" },
];

impl Look {
    /// The look of a verdict.
    pub(in crate::report) fn of(verdict: Word) -> &'static Look {
        let [right, reproduced, rounding, misprint, reading, wrong, open] = &LOOKS;
        match verdict {
            Word::Confirmed
            | Word::Holds
            | Word::Exact
            | Word::Proved
            | Word::Kept
            | Word::Nearest => right,
            Word::Reproduced => reproduced,
            Word::Rounding | Word::Cut | Word::Ulps => rounding,
            Word::Misprint => misprint,
            Word::OtherReading | Word::Otherwise => reading,
            Word::Refuted | Word::Fails | Word::Inexact | Word::Broken => wrong,
            Word::NotCheckable | Word::Open => open,
        }
    }

    /// The sign.
    pub(in crate::report) fn sign(&self) -> &'static str {
        self.of.mark()
    }
}

/// What the signs mean, in one line.
#[must_use]
pub fn legend() -> String {
    LOOKS.map(|look| format!("{} {}", look.sign(), look.says)).join("  ")
}
