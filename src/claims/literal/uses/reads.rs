//! Uses that only read the numbers of a table.

use super::{Chain, Uses, is_in};
use crate::literal::declared::element;
use crate::literal::language::Language;
use std::ops::Range;

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

impl Uses<'_> {
    /// Whether this only reads numbers of a table that may be changed, in which so many indices lead to a number.
    pub(super) fn reads(&self, chain: &Chain, depth: usize) -> bool {
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

    /// Whether the value of a number is taken where a language has references.
    fn is_number_here(&self, start: usize, end: usize) -> bool {
        let [before, second, third] = [1, 2, 3].map(|back| self.before(start, back));
        let sign = |word: &str| matches!(word, "+" | "-" | "*" | "/" | "%" | "<" | "|" | "^");
        let next = self.text(end);
        // `in >> w[0]` may read it from somewhere.
        if before == ">" && second == ">" && self.joined(start - 1) {
            return false;
        }
        let converts = |name: usize| {
            element(self.text(name), self.language).is_some() && !self.defines(self.text(name))
        };
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
