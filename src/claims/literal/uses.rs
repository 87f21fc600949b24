//! Whether the numbers of a table may be changed where its name is used.
//!
//! A table that its language keeps as it is, such as one with `const`, is refused only where something with its
//! name is changed explicitly. Of any other table each use has to be a read that is known to change nothing; all
//! others are refused, also those that change nothing.

use super::declared::{element, statement};
use super::directive::words;
use super::language::Language;
use super::token::{Kind, Token, Tokens};
use crate::diagnostic::SourceText;
use std::ops::Range;
use std::sync::Arc;

/// Methods that change a list.
const CHANGING: &str = " sort reverse append extend insert pop remove clear fill push shift unshift splice push_back \
    copyWithin set assign resize erase swap put itemset setfield setflags resize byteswap partition \
    __setitem__ __delitem__ __iadd__ __imul__ ";

/// Members and methods that only say how many numbers there are.
const COUNTING: &str = " length size ndim shape dtype empty len ";

/// Methods that only read a list of numbers.
const READING_MEMBERS: &str =
    " copy tolist sum mean dot index count join slice concat includes indexOf iter to_vec ";

/// Functions that only read their first argument, where that is a list of numbers.
const READING: &str =
    " len sum min max sorted enumerate zip tuple print str repr dot convolve log ";

