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
        loop {
            let rest = &self.source.text[self.at..];
            if rest.is_empty() {
                return None;
            }
            // Old Macintosh files end their lines with \r alone.
            let end = rest.find(['\n', '\r']).map_or(rest.len(), |end| end + 1);
            let (line, start) = (&rest[..end], self.at);
            self.at += end;
            let text =
                if self.comments { line.split('#').next().unwrap_or_default() } else { line };
            let words: Line<'a> = words(text, start);
            if !words.is_empty() {
                return Some(words);
            }
        }
    }
}

fn words(text: &str, start: usize) -> Vec<Word<'_>> {
    let place = |word: &str| word.as_ptr().addr() - text.as_ptr().addr() + start;
    text.split_whitespace().map(|text| Word { text, at: place(text) }).collect()
}
