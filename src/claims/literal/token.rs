//! The words of a source file.

use super::language::Language;
use super::quoted::{directive_length, raw_length, regex_length, template_length};
use crate::diagnostic::{Diagnostic, SourceText};
use std::ops::Range;
use std::sync::Arc;

/// What a word is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A number, from its first digit or point to its suffix.
    Number,
    /// A name, or a keyword.
    Name,
    /// A text in quotes.
    Text,
    /// A line for the preprocessor.
    Directive,
    /// Any other character.
    Sign(char),
}

/// A word and its bytes.
#[derive(Clone, Debug)]
pub(super) struct Token {
    pub(super) kind: Kind,
    pub(super) span: Range<usize>,
}

/// Reads words from a place on. Comments and white space are left out.
pub(super) struct Tokens<'a> {
    source: &'a Arc<SourceText>,
    language: Language,
    at: usize,
    /// Whether the last word ends a value, so that `/` divides it.
    value: bool,
    /// Where the words end.
    end: usize,
    /// Whether these are the words of a macro, in which `\` joins lines.
    in_macro: bool,
}

impl<'a> Tokens<'a> {
    pub(super) fn new(source: &'a Arc<SourceText>, language: Language) -> Tokens<'a> {
        let end = source.text.len();
        Tokens { source, language, at: 0, value: false, end, in_macro: false }
    }

    /// The words of a macro, which stand at these bytes.
    pub(super) fn of_macro(
        source: &'a Arc<SourceText>,
        language: Language,
        bytes: Range<usize>,
    ) -> Tokens<'a> {
        Tokens { source, language, at: bytes.start, value: false, end: bytes.end, in_macro: true }
    }

    fn rest(&self) -> &'a str {
        &self.source.text[self.at..self.end]
    }

    /// The next word; `None` at the end of the file.
    ///
    /// # Errors
    /// When a comment or a text has no end, or `\` joins two lines.
    pub(super) fn next(&mut self) -> Result<Option<Token>, Diagnostic> {
        self.skip()?;
        let (start, rest) = (self.at, self.rest());
        let Some(first) = rest.chars().next() else { return Ok(None) };
        let second = rest[first.len_utf8()..].chars().next();
        let kind = if first.is_ascii_digit()
            || first == '.' && second.is_some_and(|c| c.is_ascii_digit())
        {
            self.at += number_length(rest, self.language);
            Kind::Number
        } else if let Some(length) = raw_length(rest, self.language) {
            self.at += length;
            Kind::Text
        } else if first.is_alphabetic() || first == '_' {
            self.at += length(rest, |c| c.is_alphanumeric() || c == '_');
            Kind::Name
        } else if first == '#' && self.language.has_preprocessor() && self.begins_line() {
            self.at += directive_length(rest);
            Kind::Directive
        } else if self.is_quote(first, rest) {
            self.at += self.text_length(first)?;
            Kind::Text
        } else if let Some(length) = self.regex(rest) {
            self.at += length;
            Kind::Text
        } else if first == '\\' && self.language.has_preprocessor() {
            let message = "`\\` joins two lines outside of a macro";
            return Err(Diagnostic::new(self.source, start..start + 1, message)
                .with_help("write both as one line, without the `\\`"));
        } else {
            self.at += first.len_utf8();
            Kind::Sign(first)
        };
        let word = &self.source.text[start..self.at];
        self.value = match kind {
            Kind::Sign(sign) => matches!(sign, ')' | ']' | '}'),
            _ => !matches!(word, "return" | "typeof" | "case"),
        };
        Ok(Some(Token { kind, span: start..self.at }))
    }

    /// The length of a regular expression of JavaScript that begins here.
    fn regex(&self, rest: &str) -> Option<usize> {
        let may = self.language == Language::JavaScript && !self.value;
        regex_length(rest).filter(|_| may)
    }

    /// Skips white space and comments.
    fn skip(&mut self) -> Result<(), Diagnostic> {
        loop {
            let rest = self.rest();
            let white = length(rest, char::is_whitespace);
            let comment = &rest[white..];
            let mut marks = self.language.line_comments().iter();
            let continues = self.language == Language::Python || self.in_macro;
            let length =
                if continues && (comment.starts_with("\\\n") || comment.starts_with("\\\r\n")) {
                    1
                } else if self.language.has_block_comments() && comment.starts_with("/*") {
                    self.comment_length(self.at + white, comment)?
                } else if self.language == Language::Matlab && comment.starts_with("%{") {
                    block_length(comment)
                } else if marks.any(|mark| comment.starts_with(mark))
                    || self.language == Language::Matlab && comment.starts_with("...")
                {
                    let length = comment.find('\n').unwrap_or(comment.len());
                    self.ends_with_its_line(self.at + white, comment, length)?;
                    length
                } else {
                    self.at += white;
                    return Ok(());
                };
            self.at += white + length;
        }
    }

    /// Refuses a comment whose line ends with `\`, where that makes code of the next line a comment: in C it does, in
    /// shaders not always.
    fn ends_with_its_line(
        &self,
        start: usize,
        comment: &str,
        length: usize,
    ) -> Result<(), Diagnostic> {
        let line = comment[..length].trim_end();
        let joins = line.ends_with('\\') || line.ends_with("??/");
        let next = comment[length..].lines().nth(1).unwrap_or_default().trim();
        if !self.language.has_preprocessor() || !joins || next.is_empty() || next.starts_with("//")
        {
            return Ok(());
        }
        let message =
            "this comment ends with `\\`, so that a compiler may take the next line as part of it";
        let place = start + line.len() - 1..start + line.len();
        Err(Diagnostic::new(self.source, place, message).with_help(
            "end the comment with another character than `\\`, or make the next line a comment too",
        ))
    }

    /// The length of a comment `/* … */`; those of Rust and WGSL may have others within.
    fn comment_length(&self, start: usize, comment: &str) -> Result<usize, Diagnostic> {
        let (mut depth, mut at) = (0_usize, 0);
        while at < comment.len() {
            let rest = &comment.as_bytes()[at..];
            if rest.starts_with(b"*/") {
                depth -= 1;
                at += 2;
                if depth == 0 {
                    return Ok(at);
                }
            } else if rest.starts_with(b"/*")
                && (depth == 0 || matches!(self.language, Language::Rust | Language::Wgsl))
            {
                depth += 1;
                at += 2;
            } else {
                at += 1;
            }
        }
        let message = "a comment has no end";
        Err(Diagnostic::new(self.source, start..start + 2, message).with_label("it begins here"))
    }

    fn begins_line(&self) -> bool {
        let before = self.source.text[..self.at].bytes().rev().take_while(|&b| b != b'\n');
        before.into_iter().all(|b| b.is_ascii_whitespace())
    }

    /// Whether a text begins here. In Rust, `'a` may be a lifetime.
    fn is_quote(&self, first: char, rest: &str) -> bool {
        match first {
            '`' => self.language == Language::JavaScript,
            '\'' if self.language == Language::Rust => {
                let mut after = rest.chars().skip(1);
                let (one, two) = (after.next(), after.next());
                one == Some('\\') || two == Some('\'')
            }
            // Behind a value it transposes.
            '\'' if self.language == Language::Matlab => {
                !self.value || self.source.text[..self.at].ends_with(char::is_whitespace)
            }
            '"' | '\'' => true,
            _ => false,
        }
    }

    fn text_length(&self, quote: char) -> Result<usize, Diagnostic> {
        let rest = self.rest();
        if quote == '`' {
            return template_length(rest, 0).ok_or_else(|| self.no_end(1));
        }
        let triple: String = std::iter::repeat_n(quote, 3).collect();
        let open = if self.language == Language::Python && rest.starts_with(&triple) {
            triple.as_str()
        } else {
            &rest[..quote.len_utf8()]
        };
        let mut at = open.len();
        while at < rest.len() {
            let after = &rest[at..];
            if let Some(behind) = after.strip_prefix(open) {
                // In MATLAB, two quotes are one of the text.
                if self.language != Language::Matlab || !behind.starts_with(open) {
                    return Ok(at + open.len());
                }
                at += open.len();
            }
            if after.starts_with('\n') && open.len() == 1 && self.language != Language::Rust {
                break;
            }
            let mut characters = after.chars();
            let first = characters.next().map_or(0, char::len_utf8);
            at += first;
            if after.starts_with("\\\r\n") {
                at += 2;
            } else if after.starts_with('\\') && self.language != Language::Matlab {
                at += characters.next().map_or(0, char::len_utf8);
            }
        }
        Err(self.no_end(open.len()))
    }

    fn no_end(&self, length: usize) -> Diagnostic {
        let message = "a text in quotes has no end";
        Diagnostic::new(self.source, self.at..self.at + length, message)
            .with_label("it begins here")
            .with_help("if the language reads it differently, cut the file to the table")
    }
}

