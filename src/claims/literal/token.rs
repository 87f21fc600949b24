//! The words of a source file.

use super::language::Language;
use super::quoted::{
    block_length, directive_length, number_length, raw_length, regex_length, template_length,
};
use crate::diagnostic::{Diagnostic, SourceText};
use std::ops::Range;
use std::sync::Arc;

/// Words after which `/` divides nothing and `'` transposes nothing.
const VALUELESS: [&str; 19] = [
    "return",
    "typeof",
    "case",
    "in",
    "of",
    "instanceof",
    "new",
    "delete",
    "void",
    "throw",
    "do",
    "else",
    "yield",
    "await",
    "default",
    "if",
    "elseif",
    "while",
    "switch",
];

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

/// What is known of the last word.
#[derive(Default)]
pub(super) struct Seen {
    /// Whether it ends a value, so that `/` divides it.
    pub(super) value: bool,
    /// The word, where it is a sign.
    pub(super) sign: Option<char>,
    /// Whether it is the second sign of `++` or `--`.
    doubled: bool,
    /// Whether a condition in brackets follows.
    condition: bool,
}

/// Reads words from a place on. Comments and white space are left out.
pub(super) struct Tokens<'a> {
    source: &'a Arc<SourceText>,
    pub(super) language: Language,
    at: usize,
    /// Where the words end.
    end: usize,
    /// Whether these are the words of a macro, in which `\` joins lines.
    in_macro: bool,
    /// Whether no word stands before on this line; comments are blanks.
    fresh: bool,
    pub(super) seen: Seen,
    /// The brackets that are open, and whether each holds a condition, behind which no value ends.
    pub(super) open: Vec<(char, bool)>,
}

impl<'a> Tokens<'a> {
    pub(super) fn new(source: &'a Arc<SourceText>, language: Language) -> Tokens<'a> {
        let end = source.text.len();
        let mark = end - source.text.trim_start_matches('\u{feff}').len();
        Tokens { in_macro: false, fresh: true, ..Tokens::of_macro(source, language, mark..end) }
    }

    /// The words of a macro, which stand at these bytes.
    pub(super) fn of_macro(
        source: &'a Arc<SourceText>,
        language: Language,
        bytes: Range<usize>,
    ) -> Tokens<'a> {
        Tokens {
            source,
            language,
            at: bytes.start,
            end: bytes.end,
            in_macro: true,
            fresh: false,
            seen: Seen::default(),
            open: Vec::new(),
        }
    }

    fn rest(&self) -> &'a str {
        &self.source.text[self.at..self.end]
    }

    /// The next word; `None` at the end of the file.
    ///
    /// # Errors
    /// When a comment or a text has no end, `\` joins two lines, or it depends on more than the words before what stands here.
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
        } else if self.fresh && self.is_directive(rest) {
            self.at += directive_length(rest, self.language);
            Kind::Directive
        } else if self.is_quote(first, rest) {
            self.at += self.text_length(first)?;
            Kind::Text
        } else if let Some(length) = self.regex(rest) {
            self.at += length;
            Kind::Text
        } else {
            self.at += first.len_utf8();
            Kind::Sign(first)
        };
        let word = &self.source.text[start..self.at];
        if let Some((message, help)) = self.unclear(kind, word, rest) {
            let end = start + first.len_utf8();
            return Err(Diagnostic::new(self.source, start..end, message).with_help(help));
        }
        self.passed(kind, start);
        Ok(Some(Token { kind, span: start..self.at }))
    }

    /// Notes what the next word depends on.
    fn passed(&mut self, kind: Kind, start: usize) {
        let (before, word) = self.source.text[..self.at].split_at(start);
        let member = self.seen.sign == Some('.');
        self.seen.value = match kind {
            Kind::Sign(')' | ']' | '}') => !self.open.pop().is_some_and(|(_, condition)| condition),
            // `i++`, but not `1 + +i`
            Kind::Sign(sign @ ('+' | '-')) => !self.seen.doubled && before.ends_with(sign),
            Kind::Sign('\'') => self.language == Language::Matlab,
            Kind::Sign(_) => false,
            _ => member || !VALUELESS.contains(&word),
        };
        if let Kind::Sign(sign @ ('(' | '[' | '{')) = kind {
            self.open.push((sign, sign == '(' && self.seen.condition));
        }
        self.seen.condition = self.language == Language::JavaScript
            && !member
            && matches!(word, "if" | "while" | "for" | "with");
        self.seen.sign = if let Kind::Sign(sign) = kind { Some(sign) } else { None };
        self.seen.doubled = self.seen.value && matches!(kind, Kind::Sign('+' | '-'));
        self.fresh = kind == Kind::Directive;
    }

    /// Whether a line for the preprocessor begins here, also with signs that stand for `#`.
    fn is_directive(&self, rest: &str) -> bool {
        let marks = ["#", "%:", "??="];
        self.language.has_preprocessor() && marks.iter().any(|mark| rest.starts_with(mark))
    }

    /// The length of a regular expression of JavaScript that begins here.
    fn regex(&self, rest: &str) -> Option<usize> {
        let may = self.language == Language::JavaScript && !self.seen.value;
        regex_length(rest).filter(|_| may)
    }

    /// Skips white space and comments.
    fn skip(&mut self) -> Result<(), Diagnostic> {
        let mut goes_on = self.in_macro;
        loop {
            let rest = self.rest();
            let white = length(rest, char::is_whitespace);
            self.fresh |= rest[..white].contains('\n') && !goes_on;
            self.seen.value &= !(self.fresh && self.language == Language::Matlab);
            let comment = &rest[white..];
            goes_on =
                self.in_macro || self.language == Language::Matlab && comment.starts_with("...");
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

    /// Whether a text begins here. In Rust, `'a` may be a lifetime.
    fn is_quote(&self, first: char, rest: &str) -> bool {
        match first {
            '`' => self.language == Language::JavaScript,
            '\'' if self.language == Language::Rust => {
                let mut after = rest.chars().skip(1);
                let (one, two) = (after.next(), after.next());
                one == Some('\\') || two == Some('\'')
            }
            // Behind a value or a point it transposes.
            '\'' if self.language == Language::Matlab => {
                let before = &self.source.text[..self.at];
                !(self.seen.value || self.seen.sign == Some('.'))
                    || before.ends_with(char::is_whitespace)
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

/// How many bytes of a text have this property.
fn length(text: &str, has: impl Fn(char) -> bool) -> usize {
    text.find(|c| !has(c)).unwrap_or(text.len())
}
