//! Whether a place is compiled, as far as a file says so.

use super::declared::statement;
use super::directive::{conditional, words};
use super::language::Language;
use super::token::{Kind, Token};
use crate::diagnostic::{Diagnostic, SourceText};
use std::ops::Range;
use std::sync::Arc;

/// Refuses a table of which a conditional says whether it is compiled, or with which type.
pub(super) fn is_compiled(
    source: &Arc<SourceText>,
    language: Language,
    tokens: &[Token],
    at: usize,
) -> Result<(), Diagnostic> {
    if let Some(mark) = conditional_item(source, language, tokens, at) {
        return Err(refused(source, &tokens[at], tokens[mark].span.clone(), "compiler"));
    }
    if !language.has_preprocessor() {
        return Ok(());
    }
    let start = statement(tokens, at);
    // `#endif` between the type and the name.
    let split = start.checked_sub(1).map(|before| &tokens[before]).filter(|before| {
        let qualifies = |token: &Token| {
            let word = &source.text[token.span.clone()];
            token.kind != Kind::Name || ["const", "static", "constexpr", "inline"].contains(&word)
        };
        before.kind == Kind::Directive
            && matches!(words(source, before).first(), Some(&("endif" | "else" | "elif")))
            && tokens[start..at].iter().all(qualifies)
    });
    not_conditional(source, tokens, at, split.map(|token| token.span.clone()))
}

/// Refuses what a conditional of the preprocessor, open before a word or `other`, may leave out.
pub(super) fn not_conditional(
    source: &Arc<SourceText>,
    tokens: &[Token],
    at: usize,
    other: Option<Range<usize>>,
) -> Result<(), Diagnostic> {
    match conditional(source, tokens, at).or(other) {
        Some(span) => Err(refused(source, &tokens[at], span.start..span.start + 1, "preprocessor")),
        None => Ok(()),
    }
}

fn refused(source: &Arc<SourceText>, token: &Token, by: Range<usize>, whose: &str) -> Diagnostic {
    let message = format!("whether this is compiled depends on a conditional of the {whose}");
    Diagnostic::new(source, token.span.clone(), message)
        .with_place(by, "this one")
        .with_help("copy what is compiled into a file without conditionals, or type the numbers into the claim file, as `cells`")
}

/// The word `cfg` of Rust or `constexpr` of C++ that decides about the item or block around a word.
fn conditional_item(
    source: &SourceText,
    language: Language,
    tokens: &[Token],
    at: usize,
) -> Option<usize> {
    let text = |at: usize| tokens.get(at).map_or("", |token| &source.text[token.span.clone()]);
    (1..at).find(|&mark| {
        let decides = match language {
            Language::Rust => match text(mark) {
                "cfg" | "cfg_attr" => text(mark - 1) == "[",
                word => word.starts_with("cfg_") && text(mark + 1) == "!",
            },
            Language::C => {
                text(mark - 1) == "if" && matches!(text(mark), "constexpr" | "consteval")
            }
            _ => false,
        };
        // `#![cfg(…)]` decides about what is around it.
        let around = mark > 1 && text(mark - 2) == "!";
        decides && (around || at < item_end(tokens, mark, |at| text(at) == "else"))
    })
}

/// Where the item or block ends that begins at a word, with those behind `else`.
fn item_end(tokens: &[Token], start: usize, goes_on: impl Fn(usize) -> bool) -> usize {
    let mut depth = 0_usize;
    for (at, token) in tokens.iter().enumerate().skip(start) {
        match token.kind {
            Kind::Sign('(' | '[' | '{') => depth += 1,
            // The bracket of the attribute opened before.
            Kind::Sign(']') if depth == 0 => {}
            Kind::Sign(')' | '}') if depth == 0 => return at,
            Kind::Sign(')' | ']') => depth -= 1,
            Kind::Sign('}') => {
                depth -= 1;
                if depth == 0 && !goes_on(at + 1) {
                    return at;
                }
            }
            Kind::Sign(';') if depth == 0 && !goes_on(at + 1) => return at,
            _ => {}
        }
    }
    tokens.len()
}
