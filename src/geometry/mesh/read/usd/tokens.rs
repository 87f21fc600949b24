//! Words, strings and brackets of a `.usda` file.

use crate::diagnostic::{Diagnostic, SourceText};
use std::ops::Range;
use std::sync::Arc;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A name, a number or a type such as `point3f[]`.
    Word,
    /// What stands between quotation marks.
    Text,
    /// A path `<…>` or an asset `@…@`.
    Path,
    /// One of `( ) [ ] { } = , ;`.
    Sign(u8),
}

#[derive(Clone, Debug)]
pub(super) struct Token {
    pub(super) kind: Kind,
    /// Its bytes in the file, of a text without the quotation marks.
    pub(super) place: Range<usize>,
    /// How many lines are before it.
    pub(super) line: usize,
}

const SIGNS: &[u8] = b"()[]{}=,;";

/// All tokens of a text from a byte on; `#` begins a comment.
pub(super) fn tokens(source: &Arc<SourceText>, start: usize) -> Result<Vec<Token>, Diagnostic> {
    let bytes = source.text.as_bytes();
    let (mut all, mut at, mut line) = (Vec::new(), start, 0);
    while let Some(&byte) = bytes.get(at) {
        if byte == b'\n' {
            line += 1;
            at += 1;
        } else if byte.is_ascii_whitespace() {
            at += 1;
        } else if byte == b'#' {
            at = find(bytes, at, b"\n").unwrap_or(bytes.len());
        } else if SIGNS.contains(&byte) {
            all.push(Token { kind: Kind::Sign(byte), place: at..at + 1, line });
            at += 1;
        } else if let Some((kind, mark, close)) = quoted(&bytes[at..]) {
            let inside = at + mark;
            let Some(end) = closing(bytes, inside, close) else {
                let message = "what begins here has no end";
                return Err(Diagnostic::new(source, at..at + mark, message).with_help(
                    "a quotation mark or a bracket is missing, or the file is cut off",
                ));
            };
            all.push(Token { kind, place: inside..end, line });
            line += source.text[inside..end].matches('\n').count();
            at = end + close.len();
        } else {
            let ends =
                |b: &u8| b.is_ascii_whitespace() || SIGNS.contains(b) || b"\"'<>@#".contains(b);
            // A character that stands for nothing is a word of its own.
            let rest = &bytes[at + 1..];
            let mut end = at + 1 + rest.iter().position(ends).unwrap_or(rest.len());
            if bytes[end..].starts_with(b"[]") {
                end += 2;
            }
            all.push(Token { kind: Kind::Word, place: at..end, line });
            at = end;
        }
    }
    Ok(all)
}

/// The kind of a token with marks at both ends, the length of the first and the last one.
fn quoted(rest: &[u8]) -> Option<(Kind, usize, &'static [u8])> {
    let marks: [(&[u8], Kind, &'static [u8]); 7] = [
        (b"\"\"\"", Kind::Text, b"\"\"\""),
        (b"'''", Kind::Text, b"'''"),
        (b"\"", Kind::Text, b"\""),
        (b"'", Kind::Text, b"'"),
        (b"<", Kind::Path, b">"),
        (b"@@@", Kind::Path, b"@@@"),
        (b"@", Kind::Path, b"@"),
    ];
    marks.into_iter().find(|(open, ..)| rest.starts_with(open)).map(|(o, k, c)| (k, o.len(), c))
}

fn find(bytes: &[u8], from: usize, what: &[u8]) -> Option<usize> {
    bytes[from..].windows(what.len()).position(|window| window == what).map(|at| from + at)
}

/// Where a mark closes; a backslash hides the character after it.
fn closing(bytes: &[u8], from: usize, close: &[u8]) -> Option<usize> {
    let mut at = from;
    while at < bytes.len() {
        if bytes[at] == b'\\' {
            at += 2;
        } else if bytes[at..].starts_with(close) {
            return Some(at);
        } else {
            at += 1;
        }
    }
    None
}
