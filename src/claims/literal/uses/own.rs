//! Names that have a meaning of their own in a file, and tables that other names get too.

use super::{Declared, KEYWORDS, Uses, is_in};
use crate::literal::declared::statement;
use crate::literal::directive::words;
use crate::literal::language::Language;
use crate::literal::token::Kind;
use std::ops::Range;

impl Uses<'_> {
    /// Whether the file may have a function or a macro of its own with this name.
    pub(super) fn defines(&self, name: &str) -> bool {
        let is_macro = |at: usize| {
            let line = &self.tokens[at];
            line.kind == Kind::Directive
                && matches!(words(self.source, line)[..], ["define", own, ..] if own == name)
        };
        (0..self.tokens.len()).any(|at| {
            is_macro(at) || self.text(at) == name && (self.is_own(at) || self.text(at + 1) == "=")
        })
    }

    /// Whether the name at `at` is declared there: a name or a type stands before.
    fn is_own(&self, at: usize) -> bool {
        let before =
            at.checked_sub(1).filter(|&before| self.is_name(before) && !self.on_next_line(at));
        if before.is_some_and(|before| !is_in(KEYWORDS, self.text(before))) {
            return true;
        }
        if !matches!(self.before(at, 1), "*" | "&" | ">") {
            return false;
        }
        // `float &f(…)`, and not `x = a * f(…)`
        let start = statement(self.tokens, at);
        let begins = matches!(self.before(start, 1), "" | ";" | "{" | "}" | ":")
            || self.tokens[start - 1].kind == Kind::Directive;
        let of_type = |word: usize| match self.tokens[word].kind {
            Kind::Name => !is_in(KEYWORDS, self.text(word)),
            Kind::Sign(sign) => "*&:<>,".contains(sign),
            _ => false,
        };
        begins && self.language.is_native() && (start..at).all(of_type)
    }

    /// A function that makes the table and has a meaning of its own in the file.
    pub(in super::super) fn own_constructor(&self, value: &Range<usize>) -> Option<usize> {
        let scripts = matches!(self.language, Language::Python | Language::JavaScript);
        value.clone().filter(|_| scripts).find(|&at| {
            let name = self.text(at);
            let own = |other: usize| {
                let imported = [1, 2].map(|back| self.before(other, back)) == ["import", "numpy"];
                self.text(other) == name && self.is_own(other) && !imported
            };
            self.is_name(at)
                && self.text(at + 1) == "("
                && !matches!(self.before(at, 1), "." | "new")
                && (0..self.tokens.len()).any(|other| other != at && own(other))
        })
    }

    /// Whether something else gets the list of this declaration too: `v = w = […]`, `f(w=[…])`.
    pub(in super::super) fn shared(&self, at: usize, table: Declared) -> Option<&'static str> {
        let scripts = matches!(self.language, Language::Python | Language::JavaScript);
        let call = self.open[at].filter(|_| self.language == Language::Python);
        let call = call.is_some_and(|open| self.is_value(open) && self.before(open, 2) != "def");
        let chained = self.before(at, 1) == "=";
        (scripts && !table.constant && table.depth > 0 && (call || chained))
            .then_some("is given to something else here, which may change it")
    }
}
