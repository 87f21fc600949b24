//! Changes of a table: assignments, steps, methods and patterns.

use super::{Chain, KEYWORDS, Uses, is_in};
use crate::literal::language::Language;
use std::ops::Range;

/// Methods that change a list.
const CHANGING: &str = " sort reverse append extend insert pop remove clear fill push shift unshift splice push_back \
    copyWithin set assign resize erase swap put itemset setfield setflags resize byteswap partition \
    __setitem__ __delitem__ __iadd__ __imul__ ";

impl Uses<'_> {
    /// Whether this is a change, whatever the table is.
    pub(super) fn changes(&self, chain: &Chain) -> bool {
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
            let called = !matches!(self.before(open, 1), "import" | "as" | "del");
            if called && self.is_value(open) && !self.on_next_line(open) {
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
        if matches!(self.text(first), "del" | "from" | "case")
            || self.before(outer, 1) == "as"
            || (first..outer).any(|at| matches!(self.text(at), "import" | "del"))
        {
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
}
