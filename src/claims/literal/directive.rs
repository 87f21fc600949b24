//! Lines for the preprocessor.

use super::token::{Kind, Token};
use crate::diagnostic::SourceText;
use std::ops::Range;

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
