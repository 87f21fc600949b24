//! Where the numbers of a table stand in a file.

use super::compiled::{is_compiled, not_conditional};
use super::declared::{Typed, declared};
use super::directive::{Macro, TYPED, is_open, macros, words};
use super::language::Language;
use super::place::Place;
use super::size::size;
use super::token::{Kind, Token, Tokens};
use super::uses::Uses;
use crate::diagnostic::{Diagnostic, SourceText};
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

/// The words of an initialiser.
pub(super) struct Initialiser {
    pub(super) tokens: Vec<Token>,
    /// The name.
    pub(super) name: Range<usize>,
    /// The types in its declaration.
    pub(super) types: Vec<Typed>,
    /// The lines for the preprocessor in the file.
    pub(super) directives: Vec<Token>,
    /// How many numbers it has by its declaration.
    pub(super) size: Option<usize>,
}

/// How deep macros may be nested.
const MAX_ROUNDS: usize = 16;

/// How many bytes macros may add to a file.
const MAX_ADDED: usize = 1 << 20;

/// The initialiser after the name `after`, in the source where each macro in it is replaced by its value, as the preprocessor
/// does.
pub(super) fn initialiser(
    source: &Arc<SourceText>,
    language: Language,
    after: &str,
) -> Result<(Arc<SourceText>, Initialiser), Diagnostic> {
    let mut written = Arc::clone(source);
    for _ in 0..MAX_ROUNDS {
        let found = located(&written, language, after)?;
        match replaced(&written, language, &found)? {
            None => return Ok((written, found)),
            Some(next) if next.text.len() > source.text.len() + MAX_ADDED => break,
            Some(next) => written = next,
        }
    }
    let message = format!(
        "the macros in `{after}` are more than {MAX_ROUNDS} deep, or make it longer by {MAX_ADDED} bytes"
    );
    let Initialiser { name, .. } = located(source, language, after)?;
    Err(Diagnostic::new(source, name, message).with_help(TYPED))
}

/// The source with the values of the macros that an initialiser names in their places; `None` where it names none.
fn replaced(
    source: &Arc<SourceText>,
    language: Language,
    found: &Initialiser,
) -> Result<Option<Arc<SourceText>>, Diagnostic> {
    let named = |token: &&Token| token.kind == Kind::Name;
    if found.directives.is_empty() || !found.tokens.iter().any(|token| named(&token)) {
        return Ok(None);
    }
    let all = words_of(source, language)?;
    let mut lines: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for (at, token) in all.iter().enumerate().filter(|(_, one)| one.kind == Kind::Directive) {
        if let ["define" | "undef", name, ..] = words(source, token)[..] {
            lines.entry(name).or_default().push(at);
        }
    }
    let in_macro = found.directives.iter().any(|line| line.span.contains(&found.name.start));
    let (mut text, mut end) = (String::new(), 0);
    for token in found.tokens.iter().filter(named) {
        if text.len() > source.text.len() + MAX_ADDED {
            break;
        }
        let name = &source.text[token.span.clone()];
        let Some(lines) = lines.get(name) else { continue };
        let directives = lines.iter().map(|at| (*at, &all[*at]));
        let [one] = &macros(source, language, directives, name)?[..] else {
            let message = format!("the macro `{name}` has no value here, or has several");
            return Err(Diagnostic::new(source, token.span.clone(), message).with_help(TYPED));
        };
        not_conditional(source, &all, one.at, None)?;
        if one.name.start > token.span.start && !in_macro {
            let message = format!("the macro `{name}` is defined only after this place");
            return Err(Diagnostic::new(source, token.span.clone(), message)
                .with_place(one.name.clone(), "here")
                .with_help("define it before the table, as a compiler needs it"));
        }
        let words = one.tokens.iter().map(|token| &source.text[token.span.clone()]);
        text += &source.text[end..token.span.start];
        text += &words.collect::<Vec<&str>>().join(" ");
        end = token.span.end;
    }
    text += &source.text[end..];
    Ok((end > 0).then(|| SourceText::new(source.name.clone(), text)))
}

/// The words of a file.
fn words_of(source: &Arc<SourceText>, language: Language) -> Result<Vec<Token>, Diagnostic> {
    let mut tokens = Tokens::new(source, language);
    std::iter::from_fn(|| tokens.next().transpose()).collect()
}

