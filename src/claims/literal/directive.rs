//! Lines for the preprocessor.

use super::language::Language;
use super::token::{Kind, Token, Tokens};
use crate::diagnostic::{Diagnostic, SourceText};
use std::ops::Range;
use std::sync::Arc;

/// The words of a line for the preprocessor, without comments: `#ifndef A` gives `ifndef` and `A`. Those behind one that is not
/// read are left out.
fn parts(source: &Arc<SourceText>, line: &Token) -> Vec<Token> {
    let span = line.span.start + 1..line.span.end;
    let mut words = Tokens::of_macro(source, Language::C, span);
    let words = std::iter::from_fn(|| words.next().ok().flatten());
    words.skip_while(|word| matches!(word.kind, Kind::Sign(_))).collect()
}

/// The texts of these words.
pub(super) fn words<'a>(source: &'a Arc<SourceText>, line: &Token) -> Vec<&'a str> {
    parts(source, line).into_iter().map(|word| &source.text[word.span]).collect()
}

/// The conditional that is open before a word; that of an include guard does not count, where `#define` of the same
/// name follows and nothing but other lines for the preprocessor stands before.
pub(super) fn conditional(
    source: &Arc<SourceText>,
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
                    ["ifndef", name]
                    | ["if", "!", "defined", name]
                    | ["if", "!", "defined", "(", name, ")"] => Some(name),
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

/// What helps where a macro has no one value.
pub(super) const TYPED: &str =
    "type the numbers that the program holds into the claim file, as `cells`";

/// A macro with a value.
pub(super) struct Macro {
    /// Its line among the words of the file.
    pub(super) at: usize,
    /// Its name.
    pub(super) name: Range<usize>,
    /// The words of its value.
    pub(super) tokens: Vec<Token>,
}

/// The macros of this name among these lines that have a value: `#define W0 0.0625`.
///
/// # Errors
/// When a macro of this name has arguments, or is removed.
pub(super) fn macros<'t>(
    source: &Arc<SourceText>,
    language: Language,
    lines: impl Iterator<Item = (usize, &'t Token)>,
    name: &str,
) -> Result<Vec<Macro>, Diagnostic> {
    let mut macros = Vec::new();
    for (at, token) in lines.filter(|(_, token)| token.kind == Kind::Directive) {
        let text = |word: &Token| &source.text[word.span.clone()];
        let (kind, span) = match &parts(source, token)[..] {
            [kind, first, ..] if text(first) == name => (text(kind), first.span.clone()),
            _ => continue,
        };
        if !matches!(kind, "define" | "undef") {
            continue;
        }
        let wrong = |message| Err(Diagnostic::new(source, span.clone(), message).with_help(TYPED));
        if kind == "undef" {
            return wrong(format!("the macro `{name}` is removed here"));
        }
        if source.text[span.end..token.span.end].starts_with('(') {
            return wrong(format!("the macro `{name}` has arguments"));
        }
        let mut inner = Tokens::of_macro(source, language, span.end..token.span.end);
        let mut value = Vec::new();
        while let Some(token) = inner.next()? {
            value.push(token);
        }
        if !value.is_empty() {
            macros.push(Macro { at, name: span, tokens: value });
        }
    }
    Ok(macros)
}

/// Whether a sign of arithmetic stands between two values outside all brackets.
pub(super) fn is_open(tokens: &[Token]) -> bool {
    let mut depth = 0_usize;
    tokens.iter().enumerate().any(|(at, token)| {
        match token.kind {
            Kind::Sign('(' | '[' | '{') => depth += 1,
            Kind::Sign(')' | ']' | '}') => depth = depth.saturating_sub(1),
            _ => {}
        }
        let sign = matches!(token.kind, Kind::Sign('+' | '-' | '*' | '/'));
        let before = at.checked_sub(1).map(|before| tokens[before].kind);
        let value = matches!(before, Some(Kind::Number | Kind::Name | Kind::Sign(')')));
        depth == 0 && sign && value
    })
}
