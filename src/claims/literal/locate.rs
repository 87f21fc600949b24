//! Where the numbers of a table stand in a file.

use super::declared::{Typed, declared, statement};
use super::directive::{conditional, words};
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
    /// The types in its declaration.
    pub(super) types: Vec<Typed>,
    /// The lines for the preprocessor in the file.
    pub(super) directives: Vec<Token>,
}

/// What happens to a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Use {
    /// It gets a value, which begins at this word.
    Value(usize),
    /// Its value is changed.
    Change,
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
    let enclosed = enclosed(&all);
    let mut found: Vec<(usize, Range<usize>)> = Vec::new();
    let mut uses = 0;
    for (at, token) in all.iter().enumerate().filter(|(_, token)| named(token)) {
        uses += 1;
        let place = Place { source, language, tokens: &all, name: at, enclosed: enclosed[at] };
        match place.used() {
            Some(Use::Value(begin)) => found.extend(place.value(begin).map(|range| (at, range))),
            Some(Use::Change) => {
                let message = format!(
                    "`{after}` is changed here, so that the program holds other numbers later"
                );
                let help = "type the numbers that it holds in the end into the claim file, as `cells`, or rename one of the two";
                return Err(Diagnostic::new(source, token.span.clone(), message).with_help(help));
            }
            None => {}
        }
    }
    match found.len() {
        1 => {
            let (at, range) = found.remove(0);
            is_compiled(source, language, &all, at)?;
            Ok(Initialiser {
                name: all[at].span.clone(),
                types: declared(source, language, &all, at, range.start),
                tokens: all[range].to_vec(),
                directives: all.into_iter().filter(|token| token.kind == Kind::Directive).collect(),
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
            let message = format!("`{after}` gets a value in {} places", found.len());
            let help = "an audit needs one place: cut the file, or rename one of them";
            let [first, second] = [0, 1].map(|place: usize| all[found[place].0].span.clone());
            Err(Diagnostic::new(source, first, message)
                .with_label("the first")
                .with_place(second, "the second")
                .with_help(help))
        }
    }
}

/// Refuses a table of which a conditional of the preprocessor says whether it is compiled, or with which type.
fn is_compiled(
    source: &Arc<SourceText>,
    language: Language,
    tokens: &[Token],
    at: usize,
) -> Result<(), Diagnostic> {
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
    let Some(span) = conditional(source, tokens, at).or(split.map(|token| token.span.clone()))
    else {
        return Ok(());
    };
    let message = "whether this is compiled depends on a conditional of the preprocessor";
    Err(Diagnostic::new(source, tokens[at].span.clone(), message)
        .with_place(span.start..span.start + 1, "this one")
        .with_help("copy what is compiled into a file without conditionals, or type the numbers into the claim file, as `cells`"))
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

/// A place where the name occurs.
struct Place<'a> {
    source: &'a SourceText,
    language: Language,
    tokens: &'a [Token],
    name: usize,
    /// Whether a bracket is open there.
    enclosed: bool,
}

/// Methods that change a list.
const CHANGING: [&str; 14] = [
    "sort",
    "reverse",
    "append",
    "extend",
    "insert",
    "pop",
    "remove",
    "clear",
    "fill",
    "push",
    "shift",
    "unshift",
    "splice",
    "push_back",
];

impl Place<'_> {
    fn text(&self, at: usize) -> &str {
        self.tokens.get(at).map_or("", |token| &self.source.text[token.span.clone()])
    }

    fn sign(&self, at: usize) -> Option<char> {
        match self.tokens.get(at)?.kind {
            Kind::Sign(sign) => Some(sign),
            _ => None,
        }
    }

    /// Whether a word follows the one before at once.
    fn joined(&self, at: usize) -> bool {
        self.tokens.get(at).is_some_and(|token| token.span.start == self.tokens[at - 1].span.end)
    }

    /// Whether a line ends before this word, but for `\` in Python.
    fn on_next_line(&self, at: usize) -> bool {
        let between = &self.source.text[self.tokens[at - 1].span.end..self.tokens[at].span.start];
        let continued = self.language == Language::Python && between.trim_start().starts_with('\\');
        between.contains('\n') && !continued
    }

    /// The words of the value: up to a comma, a semicolon or a bracket that was opened before; in JavaScript and Python, also
    /// up to the end of a line. In Python a comma makes a tuple.
    fn value(&self, begin: usize) -> Option<Range<usize>> {
        let mut depth = 0_usize;
        let mut end = begin;
        let tuple = self.language == Language::Python && !self.enclosed;
        while let Some(token) = self.tokens.get(end) {
            match token.kind {
                _ if depth == 0 && end > begin && self.ends(end) => break,
                Kind::Sign('(' | '[' | '{') => depth += 1,
                Kind::Sign(')' | ']' | '}' | ';') if depth == 0 => break,
                Kind::Sign(',') if depth == 0 && !tuple => break,
                Kind::Sign(')' | ']' | '}') => depth -= 1,
                _ => {}
            }
            end += 1;
        }
        (begin < end).then_some(begin..end)
    }

    /// Whether a value ends before this word, because a line ends there.
    fn ends(&self, at: usize) -> bool {
        self.on_next_line(at)
            && match self.language {
                Language::Python => !self.enclosed,
                Language::JavaScript => !self.goes_on(at),
                _ => false,
            }
    }

    /// Whether JavaScript takes this word to the value of the line before.
    fn goes_on(&self, at: usize) -> bool {
        let open = self.sign(at - 1).is_some_and(|sign| !matches!(sign, ')' | ']' | '}'));
        open || match self.sign(at) {
            Some(sign @ ('+' | '-')) => self.sign(at + 1) != Some(sign) || !self.joined(at + 1),
            Some('!') => self.text(at + 1) == "=",
            Some(sign) => !matches!(sign, '{' | '}' | ')' | ']' | '@' | '#' | '~'),
            None => matches!(self.text(at), "in" | "instanceof") || self.text(at).starts_with('`'),
        }
    }

    /// Whether a name may get a value where it stands: in Python at the beginning of a statement or as an argument.
    fn may_get_value(&self) -> bool {
        // `self.name`
        let mut first = self.name;
        while first > 1 && self.sign(first - 1) == Some('.') && self.sign(first - 2).is_none() {
            first -= 2;
        }
        let Some(before) = first.checked_sub(1) else { return true };
        let compares = before > 0 && matches!(self.text(before - 1), "=" | "!" | "<" | ">");
        match (self.language, self.text(before)) {
            (Language::Python, "," | "(") => self.enclosed,
            (Language::Python, ":" | ";") => true,
            (Language::Python, "=") => !compares,
            (Language::Python, _) => self.on_next_line(first),
            (_, before) => !matches!(before, "case" | "?"),
        }
    }

    /// Whether an operator is followed by `=` at once, or doubled and then.
    fn assigns(&self, at: usize) -> bool {
        let doubled = self.joined(at + 1) && self.sign(at + 1) == self.sign(at);
        let equal = at + 1 + usize::from(doubled);
        self.joined(equal) && self.sign(equal) == Some('=')
    }

    /// What happens to the name: it gets a value after `=`, or at a brace that follows it and its brackets at once.
    fn used(&self) -> Option<Use> {
        let native = matches!(self.language, Language::C | Language::Shader);
        let mut depth = 0_usize;
        let mut annotated = false;
        if !self.may_get_value() {
            return None;
        }
        if self.text(self.name + 1) == "."
            && CHANGING.contains(&self.text(self.name + 2))
            && self.text(self.name + 3) == "("
        {
            return Some(Use::Change);
        }
        for at in self.name + 1..self.tokens.len() {
            if self.language == Language::Python
                && !self.enclosed
                && depth == 0
                && self.on_next_line(at)
            {
                return None;
            }
            match self.tokens[at].kind {
                Kind::Sign('=') if depth == 0 => {
                    // Neither a comparison nor a function.
                    let other = self.joined(at + 1) && matches!(self.sign(at + 1), Some('=' | '>'));
                    return (!other).then_some(Use::Value(at + 1));
                }
                Kind::Sign('{') if depth == 0 => return Some(Use::Value(at)),
                Kind::Sign('+' | '-' | '*' | '/' | '%' | '&' | '|' | '^' | '@')
                    if depth == 0 && self.assigns(at) =>
                {
                    return Some(Use::Change);
                }
                Kind::Sign('[' | '(') => depth += 1,
                Kind::Sign('<') if annotated => depth += 1,
                Kind::Sign(']' | ')') => depth = depth.checked_sub(1)?,
                Kind::Sign('>') if annotated => depth = depth.checked_sub(1)?,
                _ if depth > 0 => {}
                // Between the name and `=` stands at most a type, as in `name: [f32; 7] =`, or an attribute.
                Kind::Sign(':') if !native => annotated = true,
                Kind::Sign('&' | '\'' | '*' | '.' | '|') if annotated => {}
                Kind::Name if annotated => {}
                Kind::Name if native => {
                    let word = self.text(at);
                    let macros = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_';
                    if !word.starts_with("__") && word != "alignas" && !word.chars().all(macros) {
                        return None;
                    }
                }
                _ => return None,
            }
        }
        None
    }
}
