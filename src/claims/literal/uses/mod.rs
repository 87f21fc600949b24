//! Whether the numbers of a table may be changed where its name is used.
//!
//! A table that its language keeps as it is, such as one with `const`, is refused only where something with its
//! name is changed explicitly. Of any other table each use has to be a read that is known to change nothing; all
//! others are refused, also those that change nothing.

mod changes;
mod own;
mod reads;

use super::declared::statement;
use super::directive::words;
use super::language::Language;
use super::token::{Kind, Token, Tokens};
use crate::diagnostic::SourceText;
use std::ops::Range;
use std::sync::Arc;

/// Words before a bracket that is no call.
const KEYWORDS: &str =
    " if while for switch return in of and or not else elif assert yield case typeof await ";

/// The words of a file with its brackets.
pub(super) struct Uses<'a> {
    source: &'a Arc<SourceText>,
    language: Language,
    tokens: &'a [Token],
    /// The bracket that is open before each word.
    open: Vec<Option<usize>>,
    /// Where the bracket that opens at a word is closed.
    close: Vec<usize>,
    /// Whether the bracket that opens at a word has a comma of its own.
    commas: Vec<bool>,
}

/// What is known of a table from its declaration.
#[derive(Clone, Copy)]
pub(super) struct Declared {
    /// Whether the language keeps its numbers.
    constant: bool,
    /// How many indices lead to a number.
    depth: usize,
}

/// Whether a word is in a list.
fn is_in(list: &str, word: &str) -> bool {
    !word.is_empty() && list.contains(&format!(" {word} "))
}