/// Functions that only read their arguments, where these are numbers; macros of Rust that do so.
const OF_NUMBERS: &str = " abs fabs fabsf sqrt sqrtf pow exp log sin cos floor ceil min max fmin fmax printf fprintf \
    println print format assert assert_eq vec ";

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
                    return words(self.source, line).first() == Some(&"define")
                        && self.names(line.span.start + 1..line.span.end, name);
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
                let inner = |at: &usize| self.open[*at] == Some(next);
                let commas = (next..close).filter(inner).filter(|&at| self.text(at) == ",").count();
                // `w[:2]` and `w[...]` are lists, perhaps the same numbers.
                let list = |at: usize| {
                    matches!(self.text(at), ":" | "None" | "newaxis")
                        || self.text(at) == "." && self.text(at + 1) == "."
                };
                if self.language != Language::Python {
                    chain.selected += 1;
                } else if !(next..close).filter(inner).any(list) {
                    chain.selected += 1 + commas;
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

    /// Whether this is a change, whatever the table is.
    fn changes(&self, chain: &Chain) -> bool {
        let Range { start, end } = chain.words;
        let before = self.before(start, 1);
        let called =
            |member: usize| self.text(member + 1) == "(" && is_in(CHANGING, self.text(member));
        let stepped = self.language != Language::Python
            && (self.steps(end) && !self.on_next_line(end) || start > 1 && self.steps(start - 2));
        if self.assigns(end)
            || stepped
            || chain.member.is_some_and(called)
            || matches!(
                before,
                "del"
                    | "delete"
                    | "def"
                    | "class"
                    | "as"
                    | "import"
                    | "global"
                    | "clear"
                    | "clearvars"
                    | "parfor"
            ) && matches!(
                self.language,
                Language::Python | Language::JavaScript | Language::Matlab
            ) && !(before == "global" && self.language == Language::Python)
            || before == "for" && self.language == Language::Matlab
        {
            return true;
        }
        match self.language {
            Language::Python => self.is_target_of_python(start, end),
            Language::JavaScript | Language::Matlab => self.is_pattern(start, end),
            _ => false,
        }
    }

    /// Whether a statement of Python gives a value to what stands here: `w, x = …`, `for w in …`, `del x, w`.
    fn is_target_of_python(&self, start: usize, end: usize) -> bool {
        let mut outer = start;
        let mut inner = end;
        // In a list of targets of `for`.
        let mut at = start;
        while let Some(last) = at.checked_sub(1) {
            match self.text(last) {
                "for" => return true,
                "," | "(" | "[" | "*" | ")" | "]" | "." => {}
                word if self.is_name(last) && !is_in(KEYWORDS, word) => {}
                _ => break,
            }
            if self.open[at].is_none() && self.on_next_line(at) {
                break;
            }
            at = last;
        }
        while let Some(open) = self.open[outer] {
            // An index or an argument is read.
            if self.is_value(open) && !self.on_next_line(open) {
                return false;
            }
            (outer, inner) = (open, self.close[open] + 1);
        }
        let mut first = outer;
        while first > 0 && !self.on_next_line(first) && self.text(first - 1) != ";" {
            first -= 1;
            // A bracket that spans lines.
            if let Some(open) = self.open[first] {
                first = open;
            }
        }
        if matches!(self.text(first), "del" | "import" | "from" | "case") {
            return true;
        }
        while inner < self.tokens.len() && !self.on_next_line(inner) {
            match self.text(inner) {
                ":" | ";" => return false,
                "=" if self.assigns(inner)
                    && !matches!(self.text(inner - 1), "=" | "!" | "<" | ">") =>
                {
                    return true;
                }
                _ if self.is_open(inner) => inner = self.close[inner],
                _ => {}
            }
            inner += 1;
        }
        false
    }

    /// Whether what stands here belongs to a list that gets values: `[w, x] = …`, `for (w of …)`.
    fn is_pattern(&self, start: usize, end: usize) -> bool {
        let each = |at: usize| {
            self.language == Language::JavaScript && matches!(self.text(at), "of" | "in")
        };
        if each(end) {
            return true;
        }
        let mut open = self.open[start];
        while let Some(at) = open {
            let next = self.close[at] + 1;
            let indexes = self.is_value(at) && !self.on_next_line(at);
            let literal = self.text(at) == "[" && !indexes || self.text(at) == "{";
            if literal && (self.assigns(next) || each(next)) {
                return true;
            }
            open = self.open[at];
        }
        false
    }

    /// Whether this only reads numbers of a table that may be changed, in which so many indices lead to a number.
    fn reads(&self, chain: &Chain, depth: usize) -> bool {
        let Range { start, end } = chain.words;
        let left = depth.saturating_sub(chain.selected);
        let (before, second) = (self.before(start, 1), self.before(start, 2));
        if let Some(member) =
            chain.member.filter(|_| !self.language.is_native() || self.text(end) == "(")
        {
            let member = self.text(member);
            return is_in(COUNTING, member) || is_in(READING_MEMBERS, member) && left <= 1;
        }
        // `&w`, but not `a && w`
        let pairs = second == "&" && self.joined(start - 1) && self.before(start, 3) != "&";
        if before == "&" && !pairs && self.language != Language::Rust
            || matches!(before, "mut" | "ref")
            || before == "=" && self.before(start, 4) == "ref"
        {
            return false;
        }
        let shared = before == "export" || second == "export" || self.exported(start);
        match self.language {
            Language::Matlab | Language::Wgsl => true,
            Language::JavaScript if shared => true,
            // Of a macro it is not known what it does.
            Language::Rust => self.open[start].is_none_or(|open| {
                self.before(open, 1) != "!" || is_in(OF_NUMBERS, self.before(open, 2))
            }),
            Language::Python | Language::JavaScript => {
                let spread = left <= 1
                    && (before == "*" && !self.is_value(start - 1)
                        || before == "." && second == ".");
                let each = left <= 1 && matches!(before, "in" | "of");
                left == 0
                    || spread
                    || each
                    || left <= 1 && self.operates(start, end)
                    || left <= 1 && self.is_argument(start, end, READING)
                    || self.is_argument(start, end, " len ")
            }
            Language::C | Language::Shader | Language::Hlsl => {
                self.is_argument(start, end, " sizeof size ")
                    || before == "sizeof"
                    || left == 0 && self.is_number_here(start, end)
            }
        }
    }

    /// Whether other files get this: `module.exports = { w }`. What they do is not seen.
    fn exported(&self, start: usize) -> bool {
        self.open[start].is_some_and(|open| {
            let words = [1, 2].map(|back| self.before(open, back));
            words[0] == "export" || words == ["=", "exports"]
        })
    }

    /// Whether an operator of arithmetic or a comparison stands beside.
    fn operates(&self, start: usize, end: usize) -> bool {
        let sign = |word: &str| matches!(word, "+" | "-" | "*" | "/" | "%" | "@" | "<" | ">");
        let compares = |at: usize| matches!(self.text(at), "=" | "!") && self.text(at + 1) == "=";
        let next = !self.on_next_line(end) && (sign(self.text(end)) || compares(end));
        let Some(last) = start.checked_sub(1) else { return next };
        next || sign(self.text(last)) && self.is_value(last) || last > 0 && compares(last - 1)
    }

    /// Whether this is an argument of one of these functions, of which each but those of numbers may write to a later one.
    fn is_argument(&self, start: usize, end: usize, functions: &str) -> bool {
        let Some(open) = self.open[start] else { return false };
        let whole =
            matches!(self.before(start, 1), "(" | ",") && matches!(self.text(end), ")" | ",");
        let Some(name) = open.checked_sub(1).filter(|_| whole && self.text(open) == "(") else {
            return false;
        };
        let word = self.text(name);
        let earlier =
            (open..start).filter(|&at| self.open[at] == Some(open) && self.text(at) == ",");
        let reads = match earlier.count() {
            1 => functions == OF_NUMBERS || matches!(word, "dot" | "convolve" | "zip"),
            place => place == 0 || functions == OF_NUMBERS,
        };
        reads && is_in(functions, word) && !self.defines(word)
    }

    /// Whether the file may have a function of its own with this name.
    fn defines(&self, name: &str) -> bool {
        (0..self.tokens.len()).filter(|&at| self.text(at) == name).any(|at| {
            let before =
                at.checked_sub(1).filter(|&before| self.is_name(before) && !self.on_next_line(at));
            let declared = before.is_some_and(|before| !is_in(KEYWORDS, self.text(before)));
            declared
                || self.text(at + 1) == "="
                || matches!(self.before(at, 1), "*" | "&") && !self.is_value(at - 1)
        })
    }

    /// Whether the value of a number is taken where a language has references.
    fn is_number_here(&self, start: usize, end: usize) -> bool {
        let [before, second, third] = [1, 2, 3].map(|back| self.before(start, back));
        let sign = |word: &str| matches!(word, "+" | "-" | "*" | "/" | "%" | "<" | "|" | "^");
        let next = self.text(end);
        // `in >> w[0]` may read it from somewhere.
        if before == ">" && second == ">" && self.joined(start - 1) {
            return false;
        }
        let converts = |name: usize| element(self.text(name), self.language).is_some();
        if sign(next)
            || matches!(next, ">" | "?" | "&")
            || self.is_argument(start, end, OF_NUMBERS)
            || matches!(next, "=" | "!") && self.text(end + 1) == "="
        {
            return true;
        }
        let ends = matches!(next, ";" | "," | ")" | "}");
        match before {
            _ if sign(before) => true,
            "!" | "~" | ">" | "&" => true,
            // `float(w[0])`, `vec2(w[0], w[1])`
            "(" | ","
                if ends && self.open[start].is_some_and(|open| open > 0 && converts(open - 1)) =>
            {
                true
            }
            "=" if sign(second) || matches!(second, "=" | "!" | "<" | ">" | "&") => true,
            // `double x = w[0]`, but not `double &x = w[0]`
            "=" => ends && !matches!(third, "&" | "ref"),
            // `(float)w[0]`
            ")" => self.is_name(start - 2),
            "[" => next == "]",
            // `{w[0], w[1]}`, but not `double &x{w[0]}`
            "{" | "," => {
                let list = |open: usize| {
                    self.text(open) == "{"
                        && matches!(self.before(open, 1), "=" | "," | "{" | "(" | "]")
                };
                ends && self.open[start].is_some_and(list)
            }
            _ => false,
        }
    }
}
