//! Lines for the preprocessor.

use super::token::{Kind, Token};
use crate::diagnostic::SourceText;
use std::ops::Range;

/// The length of a line for the preprocessor, with the lines that `\` or a comment joins to it.
pub(super) fn directive_length(rest: &str) -> usize {
    let bytes = rest.as_bytes();
    let (mut at, mut comment) = (0, false);
    while at < bytes.len() {
        let after = &bytes[at..];
        at += match after[0] {
            b'\n' => return at + 1,
            b'\\' => {
                let blanks = after[1..].iter().take_while(|b| matches!(b, b' ' | b'\t' | b'\r'));
                let length = 1 + blanks.count();
                length + usize::from(after.get(length) == Some(&b'\n'))
            }
            b'/' if !comment && after.starts_with(b"//") => {
                comment = true;
                2
            }
            b'/' if !comment && after.starts_with(b"/*") => {
                rest[at + 2..].find("*/").map_or(after.len(), |length| length + 4)
            }
            quote @ (b'"' | b'\'') if !comment => {
                let closes =
                    after[1..].iter().take_while(|&&b| b != b'\n').position(|&b| b == quote);
                closes.map_or(1, |length| length + 2)
            }
            _ => 1,
        };
    }
    at
}

/// The words of a line for the preprocessor: `#ifndef A` gives `ifndef` and `A`.
pub(super) fn words<'a>(source: &'a SourceText, token: &Token) -> Vec<&'a str> {
    let line = &source.text[token.span.clone()];
    line.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty()).collect()
}

/// The conditional that is open before a word; that of an include guard does not count, where `#define` of the same
/// name follows and nothing but other lines for the preprocessor stands before.
pub(super) fn conditional(
    source: &SourceText,
    tokens: &[Token],
    at: usize,
) -> Option<Range<usize>> {
    let mut open: Vec<(Range<usize>, bool)> = Vec::new();
    let mut only_directives = true;
    for (place, token) in tokens[..at].iter().enumerate() {
        only_directives &= token.kind == Kind::Directive;
        if token.kind != Kind::Directive {
            continue;
        }
        let words = words(source, token);
        match words.first().copied().unwrap_or_default() {
            "if" | "ifdef" | "ifndef" => {
                let next = tokens.get(place + 1).filter(|next| next.kind == Kind::Directive);
                let defines = next.map(|next| self::words(source, next)).unwrap_or_default();
                let name = match words[..] {
                    ["ifndef", name] => Some(name),
                    ["if", "defined", name] if source.text[token.span.clone()].contains('!') => {
                        Some(name)
                    }
                    _ => None,
                };
                let guard = only_directives
                    && open.is_empty()
                    && name.is_some()
                    && defines.first() == Some(&"define")
                    && defines.get(1).copied() == name;
                open.push((token.span.clone(), guard));
            }
            "endif" => drop(open.pop()),
            word if word.starts_with("el") => {
                if let Some((span, guard)) = open.last_mut() {
                    (*span, *guard) = (token.span.clone(), false);
                }
            }
            _ => {}
        }
    }
    open.into_iter().rev().find(|(_, guard)| !guard).map(|(span, _)| span)
}