impl<'a> Uses<'a> {
    pub(super) fn new(
        source: &'a Arc<SourceText>,
        language: Language,
        tokens: &'a [Token],
    ) -> Uses<'a> {
        let (mut open, mut close) = (Vec::new(), vec![tokens.len(); tokens.len()]);
        let mut commas = vec![false; tokens.len()];
        let mut stack = Vec::new();
        for (at, token) in tokens.iter().enumerate() {
            if matches!(token.kind, Kind::Sign(')' | ']' | '}'))
                && let Some(begin) = stack.pop()
            {
                close[begin] = at;
            }
            open.push(stack.last().copied());
            if let (Kind::Sign(','), Some(&outer)) = (token.kind, stack.last()) {
                commas[outer] = true;
            }
            if matches!(token.kind, Kind::Sign('(' | '[' | '{')) {
                stack.push(at);
            }
        }
        Uses { source, language, tokens, open, close, commas }
    }

    /// The declaration of the name at `at` with this value.
    pub(super) fn declared(&self, at: usize, value: &Range<usize>) -> Declared {
        let (words, before) = (value.clone(), statement(self.tokens, at)..at);
        // Within a bracket, behind a star or a comma, `const` is about something else.
        let has = |list: &[&str]| {
            let own = before.clone().filter(|&word| self.open[word] == self.open[at]);
            let mut own = own.take_while(|&word| !matches!(self.text(word), "*" | "&" | "," | "="));
            own.any(|word| list.contains(&self.text(word)))
        };
        // A bracket in which a list stands, and not a number.
        let is_list = |open: usize| match self.text(open) {
            "{" | "[" => true,
            _ if self.language == Language::Python => {
                self.commas[open] && !(open > 0 && self.is_name(open - 1))
            }
            _ => self.commas[open] || self.before(open, 1) == "of",
        };
        let (mut depth, mut lists) = (0, Vec::new());
        for word in words.clone() {
            if self.is_open(word) {
                lists.push(is_list(word));
                depth = depth.max(lists.iter().filter(|list| **list).count());
            } else if matches!(self.text(word), ")" | "]" | "}") {
                lists.pop();
            }
        }
        let outside = |word: usize| self.open[word] == self.open[words.start];
        let bare = words.clone().any(|word| self.text(word) == "," && outside(word));
        depth += usize::from(bare && self.language == Language::Python);
        // `w[2][3]`
        let mut next = at + 1;
        let mut sizes = 0;
        while self.language.is_native() && self.text(next) == "[" {
            sizes += 1;
            next = self.close[next] + 1;
        }
        let constant = match self.language {
            Language::C | Language::Shader => has(&["const", "constexpr"]),
            Language::Hlsl => has(&["const", "constexpr", "constant", "__constant"]),
            Language::Wgsl => before.clone().all(|word| self.text(word) != "var"),
            Language::Rust => (before.start..words.end).all(|word| self.text(word) != "mut"),
            Language::JavaScript => {
                has(&["const"]) && depth == 0
                    || self.text(words.start) == "Object"
                        && self.text(words.start + 2) == "freeze"
                        && depth == 1
            }
            // A tuple of numbers, or of tuples.
            Language::Python => {
                depth == 0 || !words.clone().any(|at| self.text(at) == "[" || self.is_name(at))
            }
            Language::Matlab => true,
        };
        Declared { constant, depth: if sizes > 0 { sizes } else { depth } }
    }

    /// What is wrong with the use of the name at `at`: whether it changes the table, or may do so.
    pub(super) fn fault(&self, at: usize, table: Declared) -> Option<&'static str> {
        let place = self.chain(at);
        if self.changes(&place) {
            return Some("is changed here");
        }
        (!table.constant && !self.reads(&place, table.depth)).then_some("may be changed here")
    }

    /// The first text or macro of which code with the name is a part.
    pub(super) fn hidden(&self, name: &str, table: Declared) -> Option<usize> {
        let has_name = |text: &str| {
            text.split(|c: char| !c.is_alphanumeric() && c != '_').any(|word| word == name)
        };
        (0..self.tokens.len()).filter(|_| !table.constant).find(|&at| {
            let text = self.text(at);
            let code = match (self.tokens[at].kind, self.language) {
                (Kind::Directive, _) => {
                    let line = &self.tokens[at];
                    // `##` makes other names.
                    return words(self.source, line).first() == Some(&"define")
                        && (["##", "%:%:"].iter().any(|signs| text.contains(signs))
                            || self.names(line.span.start + 1..line.span.end, name));
                }
                (Kind::Text, Language::JavaScript) => text.starts_with('`') && text.contains("${"),
                (Kind::Text, Language::Python) => {
                    let prefix = self.before(at, 1);
                    text.contains('{') && self.joined(at) && prefix.contains(['f', 'F', 't', 'T'])
                }
                _ => false,
            };
            code && has_name(text)
        })
    }

    /// Whether words of a macro are this name; also where these are not read.
    fn names(&self, bytes: Range<usize>, name: &str) -> bool {
        let mut words = Tokens::of_macro(self.source, self.language, bytes);
        std::iter::from_fn(|| words.next().transpose())
            .any(|word| !word.is_ok_and(|word| self.source.text[word.span] != *name))
    }

    fn text(&self, at: usize) -> &'a str {
        self.tokens.get(at).map_or("", |token| &self.source.text[token.span.clone()])
    }

    /// The word before, `back` words back.
    fn before(&self, at: usize, back: usize) -> &'a str {
        at.checked_sub(back).map_or("", |at| self.text(at))
    }

    fn is_name(&self, at: usize) -> bool {
        self.tokens.get(at).is_some_and(|token| token.kind == Kind::Name)
    }

    fn is_open(&self, at: usize) -> bool {
        matches!(self.text(at), "(" | "[" | "{")
    }

    /// Whether nothing stands between a word and the one before.
    fn joined(&self, at: usize) -> bool {
        at > 0
            && self
                .tokens
                .get(at)
                .is_some_and(|token| token.span.start == self.tokens[at - 1].span.end)
    }

    fn on_next_line(&self, at: usize) -> bool {
        let lines =
            matches!(self.language, Language::Python | Language::JavaScript | Language::Matlab);
        lines
            && at > 0
            && self.tokens.get(at).is_some_and(|token| {
                let between = &self.source.text[self.tokens[at - 1].span.end..token.span.start];
                // Python and MATLAB join lines.
                let joins = between.trim_start().starts_with('\\') || between.contains("...");
                between.contains('\n') && (self.language == Language::JavaScript || !joins)
            })
    }

    /// Whether the word before a place ends a value.
    fn is_value(&self, at: usize) -> bool {
        let Some(last) = at.checked_sub(1) else { return false };
        match self.tokens[last].kind {
            Kind::Number | Kind::Text | Kind::Sign(')' | ']' | '}') => true,
            Kind::Name => !is_in(KEYWORDS, self.text(last)),
            _ => false,
        }
    }
}

/// A use of the name with what it selects: `self.w[2].x`, also in brackets of its own.
struct Chain {
    words: Range<usize>,
    /// How many numbers and names select something.
    selected: usize,
    /// The member that is read or called last.
    member: Option<usize>,
}

