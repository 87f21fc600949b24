//! Lines of words, with their places.

use super::super::point::Point;
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::{Rational, parse_rational};
use std::ops::Range;
use std::sync::Arc;

/// A word of a line.
#[derive(Clone, Copy)]
pub(crate) struct Word<'a> {
    pub(crate) text: &'a str,
    /// Its first byte in the file.
    pub(crate) at: usize,
}

impl Word<'_> {
    pub(crate) fn place(&self) -> Range<usize> {
        self.at..self.at + self.text.len()
    }
}

/// The lines that have words.
pub(crate) struct Lines<'a> {
    source: &'a Arc<SourceText>,
    at: usize,
    comments: bool,
}

/// The words of a line.
pub(crate) type Line<'a> = Vec<Word<'a>>;

/// The bytes from the first word to the last.
pub(crate) fn extent(line: &[Word<'_>]) -> Range<usize> {
    match (line.first(), line.last()) {
        (Some(first), Some(last)) => first.at..last.at + last.text.len(),
        _ => 0..0,
    }
}

impl<'a> Lines<'a> {
    /// The lines of a file; where there are `comments`, `#` begins one.
    pub(crate) fn new(source: &'a Arc<SourceText>, comments: bool) -> Lines<'a> {
        // A byte order mark is not part of the text.
        let at = if source.text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        Lines { source, at, comments }
    }

    /// The lines from this byte on.
    pub(crate) fn from(self, at: usize) -> Lines<'a> {
        Lines { at, ..self }
    }

    /// The next line, also one without words.
    pub(crate) fn any(&mut self) -> Option<Line<'a>> {
        let rest = &self.source.text[self.at..];
        if rest.is_empty() {
            return None;
        }
        let (line, start) = (&rest[..line_end(rest, 0)], self.at);
        self.at += line.len();
        let text = if self.comments { line.split('#').next().unwrap_or_default() } else { line };
        Some(words(text, start).collect())
    }

    /// An error about the file at a place.
    pub(crate) fn wrong(&self, place: Range<usize>, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(self.source, place, message)
    }

    /// The error of a file that ends too early.
    pub(crate) fn cut_off(&self, missing: &str) -> Diagnostic {
        let end = self.source.text.trim_end().len();
        self.wrong(end..end, format!("the file ends here, and {missing}"))
            .with_help("the file is cut off, or its counts are wrong")
    }

    /// A coordinate.
    pub(crate) fn number(&self, word: Word<'_>) -> Result<Rational, Diagnostic> {
        parse_rational(word.text).map_err(|error| {
            let help = "write a decimal such as -0.25 or 2.5e-3, or a fraction such as 1/3";
            self.wrong(word.place(), error.to_string()).with_help(help)
        })
    }

    /// The first three words of these as a point.
    pub(crate) fn point(&self, words: &[Word<'_>]) -> Result<Point<Rational>, Diagnostic> {
        let [x, y, z, ..] = words else {
            let message = format!("{} coordinates; a point has x, y and z", words.len());
            return Err(self.wrong(extent(words), message));
        };
        Ok([self.number(*x)?, self.number(*y)?, self.number(*z)?])
    }

    /// A count or an index that is not negative.
    pub(crate) fn natural(&self, word: Word<'_>, what: &str) -> Result<usize, Diagnostic> {
        word.text.parse().map_err(|_| {
            let digits = !word.text.is_empty() && word.text.bytes().all(|b| b.is_ascii_digit());
            let reason = if digits { "too large" } else { "no natural number" };
            self.wrong(word.place(), format!("{what} is {reason}"))
        })
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Line<'a>;

    fn next(&mut self) -> Option<Line<'a>> {
        std::iter::from_fn(|| self.any()).find(|line| !line.is_empty())
    }
}

/// Where the line that a byte is in ends, after its line feed. Old Macintosh files end their lines with \r alone.
pub(super) fn line_end(text: &str, at: usize) -> usize {
    let Some(before) = text[at..].find(['\n', '\r']) else { return text.len() };
    let end = at + before;
    end + if text[end..].starts_with("\r\n") { 2 } else { 1 }
}

/// The words of a text that begins at a byte of the file.
pub(super) fn words(text: &str, start: usize) -> impl Iterator<Item = Word<'_>> {
    let place = move |word: &str| word.as_ptr().addr() - text.as_ptr().addr() + start;
    text.split_whitespace().map(move |text| Word { text, at: place(text) })
}
