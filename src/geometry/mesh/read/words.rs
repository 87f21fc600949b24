//! Words of a file whose lines do not matter.

use super::super::point::Point;
use super::lines::{Lines, Word};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::Rational;
use std::ops::Range;
use std::sync::Arc;

/// Whether a word is none of numbers, `nan` and `inf` among them.
fn is_name(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_alphabetic())
}

/// The words, one after the other.
pub(crate) struct Words<'a> {
    lines: Lines<'a>,
    line: std::iter::Peekable<std::vec::IntoIter<Word<'a>>>,
    /// Whether the next word is the first of its line.
    begins: bool,
}

impl<'a> Words<'a> {
    /// The words from a byte on; where there are `comments`, `#` begins one.
    pub(crate) fn new(source: &'a Arc<SourceText>, at: usize, comments: bool) -> Words<'a> {
        let mut lines = Lines::new(source, comments);
        if at > 0 {
            lines = lines.from(at);
        }
        Words { lines, line: Vec::new().into_iter().peekable(), begins: false }
    }

    pub(crate) fn peek(&mut self) -> Option<Word<'a>> {
        while self.line.peek().is_none() {
            self.line = self.lines.next()?.into_iter().peekable();
            self.begins = true;
        }
        self.line.peek().copied()
    }

    pub(crate) fn next(&mut self) -> Option<Word<'a>> {
        self.peek()?;
        self.begins = false;
        self.line.next()
    }

    /// The next word of a file that must go on.
    pub(crate) fn expect(&mut self, missing: impl Fn() -> String) -> Result<Word<'a>, Diagnostic> {
        self.next().ok_or_else(|| self.lines.cut_off(&missing()))
    }

    pub(crate) fn wrong(&self, place: Range<usize>, message: impl Into<String>) -> Diagnostic {
        self.lines.wrong(place, message)
    }

    /// The error of a word with which no section begins.
    pub(crate) fn unexpected(&self, word: &Word<'_>) -> Diagnostic {
        self.wrong(word.place(), format!("`{}` is not expected here", word.text))
            .with_help("are the numbers before it as many as their count says?")
    }

    /// A count.
    pub(crate) fn count(&mut self, what: &str) -> Result<usize, Diagnostic> {
        let word = self.expect(|| format!("{what} is missing"))?;
        self.lines.natural(word, what)
    }

    /// An index or another number that is not negative, with its place.
    pub(crate) fn natural(
        &mut self,
        what: &str,
        missing: impl Fn() -> String,
    ) -> Result<(usize, Range<usize>), Diagnostic> {
        let word = self.expect(&missing)?;
        // The words of the next part of a file say that a count is wrong.
        let counted = |error: Diagnostic| error.with_help(format!("{} so far", missing()));
        Ok((self.lines.natural(word, what).map_err(counted)?, word.place()))
    }

    /// Three coordinates with their place.
    pub(crate) fn point(
        &mut self,
        missing: impl Fn() -> String,
    ) -> Result<(Point<Rational>, Range<usize>), Diagnostic> {
        let words = [self.expect(&missing)?, self.expect(&missing)?, self.expect(&missing)?];
        let place = words[0].at..words[2].place().end;
        let [x, y, z] = words;
        if let Some(word) = words.iter().find(|word| is_name(word.text)) {
            let message = format!("a coordinate is expected here, and not `{}`", word.text);
            return Err(self
                .wrong(word.place(), message)
                .with_help(format!("{}; is the count before them right?", missing())));
        }
        Ok(([self.lines.number(x)?, self.lines.number(y)?, self.lines.number(z)?], place))
    }

    /// Passes over words until one that `known` knows; of the first word of a line it is told how many the line has.
    pub(crate) fn skip(&mut self, known: impl Fn(&Word<'a>, Option<usize>) -> bool) {
        while let Some(word) = self.peek() {
            if known(&word, self.begins.then(|| self.line.len())) {
                return;
            }
            self.next();
        }
    }
}