impl Uses<'_> {
    fn chain(&self, name: usize) -> Chain {
        let mut start = name;
        loop {
            let joins = match (self.before(start, 1), self.before(start, 2)) {
                (".", _) => 1,
                (":", ":") | (">", "-") => 2,
                _ => break,
            };
            let owner = start.checked_sub(joins + 1).filter(|&at| self.is_name(at));
            let Some(owner) = owner else { break };
            start = owner;
        }
        let mut chain = Chain { words: start..name + 1, selected: 0, member: None };
        loop {
            let next = chain.words.end;
            let selects = |sign: &str| self.text(next) == sign && !self.on_next_line(next);
            let member = if self.text(next) == "." {
                Some(next + 1)
            } else if self.text(next) == "-" && self.text(next + 1) == ">" && self.joined(next + 1)
            {
                Some(next + 2)
            } else {
                None
            };
            if selects("[") || self.language == Language::Matlab && (selects("(") || selects("{")) {
                let close = self.close[next];
                if self.language == Language::Python {
                    let comma = |at: &usize| self.open[*at] == Some(next) && self.text(*at) == ",";
                    let mut ends: Vec<usize> = (next + 1..close).filter(comma).collect();
                    ends.push(close);
                    let begins = std::iter::once(next).chain(ends.iter().copied());
                    let mut parts = begins.zip(&ends).map(|(begin, &end)| begin + 1..end);
                    // `w[:2]` and `w[x]` may be lists, perhaps the same numbers.
                    let selects = parts.all(|part| self.is_integer(next, part));
                    chain.selected += if selects { ends.len() } else { 0 };
                } else {
                    chain.selected += 1;
                }
                chain.words.end = close + 1;
            } else if let Some(member) = member.filter(|&member| self.is_name(member)) {
                chain.member = Some(member);
                chain.words.end = member + 1;
                // Of a shader `w.xy`.
                chain.selected +=
                    usize::from(self.language.is_native() && self.text(member + 1) != "(");
            } else if self.before(chain.words.start, 1) == "("
                && self.text(next) == ")"
                && !self.calls(chain.words.start - 1)
            {
                chain.words = chain.words.start - 1..next + 1;
            } else {
                chain.words.end = chain.words.end.min(self.tokens.len());
                return chain;
            }
        }
    }

    /// Whether an index of Python, in the bracket `open`, is an integer: a literal, a loop variable, or computed with `+ - * / %`.
    fn is_integer(&self, open: usize, part: Range<usize>) -> bool {
        let own = |at: &usize| self.open[*at] == Some(open);
        let has =
            |signs: &[&str]| part.clone().filter(own).any(|at| signs.contains(&self.text(at)));
        if has(&[":", ".", "None"]) {
            return false;
        }
        let word = self.text(part.start);
        let runs = |at: usize| {
            let list = self.before(at, 1) == "," && self.before(at, 3) == "for";
            self.text(at) == word && (list || self.before(at, 1) == "for")
        };
        has(&["+", "-", "*", "/", "%"])
            || part.len() == 1 && self.tokens[part.start].kind == Kind::Number
            || part.len() == 1 && (0..self.tokens.len()).any(runs)
            || matches!(word, "int" | "len") && self.text(part.start + 1) == "("
    }

    /// Whether a bracket belongs to a call, or to a condition.
    fn calls(&self, open: usize) -> bool {
        let before = self.before(open, 1);
        self.is_value(open)
            || before == ">"
            || is_in(KEYWORDS, before)
                && !matches!(before, "return" | "in" | "of" | "and" | "or" | "not" | "else")
    }

    /// Whether an assignment stands here: `=`, `+=`, `>>=`, `:=`, and none of `==`, `<=` and `=>`.
    fn assigns(&self, at: usize) -> bool {
        let joined = |at: usize, sign: &str| self.joined(at) && self.text(at) == sign;
        let sign = self.text(at);
        match sign {
            "=" => !joined(at + 1, "=") && !joined(at + 1, ">"),
            "+" | "-" | "*" | "/" | "%" | "&" | "|" | "^" | "@" | ":" | "<" | ">" | "?" => {
                let doubled = joined(at + 1, sign);
                let tripled = doubled && joined(at + 2, sign);
                let single = !doubled && !matches!(sign, "<" | ">" | "?");
                let equal = at + 1 + usize::from(doubled) + usize::from(tripled);
                (single || doubled) && joined(equal, "=") && !joined(equal + 1, "=")
            }
            _ => false,
        }
    }

    /// Whether `++` or `--` ends before a place or begins at it.
    fn steps(&self, at: usize) -> bool {
        matches!(self.text(at), "+" | "-")
            && self.text(at + 1) == self.text(at)
            && self.joined(at + 1)
    }
}
