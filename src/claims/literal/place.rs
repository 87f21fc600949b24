//! Where a name gets a value.

use super::language::Language;
use super::token::{Kind, Token};
use crate::diagnostic::SourceText;
use std::ops::Range;

/// A place where the name occurs.
pub(super) struct Place<'a> {
    pub(super) source: &'a SourceText,
    pub(super) language: Language,
    pub(super) tokens: &'a [Token],
    pub(super) name: usize,
    /// Whether a bracket is open there.
    pub(super) enclosed: bool,
}

impl Place<'_> {
    fn text(&self, at: usize) -> &str {
        self.tokens.get(at).map_or("", |token| &self.source.text[token.span.clone()])
    }

    fn sign(&self, at: usize) -> Option<char> {
        match self.tokens.get(at)?.kind {
            Kind::Sign(sign) => Some(sign),
            _ => None,
        }
    }

    /// Whether a word follows the one before at once.
    fn joined(&self, at: usize) -> bool {
        self.tokens.get(at).is_some_and(|token| token.span.start == self.tokens[at - 1].span.end)
    }

    /// Whether a line ends before this word, but for `\` in Python.
    fn on_next_line(&self, at: usize) -> bool {
        let between = &self.source.text[self.tokens[at - 1].span.end..self.tokens[at].span.start];
        let continued = match self.language {
            Language::Python => between.trim_start().starts_with('\\'),
            Language::Matlab => between.contains("..."),
            _ => false,
        };
        between.contains('\n') && !continued
    }

    /// The words of the value: up to a comma, a semicolon or a bracket that was opened before; in JavaScript and Python, also
    /// up to the end of a line. In Python a comma makes a tuple.
    pub(super) fn value(&self, begin: usize) -> Option<Range<usize>> {
        let mut depth = 0_usize;
        let mut end = begin;
        // In WGSL, it parts the types of `array<f32, 4>`, and each name has a declaration of its own.
        let tuple = matches!(self.language, Language::Python | Language::Wgsl) && !self.enclosed;
        while let Some(token) = self.tokens.get(end) {
            match token.kind {
                _ if depth == 0 && end > begin && self.ends(end) => break,
                Kind::Sign('(' | '[' | '{') => depth += 1,
                Kind::Sign(')' | ']' | '}' | ';') if depth == 0 => break,
                Kind::Sign(',') if depth == 0 && !tuple => break,
                Kind::Sign(')' | ']' | '}') => depth -= 1,
                _ => {}
            }
            end += 1;
        }
        (begin < end).then_some(begin..end)
    }

    /// Whether a value ends before this word, because a line ends there.
    fn ends(&self, at: usize) -> bool {
        self.on_next_line(at)
            && match self.language {
                Language::Python | Language::Matlab => !self.enclosed,
                Language::JavaScript => !self.goes_on(at),
                _ => false,
            }
    }

    /// Whether JavaScript takes this word to the value of the line before.
    fn goes_on(&self, at: usize) -> bool {
        let open = self.sign(at - 1).is_some_and(|sign| !matches!(sign, ')' | ']' | '}'));
        open || match self.sign(at) {
            Some(sign @ ('+' | '-')) => self.sign(at + 1) != Some(sign) || !self.joined(at + 1),
            Some('!') => self.text(at + 1) == "=",
            Some(sign) => !matches!(sign, '{' | '}' | ')' | ']' | '@' | '#' | '~'),
            None => matches!(self.text(at), "in" | "instanceof") || self.text(at).starts_with('`'),
        }
    }

    /// Whether a name may get a value where it stands: in Python at the beginning of a statement or as an argument.
    fn may_get_value(&self) -> bool {
        // `self.name`
        let mut first = self.name;
        while first > 1 && self.sign(first - 1) == Some('.') && self.sign(first - 2).is_none() {
            first -= 2;
        }
        let Some(before) = first.checked_sub(1) else { return true };
        let compares = before > 0 && matches!(self.text(before - 1), "=" | "!" | "<" | ">");
        match (self.language, self.text(before)) {
            (Language::Python, "," | "(") => self.enclosed,
            (Language::Python, ":" | ";") => true,
            (Language::Python, "=") => !compares,
            (Language::Python, _) => self.on_next_line(first),
            (Language::Matlab, "for" | "parfor") => false,
            (_, before) => !matches!(before, "case" | "?"),
        }
    }

    /// Where the value that the name gets here begins: after `=`, or at a brace that follows it and its brackets at once.
    pub(super) fn begins(&self) -> Option<usize> {
        let native = self.language.is_native();
        let mut depth = 0_usize;
        let mut annotated = false;
        if !self.may_get_value() {
            return None;
        }
        if self.language == Language::Matlab {
            let next = self.name + 1;
            let compares = self.joined(next + 1) && self.sign(next + 1) == Some('=');
            return (!self.enclosed && self.sign(next) == Some('=') && !compares)
                .then_some(next + 1);
        }
        for at in self.name + 1..self.tokens.len() {
            if self.language == Language::Python
                && !self.enclosed
                && depth == 0
                && self.on_next_line(at)
            {
                return None;
            }
            match self.tokens[at].kind {
                Kind::Sign('=') if depth == 0 => {
                    // Neither a comparison nor a function.
                    let other = self.joined(at + 1) && matches!(self.sign(at + 1), Some('=' | '>'));
                    return (!other).then_some(at + 1);
                }
                Kind::Sign('{') if depth == 0 => return Some(at),
                Kind::Sign('[' | '(') => depth += 1,
                Kind::Sign('<') if annotated => depth += 1,
                Kind::Sign(']' | ')') => depth = depth.checked_sub(1)?,
                Kind::Sign('>') if annotated => depth = depth.checked_sub(1)?,
                _ if depth > 0 => {}
                // Between the name and `=` stands at most a type, as in `name: [f32; 7] =`, or an attribute.
                Kind::Sign(':') if !native => annotated = true,
                Kind::Sign('&' | '\'' | '*' | '.' | '|') | Kind::Name if annotated => {}
                Kind::Name if native => {
                    let word = self.text(at);
                    let macros = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_';
                    if !word.starts_with("__") && word != "alignas" && !word.chars().all(macros) {
                        return None;
                    }
                }
                _ => return None,
            }
        }
        None
    }
}
