//! Numbers and brackets of numbers.

use super::entry::Entry;
use super::language::Language;
use super::token::{Kind, Token};
use crate::diagnostic::{Diagnostic, SourceText};
use std::ops::Range;
use std::sync::Arc;

/// The most numbers of a table.
pub const MAX_ENTRIES: usize = 100_000;

/// How deep brackets and signs may be nested.
pub(super) const MAX_DEPTH: usize = 64;

/// Constructors of integers and of numbers of 16 bits, up to a number behind the name.
const OTHER_NUMBERS: [&str; 13] = [
    "int", "uint", "ivec", "uvec", "bvec", "bool", "half", "long", "short", "char", "float16",
    "bfloat", "f16vec",
];

/// The line of a place, for places that come in order.
struct Lines<'a> {
    text: &'a str,
    at: usize,
    line: usize,
}

impl<'a> Lines<'a> {
    fn new(source: &'a SourceText) -> Lines<'a> {
        Lines { text: &source.text, at: 0, line: 1 }
    }

    fn of(&mut self, place: usize) -> usize {
        let between = self.text.get(self.at..place).unwrap_or_default();
        self.line += between.matches('\n').count();
        self.at = place.max(self.at);
        self.line
    }
}

/// Reads numbers from words.
pub(super) struct Reader<'a> {
    pub(super) source: &'a Arc<SourceText>,
    pub(super) language: Language,
    tokens: &'a [Token],
    pub(super) at: usize,
    lines: Lines<'a>,
}

impl<'a> Reader<'a> {
    pub(super) fn new(
        source: &'a Arc<SourceText>,
        language: Language,
        tokens: &'a [Token],
    ) -> Reader<'a> {
        Reader { source, language, tokens, at: 0, lines: Lines::new(source) }
    }

    pub(super) fn peek(&self) -> Option<Kind> {
        self.tokens.get(self.at).map(|token| token.kind)
    }

    pub(super) fn text(&self, at: usize) -> &str {
        self.tokens.get(at).map_or("", |token| &self.source.text[token.span.clone()])
    }

    pub(super) fn span(&self) -> Range<usize> {
        let last = self.tokens.last().map_or(0..0, |token| token.span.clone());
        self.tokens.get(self.at).map_or(last, |token| token.span.clone())
    }

    pub(super) fn wrong(&self, message: String) -> Diagnostic {
        let help = "a table to audit has numbers only: literals, signs, brackets, + - * / and \
                    comments; cut what else there is, or type the values into the claim file";
        Diagnostic::new(self.source, self.span(), message).with_help(help)
    }

    /// Numbers and brackets of numbers, with commas between them.
    pub(super) fn items(
        &mut self,
        entries: &mut Vec<Entry>,
        depth: usize,
    ) -> Result<(), Diagnostic> {
        if depth > MAX_DEPTH {
            return Err(self.wrong(format!("more than {MAX_DEPTH} brackets within each other")));
        }
        loop {
            match self.peek() {
                None | Some(Kind::Sign(')' | ']' | '}')) => return Ok(()),
                // A comma, and a reference in Rust.
                Some(Kind::Sign(',' | '&')) => {
                    self.at += 1;
                    continue;
                }
                Some(Kind::Sign('{' | '[')) => self.group(entries, depth)?,
                Some(Kind::Sign('(')) if !self.is_formula() => self.group(entries, depth)?,
                Some(Kind::Name) if self.constructor().is_some() => {
                    self.keeps_numbers()?;
                    self.at = self.constructor().unwrap_or(self.at);
                    self.group(entries, depth)?;
                }
                _ => self.entry(entries)?,
            }
            match self.peek() {
                None | Some(Kind::Sign(',' | ')' | ']' | '}')) => {}
                _ => {
                    let found = self.text(self.at).to_owned();
                    return Err(self.wrong(format!("`{found}` stands where a comma is expected")));
                }
            }
        }
    }

    fn group(&mut self, entries: &mut Vec<Entry>, depth: usize) -> Result<(), Diagnostic> {
        let close = match self.peek() {
            Some(Kind::Sign('(')) => ')',
            Some(Kind::Sign('[')) => ']',
            _ => '}',
        };
        let open = self.span();
        self.at += 1;
        self.items(entries, depth + 1)?;
        if self.peek() != Some(Kind::Sign(close)) {
            let message = format!("a bracket is not closed by `{close}`");
            return Err(Diagnostic::new(self.source, open, message));
        }
        self.at += 1;
        Ok(())
    }

    /// Where the bracket of a constructor stands, as in `vec3(…)`, `float[7](…)`, `np.array([…])`: a call with
    /// several numbers, or with brackets within.
    fn constructor(&self) -> Option<usize> {
        let mut at = self.at;
        loop {
            let sign = |at: usize| self.tokens.get(at).map(|token| token.kind);
            match sign(at)? {
                Kind::Name | Kind::Sign('.' | ':' | '!') => at += 1,
                // The size in `float[7](…)`.
                Kind::Sign('[') => {
                    let close = at + 1 + usize::from(sign(at + 1) == Some(Kind::Number));
                    let opens = matches!(sign(close + 1), Some(Kind::Sign('(' | '{')));
                    if sign(close) != Some(Kind::Sign(']')) || !opens {
                        return (at > self.at).then_some(at);
                    }
                    at = close + 1;
                }
                Kind::Sign('(' | '{') => return self.is_list(at).then_some(at),
                _ => return None,
            }
        }
    }

    /// Refuses a constructor that makes other numbers: `ivec3(1.5, 2, 3)` has integers.
    fn keeps_numbers(&self) -> Result<(), Diagnostic> {
        let words =
            (self.at..).take_while(|&at| match self.tokens.get(at).map(|token| token.kind) {
                Some(Kind::Name) => true,
                Some(Kind::Sign(sign)) => matches!(sign, '.' | ':' | '!'),
                _ => false,
            });
        let name = words.last().map_or("", |at| self.text(at)).to_ascii_lowercase();
        let converts = OTHER_NUMBERS.iter().any(|begin| {
            // Not `interpolate` or `intensities`.
            name.strip_prefix(begin)
                .is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphabetic()))
        });
        if converts {
            return Err(self.wrong(format!("`{name}` makes other numbers of what stands in it")));
        }
        Ok(())
    }

    /// Whether the bracket holds a comma or another bracket for lists.
    fn is_list(&self, open: usize) -> bool {
        let mut depth = 0_usize;
        for token in &self.tokens[open..] {
            match token.kind {
                Kind::Sign('[' | '{') if depth > 0 => return true,
                Kind::Sign('(' | '[' | '{') => depth += 1,
                Kind::Sign(')' | ']' | '}') if depth <= 1 => return false,
                Kind::Sign(')' | ']' | '}') => depth -= 1,
                Kind::Sign(',') => return true,
                _ => {}
            }
        }
        false
    }

    /// Whether the bracket `(` here belongs to a formula.
    fn is_formula(&self) -> bool {
        !self.is_list(self.at)
    }

    fn entry(&mut self, entries: &mut Vec<Entry>) -> Result<(), Diagnostic> {
        if entries.len() == MAX_ENTRIES {
            return Err(self.wrong(format!("more than {MAX_ENTRIES} numbers")));
        }
        let start = self.span().start;
        let expression = self.sum(0)?;
        let end = self.tokens[self.at - 1].span.end;
        entries.push(Entry { span: start..end, line: self.lines.of(start), expression });
        Ok(())
    }
}
