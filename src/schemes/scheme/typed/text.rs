//! The text of a mask: one list of coefficients, with factors before and behind it.

use crate::diagnostic::{Diagnostic, SourceText};
use crate::formula::{
    LATTICE_VARIABLES, LocatedFormula, Node, Operator, continues_name, starts_name,
};
use std::ops::Range;
use std::sync::Arc;

/// How a mask is written.
pub(super) const MASK: &str = "write the coefficients a_0, …, a_L of a mask as [1, 3, 3, 1]/4, or as 1/4*[1, 3, 3, 1], or its symbol as (1 + z)^3/4";

/// What helps where a symbol stands in place of the list of its coefficients.
const SYMBOL: &str =
    "a symbol has a key of its own: symbol = '(1 + z)^3/4' in place of mask = '[1, 3, 3, 1]/4'";

/// What helps where blanks separate coefficients.
const COMMAS: &str = "blanks separate plain numbers only: write commas between coefficients, in one list for all rules";

/// Signs of a product.
const TIMES: [char; 3] = ['*', '·', '×'];
const OVER: [char; 3] = ['/', '\u{2044}', '\u{2215}'];

/// A bracket that no other one holds, with its own bytes.
pub(super) struct Group {
    open: char,
    pub(super) span: Range<usize>,
    /// Whether a name stands before it, as in `cos(x)` and `w[1]`.
    named: bool,
}

/// Whether this is a mask, and no name.
pub(in crate::scheme) fn is_typed(name: &str) -> bool {
    let listed = |group: &Group| !group.named && !split(&name[inner(group)], ',').is_empty();
    name.contains(['[', '{'])
        || name.starts_with('(')
        || groups(name).is_ok_and(|groups| groups.iter().any(listed))
        || is_symbol(name)
}

/// Whether this is the symbol of a mask: no list, and a sum or product in a variable, maybe with a mistake. With hyphens alone, as in `a-z`, it is a name.
pub(super) fn is_symbol(text: &str) -> bool {
    let is_list = text.trim_start().starts_with(['[', '{']) || list(text).is_ok();
    let composed = text.trim_start().starts_with("symbol(");
    !is_list && (composed || has_variable(text)) && text.contains(['^', '(', '*', '·', '×', '+'])
}

/// Whether `x`, `y` or `z` is a word in a text; a number may stand before it, as it does by mistake in `2z`.
fn has_variable(text: &str) -> bool {
    let words = text.split(|c| !continues_name(c));
    words
        .map(|word| word.trim_start_matches(|c: char| c.is_ascii_digit()))
        .any(|word| LATTICE_VARIABLES.contains(&word))
}

/// The places of the coefficients of the mask that stands in this range, and the formula of each with the factors.
pub(super) fn coefficients(
    source: &Arc<SourceText>,
    range: Range<usize>,
) -> Result<Vec<LocatedFormula>, Diagnostic> {
    let text = &source.text[range.clone()];
    let place = |span: Range<usize>| range.start + span.start..range.start + span.end;
    let wrong = |span: Range<usize>, message: &str| {
        Diagnostic::new(source, place(span), message).with_help(MASK)
    };
    let list = list(text).map_err(|(span, message)| {
        let error = wrong(span, message);
        if has_variable(text) { error.with_help(SYMBOL) } else { error }
    })?;
    let behind = &text[list.span.end..];
    let before = factor_before(source, place(0..list.span.start))?;
    factor_behind(source, place(list.span.end..text.len()))?;
    let inside = inner(&list);
    let mut coefficients = Vec::new();
    for span in pieces(text, inside.clone()).map_err(|message| wrong(inside, message))? {
        let piece = text[span.clone()].trim();
        if piece.is_empty() {
            return Err(wrong(span, "a coefficient is missing"));
        }
        if piece.starts_with(['[', '{']) {
            return Err(wrong(
                0..text.len(),
                "this is not a list of coefficients: it is a list of lists",
            ));
        }
        // A mistake in the coefficient itself is said of the coefficient alone.
        LocatedFormula::read(source, place(span.clone()), piece).map_err(|error| {
            if piece.contains(char::is_whitespace) { error.with_help(COMMAS) } else { error }
        })?;
        let whole = format!("{before}({piece}){}", behind.trim());
        coefficients.push(LocatedFormula::read(source, place(span), &whole)?);
    }
    Ok(coefficients)
}

pub(super) fn inner(group: &Group) -> Range<usize> {
    group.span.start + 1..group.span.end - 1
}

/// The list: the bracket `[…]` or `{…}` behind no name, or else the round one with commas.
pub(super) fn list(text: &str) -> Result<Group, (Range<usize>, &'static str)> {
    let whole = 0..text.len();
    let groups = groups(text)?;
    let angular = groups.iter().any(|group| group.open != '(');
    if let Some(called) = groups.iter().find(|group| group.open != '(' && group.named) {
        let message = "a list behind a name: write `*` between a factor and the list";
        // `root([-3, 0, 1], 2)` has its list in a bracket of its own.
        return Err((called.span.clone(), message));
    }
    let is_list = |group: &Group| match group.open {
        '(' => !angular && !group.named && !split(&text[inner(group)], ',').is_empty(),
        _ => true,
    };
    let mut lists = groups.into_iter().filter(is_list);
    match (lists.next(), lists.next()) {
        (Some(list), None) => Ok(list),
        (None, _) => Err((whole, "this is not a list of coefficients with a factor behind it")),
        (_, Some(second)) => Err((second.span, "a second list: a mask is one list")),
    }
}

