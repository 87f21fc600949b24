//! Where the numbers of a table stand in a file.

use super::language::Language;
use super::token::{Kind, Token, Tokens};
use crate::diagnostic::{Diagnostic, SourceText};
use std::ops::Range;
use std::sync::Arc;

/// The words of an initialiser.
pub(super) struct Initialiser {
    pub(super) tokens: Vec<Token>,
    /// The name.
    pub(super) name: Range<usize>,
}

/// The words after the name `after`, up to the end of its initialiser: what follows `=`, or the first brace,
/// where nothing else but a type and brackets stands before. Places where the name is only used are passed over.
pub(super) fn initialiser(
    source: &Arc<SourceText>,
    language: Language,
    after: &str,
) -> Result<Initialiser, Diagnostic> {
    let mut tokens = Tokens::new(source, language);
    let mut all = Vec::new();
    while let Some(token) = tokens.next()? {
        all.push(token);
    }
    let text = |token: &Token| &source.text[token.span.clone()];
    let named = |token: &Token| token.kind == Kind::Name && text(token) == after;
    let mut found: Vec<Initialiser> = Vec::new();
    let mut uses = 0;
    for (at, token) in all.iter().enumerate().filter(|(_, token)| named(token)) {
        uses += 1;
        if let Some(range) = value_after(source, language, &all, at + 1) {
            found.push(Initialiser { tokens: all[range].to_vec(), name: token.span.clone() });
        }
    }
    match found.len() {
        1 => Ok(found.remove(0)),
        0 if uses == 0 => {
            let message = format!("`{after}` does not occur in this file");
            let help =
                "give the name of the array as it stands there; comments and texts do not count";
            Err(Diagnostic::new(source, 0..0, message).with_help(help))
        }
        0 => {
            let message = format!("`{after}` occurs, but no value is assigned to it");
            let first =
                all.iter().find(|token| named(token)).map_or(0..0, |token| token.span.clone());
            let help = "the name has to stand before `=` and the numbers, or before their braces";
            Err(Diagnostic::new(source, first, message).with_help(help))
        }
        _ => {
            let message = format!("`{after}` gets a value in {} places", found.len());
            let help = "an audit needs one place: cut the file, or rename one of them";
            let [first, second] = [found[0].name.clone(), found[1].name.clone()];
            Err(Diagnostic::new(source, first, message)
                .with_label("the first")
                .with_place(second, "the second")
                .with_help(help))
        }
    }
}

/// The words of the value that the name before `start` gets: up to a comma, a semicolon or a bracket that was
/// opened before; in JavaScript and Python, also up to the end of a line.
fn value_after(
    source: &SourceText,
    language: Language,
    tokens: &[Token],
    start: usize,
) -> Option<Range<usize>> {
    let begin = assigned(tokens, start)?;
    let mut depth = 0_usize;
    let mut end = begin;
    while let Some(token) = tokens.get(end) {
        match token.kind {
            _ if depth == 0 && end > begin && ends(source, language, tokens, end) => break,
            Kind::Sign('(' | '[' | '{') => depth += 1,
            Kind::Sign(')' | ']' | '}' | ';' | ',') if depth == 0 => break,
            Kind::Sign(')' | ']' | '}') => depth -= 1,
            _ => {}
        }
        end += 1;
    }
    (begin < end).then_some(begin..end)
}

/// Whether a value ends before this word, because a line ends there.
fn ends(source: &SourceText, language: Language, tokens: &[Token], at: usize) -> bool {
    let between = &source.text[tokens[at - 1].span.end..tokens[at].span.start];
    let goes_on = matches!(tokens[at].kind, Kind::Sign('+' | '-' | '*' | '/'));
    between.contains('\n')
        && match language {
            Language::Python => true,
            Language::JavaScript => !goes_on,
            _ => false,
        }
}

/// Where the value begins: after `=`, or at a brace that follows the name and its brackets at once.
fn assigned(tokens: &[Token], start: usize) -> Option<usize> {
    let mut depth = 0_usize;
    for (at, token) in tokens.iter().enumerate().skip(start) {
        match token.kind {
            Kind::Sign('=') if depth == 0 => {
                let next = tokens.get(at + 1)?;
                // Neither a comparison nor a function.
                let joined = next.span.start == token.span.end;
                let other = joined && matches!(next.kind, Kind::Sign('=' | '>'));
                return (!other).then_some(at + 1);
            }
            Kind::Sign('{') if depth == 0 => return Some(at),
            Kind::Sign('[' | '(' | '<') => depth += 1,
            Kind::Sign(']' | ')' | '>') => depth = depth.checked_sub(1)?,
            // Between the name and `=` stands at most a type, as in `name: [f32; 7] =`.
            Kind::Sign(':' | '&' | '\'' | '*' | '.') | Kind::Name => {}
            _ if depth > 0 => {}
            _ => return None,
        }
    }
    None
}