/// The words after the name `after`, up to the end of its initialiser: what follows `=`, or the first brace,
/// where nothing else but a type and brackets stands before. Places where the name is only used are passed over.
fn located(
    source: &Arc<SourceText>,
    language: Language,
    after: &str,
) -> Result<Initialiser, Diagnostic> {
    let all = words_of(source, language)?;
    let text = |token: &Token| &source.text[token.span.clone()];
    let macros = macros(source, language, all.iter().enumerate(), after)?;
    if let Some(open) = macros.iter().find(|one| is_open(&one.tokens)) {
        let message = format!(
            "the value of `{after}` is in no brackets, so that what stands beside it where it is used comes first"
        );
        return Err(Diagnostic::new(source, open.name.clone(), message).with_help(TYPED));
    }
    let named = |token: &Token| token.kind == Kind::Name && text(token) == after;
    let enclosed = enclosed(&all);
    let mut found: Vec<(usize, Range<usize>)> = Vec::new();
    let mut uses = macros.len();
    let mut others = Vec::new();
    for at in (0..all.len()).filter(|&at| named(&all[at])) {
        uses += 1;
        let place = Place { source, language, tokens: &all, name: at, enclosed: enclosed[at] };
        match place.begins() {
            Some(begin) => found.extend(place.value(begin).map(|range| (at, range))),
            None => others.push(at),
        }
    }
    let directives = |all: Vec<Token>| -> Vec<Token> {
        all.into_iter().filter(|token| token.kind == Kind::Directive).collect()
    };
    match found.len() + macros.len() {
        1 if found.is_empty() => {
            let Macro { at, name, tokens } = macros.into_iter().next().expect("one");
            not_conditional(source, &all, at, None)?;
            Ok(Initialiser {
                tokens,
                name,
                types: Vec::new(),
                directives: directives(all),
                size: None,
            })
        }
        1 => {
            let (at, range) = found.remove(0);
            is_compiled(source, language, &all, at)?;
            is_kept(source, language, &all, (at, &range), &others)?;
            Ok(Initialiser {
                size: size(source, language, &all, at, rows(&all[range.clone()]))?,
                name: all[at].span.clone(),
                types: declared(source, language, &all, at, range.start),
                tokens: all[range].to_vec(),
                directives: directives(all),
            })
        }
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
            let places = found.iter().map(|(at, _)| all[*at].span.clone());
            let mut places: Vec<Range<usize>> =
                places.chain(macros.into_iter().map(|one| one.name)).collect();
            places.sort_by_key(|place| place.start);
            let message = format!("`{after}` gets a value in {} places", places.len());
            let help = "an audit needs one place: cut the file, or rename one of them";
            let [first, second] = [0, 1].map(|place: usize| places[place].clone());
            Err(Diagnostic::new(source, first, message)
                .with_label("the first")
                .with_place(second, "the second")
                .with_help(help))
        }
    }
}

/// Refuses a table whose numbers other uses of its name may change.
fn is_kept(
    source: &Arc<SourceText>,
    language: Language,
    tokens: &[Token],
    (at, value): (usize, &Range<usize>),
    others: &[usize],
) -> Result<(), Diagnostic> {
    let name = &source.text[tokens[at].span.clone()];
    let uses = Uses::new(source, language, tokens);
    let table = uses.declared(at, value);
    if let Some(word) = uses.own_constructor(value) {
        let called = &source.text[tokens[word].span.clone()];
        let message = format!("`{called}` has a meaning of its own in this file");
        return Err(Diagnostic::new(source, tokens[word].span.clone(), message).with_help(TYPED));
    }
    let shared = || Some((at, uses.shared(at, table)?));
    let fault = others.iter().find_map(|&other| Some((other, uses.fault(other, table)?)));
    let hidden = || Some((uses.hidden(name, table)?, "may be changed where this is used"));
    let Some((place, fault)) = fault.or_else(hidden).or_else(shared) else { return Ok(()) };
    let message = format!("`{name}` {fault}, so that the program may hold other numbers later");
    Err(Diagnostic::new(source, tokens[place].span.clone(), message)
        .with_place(tokens[at].span.clone(), "declared here")
        .with_help(format!(
            "{}type the numbers that it holds in the end into the claim file, as `cells`, or rename one of the two",
            language.constant().map_or(String::new(), |how| format!("declare it {how}, or "))
        )))
}

/// How many items an initialiser has in its outermost bracket, and whether these are lists.
fn rows(tokens: &[Token]) -> (usize, bool) {
    let (mut depth, mut items, mut lists) = (0_usize, 1, false);
    for (at, token) in tokens.iter().enumerate() {
        match token.kind {
            Kind::Sign(sign @ ('(' | '[' | '{')) => {
                lists |= depth == 1 && sign == '{';
                depth += 1;
            }
            Kind::Sign(')' | ']' | '}') => depth = depth.saturating_sub(1),
            // None stands behind the last comma of `{1, 2,}`.
            Kind::Sign(',') if depth == 1 && at + 2 < tokens.len() => items += 1,
            _ => {}
        }
    }
    (items, lists)
}

/// Of each word whether a bracket is open before it.
fn enclosed(tokens: &[Token]) -> Vec<bool> {
    let mut depth = 0_usize;
    let before = tokens.iter().map(|token| {
        let inside = depth > 0;
        match token.kind {
            Kind::Sign('(' | '[' | '{') => depth += 1,
            Kind::Sign(')' | ']' | '}') => depth = depth.saturating_sub(1),
            _ => {}
        }
        inside
    });
    before.collect()
}