/// The length of a comment of MATLAB between lines `%{` and `%}`, or of the line.
fn block_length(comment: &str) -> usize {
    let (mut depth, mut length) = (0_usize, 0);
    for line in comment.split_inclusive('\n') {
        length += line.len();
        match line.trim() {
            "%{" => depth += 1,
            "%}" => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            break;
        }
    }
    length
}

/// How many bytes of a text have this property.
fn length(text: &str, has: impl Fn(char) -> bool) -> usize {
    text.find(|c| !has(c)).unwrap_or(text.len())
}

/// A number takes all letters, digits and separators that follow, one point, and signs after an exponent. Two
/// points in a row are none of it, as in `0..3`.
fn number_length(rest: &str, language: Language) -> usize {
    let bytes = rest.as_bytes();
    let hexadecimal = rest.len() > 1 && bytes[0] == b'0' && bytes[1].eq_ignore_ascii_case(&b'x');
    let exponents: &[u8] = match language {
        _ if hexadecimal => b"pP",
        Language::Matlab => b"eEdD",
        _ => b"eE",
    };
    let mut at = 0;
    while at < bytes.len() {
        let (byte, next) = (bytes[at], bytes.get(at + 1).copied());
        let taken = match byte {
            b'.' => next != Some(b'.') && !bytes[..at].contains(&b'.'),
            b'+' | b'-' => at > 0 && exponents.contains(&bytes[at - 1]),
            b'\'' => language == Language::C && next.is_some_and(|b| b.is_ascii_alphanumeric()),
            _ => byte.is_ascii_alphanumeric() || byte == b'_',
        };
        if !taken {
            break;
        }
        at += 1;
    }
    at
}
