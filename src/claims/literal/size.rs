//! How many numbers a declaration has.

use super::compiled::not_conditional;
use super::declared::{element, statement};
use super::directive::{TYPED, macros};
use super::language::Language;
use super::reader::Reader;
use super::token::{Kind, Token};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::Rational;
use std::ops::Range;
use std::sync::Arc;

/// The most macros in a size.
const MAX_MACROS: usize = 32;

/// How many numbers the declaration of the name at `at` has, where it says so: those that are not written are 0. Its
/// list has so many items, which may be lists.
///
/// # Errors
/// When a size is no formula of integers and macros.
pub(super) fn size(
    source: &Arc<SourceText>,
    language: Language,
    tokens: &[Token],
    at: usize,
    (rows, lists): (usize, bool),
) -> Result<Option<usize>, Diagnostic> {
    if !language.is_native() {
        return Ok(None);
    }
    let text = |at: usize| tokens.get(at).map_or("", |token| &source.text[token.span.clone()]);
    let value = |words: Range<usize>| evaluated(source, language, tokens, words);
    let before = statement(tokens, at)..at;
    let vector = before.clone().find_map(|at| element(text(at), language));
    let vector = vector.map_or(1, |(_, size)| size);
    let mut sizes = Vec::new();
    for array in before.filter(|&word| text(word) == "array" && text(word + 1) == "<") {
        let Some(end) = closing(tokens, array + 1) else { continue };
        let comma = (array..end).rev().find(|&word| text(word) == ",");
        sizes.extend(comma.map(|comma| value(comma + 1..end)).transpose()?);
    }
    let (mut next, mut open) = (at + 1, false);
    while text(next) == "[" {
        let Some(end) = closing(tokens, next) else { break };
        open |= end == next + 1;
        if end > next + 1 {
            sizes.push(value(next + 1..end)?);
        }
        next = end + 1;
    }
    let product = sizes.iter().try_fold(1_usize, |product, &size| product.checked_mul(size));
    let known = vector > 1 || open || !sizes.is_empty();
    let all = product.and_then(|inner| {
        // Numbers without brackets of their own fill one row after the other.
        let lines = if lists || !open { rows } else { rows.div_ceil(inner.max(1)) };
        inner.checked_mul(if open { lines } else { 1 })?.checked_mul(vector)
    });
    Ok(all.filter(|_| known))
}

/// Where the bracket is closed that opens at a word.
fn closing(tokens: &[Token], open: usize) -> Option<usize> {
    let mut depth = 0_usize;
    (open..tokens.len()).find(|&at| {
        match tokens[at].kind {
            Kind::Sign('(' | '[' | '{' | '<') => depth += 1,
            Kind::Sign(')' | ']' | '}' | '>') => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth == 0
    })
}

/// The value of a size, in which macros are replaced as the preprocessor does.
fn evaluated(
    source: &Arc<SourceText>,
    language: Language,
    tokens: &[Token],
    words: Range<usize>,
) -> Result<usize, Diagnostic> {
    let place = tokens.get(words.start).map_or(0..0, |token| token.span.clone());
    let mut words = tokens[words].to_vec();
    for _ in 0..MAX_MACROS {
        let Some(at) = words.iter().position(|word| word.kind == Kind::Name) else { break };
        let name = &source.text[words[at].span.clone()];
        let defined = macros(source, language, tokens.iter().enumerate(), name)?;
        let [one] = &defined[..] else { break };
        not_conditional(source, tokens, one.at, None)?;
        words.splice(at..=at, one.tokens.iter().cloned());
    }
    let mut reader = Reader::new(source, language, &words);
    let value = reader.sum(0).ok().filter(|_| reader.at == words.len());
    let value = value.and_then(|value| value.exact()).filter(Rational::is_integer);
    let size = value.and_then(|value| usize::try_from(value.numerator().to_i128()?).ok());
    size.ok_or_else(|| {
        let message = "a size that is no formula of integers, so that it is not known how many numbers follow as 0";
        Diagnostic::new(source, place, message).with_help(TYPED)
    })
}