/// The brackets that no other one holds.
fn groups(text: &str) -> Result<Vec<Group>, (Range<usize>, &'static str)> {
    let mut groups = Vec::new();
    let mut open: Vec<(char, usize)> = Vec::new();
    for (at, c) in text.char_indices() {
        match c {
            '(' | '[' | '{' => open.push((c, at)),
            ')' | ']' | '}' => {
                let fits = |open: char| matches!((open, c), ('(', ')') | ('[', ']') | ('{', '}'));
                let Some((opened, start)) = open.pop().filter(|(opened, _)| fits(*opened)) else {
                    return Err((at..at + 1, "this bracket does not close the one before"));
                };
                if open.is_empty() {
                    let named = is_named(&text[..start]);
                    groups.push(Group { open: opened, span: start..at + 1, named });
                }
            }
            _ => {}
        }
    }
    match open.first() {
        None => Ok(groups),
        Some(_) if groups.is_empty() => Err((0..text.len(), "the list has no end")),
        Some((_, start)) => Err((*start..text.len(), "this bracket has no end")),
    }
}

/// Whether a text ends with a name, and not with a number.
fn is_named(before: &str) -> bool {
    let before = before.trim_end();
    let word = before.trim_end_matches(continues_name);
    before[word.len()..].chars().next().is_some_and(starts_name)
}

/// The places of a sign outside all brackets.
fn split(text: &str, sign: char) -> Vec<usize> {
    let mut depth = 0_usize;
    let found = text.char_indices().filter(move |(_, c)| {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth == 0 && *c == sign
    });
    found.map(|(at, _)| at).collect()
}

/// The places of the coefficients, between commas, semicolons or blanks.
pub(super) fn pieces(text: &str, inside: Range<usize>) -> Result<Vec<Range<usize>>, &'static str> {
    let list = &text[inside.clone()];
    let [commas, semicolons] = [',', ';'].map(|sign| split(list, sign));
    let signs = match (commas.is_empty(), semicolons.is_empty()) {
        (false, false) => {
            return Err(
                "commas beside semicolons: rows of a matrix, or decimal commas? A mask is one \
                        list of numbers such as 0.25",
            );
        }
        (true, true) if list.split_whitespace().count() > 1 => {
            // `1 -2` may be two numbers or a difference; behind a number and a blank, a sign belongs to the next number.
            let words: Vec<&str> = list.split_whitespace().collect();
            let number = |word: &&str| crate::exact::parse_rational(word).is_ok();
            if words.iter().all(number) {
                let place = |word: &str| word.as_ptr().addr() - text.as_ptr().addr();
                return Ok(words.iter().map(|w| place(w)..place(w) + w.len()).collect());
            }
            commas
        }
        (true, false) => semicolons,
        _ => commas,
    };
    let mut places = Vec::new();
    let mut start = inside.start;
    for sign in signs {
        places.push(start..inside.start + sign);
        start = inside.start + sign + 1;
    }
    // Nothing need stand behind the last sign.
    if !text[start..inside.end].trim().is_empty() {
        places.push(start..inside.end);
    }
    Ok(places)
}

/// The factor before the list, in brackets and with `*`.
pub(super) fn factor_before(
    source: &Arc<SourceText>,
    span: Range<usize>,
) -> Result<String, Diagnostic> {
    let before = &source.text[span.clone()];
    let wrong = |message: &str| Diagnostic::new(source, span.clone(), message).with_help(MASK);
    if before.trim().is_empty() {
        return Ok(String::new());
    }
    let factor = before.trim_end();
    if factor.ends_with(OVER) {
        return Err(wrong("a number over a list of coefficients has no meaning"));
    }
    let factor = factor.strip_suffix(TIMES).unwrap_or(factor).trim();
    let formula = LocatedFormula::read(source, span.clone(), factor)?;
    if is_sum(&formula) {
        return Err(wrong("a sum before the list: write it in brackets, and `*` behind it"));
    }
    Ok(format!("({factor})*"))
}

/// Checks that a product stands behind the list.
pub(super) fn factor_behind(
    source: &Arc<SourceText>,
    span: Range<usize>,
) -> Result<(), Diagnostic> {
    let behind = source.text[span.clone()].trim();
    let wrong = |message: &str| Diagnostic::new(source, span.clone(), message).with_help(MASK);
    if behind.is_empty() {
        return Ok(());
    }
    if !behind.starts_with(TIMES) && !behind.starts_with(OVER) {
        return Err(wrong("this is not a list of coefficients with a factor behind it"));
    }
    let formula = LocatedFormula::read(source, span.clone(), &format!("1{behind}"))?;
    if is_sum(&formula) {
        return Err(wrong("a sum behind the list: it would not be a factor of all coefficients"));
    }
    Ok(())
}

/// Whether a formula is a sum or a difference without brackets around it.
pub(super) fn is_sum(formula: &LocatedFormula) -> bool {
    match &formula.expr.node {
        Node::Chain(first, rest) => {
            let added =
                |(sign, _): &(Operator, _)| matches!(sign, Operator::Add | Operator::Subtract);
            rest.iter().any(added) && formula.expr.span.start == first.span.start
        }
        _ => false,
    }
}
