//! A mask in one text: `[1, 3, 3, 1]/4`.

use super::scheme::{MAX_ARITY, MAX_WIDTH};
use crate::formulas::{Scope, formula};
use crate::numbers::Value;
use crate::text::Stop;

/// The offset and the rules of the mask a_0, …, a_L, whose sum is its arity n: a_{α,j} = a_{α + h − n(o + j)} with h = ⌊L/2⌋
/// and o = −⌊(L − h)/n⌋.
pub(super) fn mask(text: &str, scope: &Scope<'_>) -> Result<(i64, Vec<Vec<Value>>), Stop> {
    let (before, list, behind) = parts(text).ok_or_else(|| wrong("there is no list in it"))?;
    let value = |piece: &str| scope.value(&formula(&with_factors(before, piece, behind))?);
    let all = pieces(list).into_iter().map(value).collect::<Result<Vec<Value>, Stop>>()?;
    if all.is_empty() || all.len() > usize::from(MAX_ARITY) * usize::from(MAX_WIDTH) {
        return Err(Stop::Capped("the number of the coefficients of a mask"));
    }
    let n = Value::total(&all)?.integer(MAX_ARITY.into())?;
    let arity = usize::try_from(n).ok().filter(|n| *n >= 2);
    let arity = arity.ok_or_else(|| wrong("its coefficients add up to no arity"))?;
    let half = (all.len() - 1) / 2;
    let below = (all.len() - 1 - half) / arity;
    let at = |alpha: usize, place: usize| {
        let index = (alpha + half + below * arity).checked_sub(place * arity);
        index.and_then(|index| all.get(index)).cloned().unwrap_or_else(|| Value::int(0))
    };
    let width = below + half.div_ceil(arity);
    let row = |alpha| (0..=width).map(|place| at(alpha, place)).collect();
    let offset = -i64::try_from(below).map_err(|_| Stop::Capped("an offset"))?;
    Ok((offset, (0..arity).map(row).collect()))
}

fn wrong(what: &str) -> Stop {
    Stop::Wrong(format!("a mask in one text: {what}"))
}

/// The formula of an entry, with what stands before its list and behind it.
pub(super) fn with_factors(before: &str, piece: &str, behind: &str) -> String {
    let before = before.trim_end().trim_end_matches(['*', '·', '×']).trim();
    let before = if before.is_empty() { String::new() } else { format!("({before})*") };
    format!("{before}({piece}){behind}")
}

/// What stands before the one list, in it and behind it. A list is in `[…]` or `{…}` outside of other brackets, or else in round
/// brackets with commas.
pub(super) fn parts(text: &str) -> Option<(&str, &str, &str)> {
    let (mut depth, mut start, mut groups) = (0_usize, 0, Vec::new());
    for (at, c) in text.char_indices() {
        match c {
            '(' | '[' | '{' => {
                start = if depth == 0 { at } else { start };
                depth += 1;
            }
            ')' | ']' | '}' => {
                depth = depth.checked_sub(1)?;
                groups.extend((depth == 0).then_some((start, at)));
            }
            _ => {}
        }
    }
    let angular = |(start, _): &&(usize, usize)| !text[*start..].starts_with('(');
    let named = |start: usize| text[..start].trim_end().ends_with(|c: char| c.is_alphanumeric());
    let listed = |(start, end): &&(usize, usize)| {
        !named(*start) && split(&text[start + 1..*end], ',').len() > 1
    };
    let of = |list: Vec<&(usize, usize)>| match list[..] {
        [(start, end)] => Some((&text[..*start], &text[start + 1..*end], text[end + 1..].trim())),
        _ => None,
    };
    let found: Vec<_> = groups.iter().filter(angular).collect();
    if found.is_empty() { of(groups.iter().filter(listed).collect()) } else { of(found) }
}

/// The coefficients between commas or semicolons, or between blanks; nothing need stand behind the last sign.
fn pieces(list: &str) -> Vec<&str> {
    let signs = [',', ';'].map(|sign| split(list, sign));
    let pieces = signs.into_iter().find(|pieces| pieces.len() > 1);
    let mut pieces = pieces.unwrap_or_else(|| {
        let words: Vec<&str> = list.split_whitespace().collect();
        let plain = |word: &&str| word.ends_with(|c: char| c.is_ascii_digit());
        if words.iter().all(plain) { words } else { vec![list] }
    });
    if pieces.last().is_some_and(|last| last.trim().is_empty()) {
        pieces.pop();
    }
    pieces
}

/// The parts between a sign outside of all brackets.
pub(super) fn split(text: &str, sign: char) -> Vec<&str> {
    let mut depth = 0_i64;
    let parts = text.split(|c| {
        depth += i64::from(['(', '[', '{'].contains(&c)) - i64::from([')', ']', '}'].contains(&c));
        c == sign && depth == 0
    });
    parts.collect()
}
