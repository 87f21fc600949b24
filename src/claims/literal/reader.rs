//! Numbers and brackets of numbers.

use super::declared::Typed;
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

/// The most operations in one number: its value is computed by as deep a recursion.
pub(super) const MAX_OPERATIONS: usize = 1_000;

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
    /// How many operations the number has up to here.
    pub(super) operations: usize,
    /// The types that constructors give to the numbers.
    pub(super) types: Vec<Typed>,
    /// Whether blanks part the numbers, as in a row of MATLAB.
    pub(super) in_row: bool,
    /// Whether the next bracket may hold numbers beside lists, as in `vec4(vec3(…), 1)`.
    pub(super) mixes: bool,
}

impl<'a> Reader<'a> {
    pub(super) fn new(
        source: &'a Arc<SourceText>,
        language: Language,
        tokens: &'a [Token],
    ) -> Reader<'a> {
        let (types, lines) = (Vec::new(), Lines::new(source));
        let (in_row, mixes) = (false, false);
        Reader { source, language, tokens, at: 0, lines, operations: 0, types, in_row, mixes }
    }

    pub(super) fn peek(&self) -> Option<Kind> {
        self.kind(self.at)
    }

    pub(super) fn kind(&self, at: usize) -> Option<Kind> {
        self.tokens.get(at).map(|token| token.kind)
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
        let mixes = std::mem::take(&mut self.mixes);
        let mut first = None;
        loop {
            let (begin, before) = (self.at, entries.len());
            let mut list = true;
            while self.language == Language::Rust && self.peek() == Some(Kind::Sign('&')) {
                self.at += 1;
            }
            match self.peek() {
                None | Some(Kind::Sign(')' | ']' | '}')) => return Ok(()),
                Some(Kind::Sign(',')) => {
                    return Err(self.wrong("no number stands before this comma".to_owned()));
                }
                Some(Kind::Sign(sign @ ('{' | '['))) => {
                    self.is_list_of_language(sign)?;
                    self.group(entries, depth)?;
                }
                Some(Kind::Sign('(')) if self.is_list(self.at) => {
                    self.is_list_of_language('(')?;
                    self.group(entries, depth)?;
                }
                Some(Kind::Name) => match self.constructor()? {
                    Some(constructor) => self.construct(&constructor, entries, depth)?,
                    None => list = self.entry(entries)?,
                },
                _ => list = self.entry(entries)?,
            }
            // What a language puts in the places that are left is not known.
            let item = (list, entries.len() - before);
            if *first.get_or_insert(item) != item && !mixes {
                self.at = begin;
                let message =
                    "the lists in this bracket do not have equally many numbers".to_owned();
                return Err(self.wrong(message));
            }
            match self.peek() {
                None | Some(Kind::Sign(')' | ']' | '}')) => {}
                Some(Kind::Sign(',')) => self.at += 1,
                Some(Kind::Sign(';')) if self.in_row => self.at += 1,
                _ if self.in_row && self.is_apart(self.at) => {}
                _ => {
                    let found = self.text(self.at).to_owned();
                    return Err(self.wrong(format!("`{found}` stands where a comma is expected")));
                }
            }
        }
    }

    /// Refuses brackets that are no list of the language.
    fn is_list_of_language(&self, sign: char) -> Result<(), Diagnostic> {
        use Language::{C, Hlsl, JavaScript, Matlab, Python, Shader};
        let message = match (sign, self.language) {
            ('{', Python | JavaScript) => {
                "braces are a set or an object here, in which numbers have no order"
            }
            ('(', Matlab) => "round brackets hold one number here",
            ('(', C | Shader | Hlsl | JavaScript) if self.commas(self.at) > 0 => {
                "of numbers in round brackets the last one alone is the value here"
            }
            _ => return Ok(()),
        };
        Err(self.wrong(message.to_owned()))
    }

    pub(super) fn group(
        &mut self,
        entries: &mut Vec<Entry>,
        depth: usize,
    ) -> Result<(), Diagnostic> {
        let close = match self.peek() {
            Some(Kind::Sign('(')) => ')',
            Some(Kind::Sign('[')) => ']',
            _ => '}',
        };
        let open = self.span();
        if self.in_row && self.has_rows() {
            return Err(self.wrong("a matrix of several rows within a matrix".to_owned()));
        }
        let in_row = self.language == Language::Matlab && close != ')';
        let in_row = std::mem::replace(&mut self.in_row, in_row);
        self.at += 1;
        let before = entries.len();
        self.items(entries, depth + 1)?;
        self.in_row = in_row;
        if self.peek() != Some(Kind::Sign(close)) {
            let message = format!("a bracket is not closed by `{close}`");
            return Err(Diagnostic::new(self.source, open, message));
        }
        if entries.len() == before {
            return Err(self.wrong("a bracket without a number in it".to_owned()));
        }
        self.at += 1;
        Ok(())
    }

    /// The text between a word and the one before.
    fn between(&self, at: usize) -> &str {
        match (at.checked_sub(1).and_then(|before| self.tokens.get(before)), self.tokens.get(at)) {
            (Some(before), Some(token)) => &self.source.text[before.span.end..token.span.start],
            _ => "",
        }
    }

    /// Whether blanks stand before a word.
    fn is_apart(&self, at: usize) -> bool {
        !self.between(at).is_empty()
    }

    /// Whether a sign here belongs to the next number of a row, as in `[1 -2]`, and not in `[1 - 2]`.
    pub(super) fn is_next_in_row(&self) -> bool {
        self.in_row && self.is_apart(self.at) && !self.is_apart(self.at + 1)
    }

    /// Whether a line ends a row before the word here, whatever stands in the next line.
    pub(super) fn ends_row(&self) -> bool {
        let ends = |between: &str| between.contains('\n') && !between.contains("...");
        self.in_row && ends(self.between(self.at))
    }

    /// Whether the bracket that opens here has several rows.
    fn has_rows(&self) -> bool {
        let mut depth = 0_usize;
        for at in self.at..self.tokens.len() {
            let between = self.between(at);
            match self.tokens[at].kind {
                Kind::Sign(']' | '}') if depth <= 1 => return false,
                _ if at > self.at + 1 && between.contains('\n') && !between.contains("...") => {
                    return true;
                }
                Kind::Sign(';') => return true,
                Kind::Sign('[' | '{') => depth += 1,
                Kind::Sign(']' | '}') => depth -= 1,
                _ => {}
            }
        }
        false
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

    /// How many commas stand in the bracket itself, but for one at its end.
    pub(super) fn commas(&self, open: usize) -> usize {
        let (mut depth, mut commas, mut last) = (0_usize, 0, false);
        for token in &self.tokens[open..] {
            match token.kind {
                Kind::Sign('(' | '[' | '{') => depth += 1,
                Kind::Sign(')' | ']' | '}') if depth <= 1 => break,
                Kind::Sign(')' | ']' | '}') => depth -= 1,
                Kind::Sign(',') if depth == 1 => commas += 1,
                _ => {}
            }
            last = depth == 1 && token.kind == Kind::Sign(',');
        }
        commas - usize::from(last)
    }

    /// Reads a number, which is no list.
    fn entry(&mut self, entries: &mut Vec<Entry>) -> Result<bool, Diagnostic> {
        if entries.len() == MAX_ENTRIES {
            return Err(self.wrong(format!("more than {MAX_ENTRIES} numbers")));
        }
        let start = self.span().start;
        self.operations = 0;
        let expression = self.sum(0)?;
        let end = self.tokens[self.at - 1].span.end;
        entries.push(Entry { span: start..end, line: self.lines.of(start), expression });
        Ok(false)
    }
}
