//! The entries of `for`: indices and their values.

#![warn(clippy::arithmetic_side_effects)]

use super::states::{SIGNS, Sign, in_name, place_of, split};
use crate::formulas::{MAX_INTEGER, formula, is_name};
use crate::kinds::equation::cases::{Case, Index, Values};
use crate::numbers::{Decimal, Q, capped, read_rational};
use crate::text::{Stop, Toml};

/// The texts of `for`.
pub fn ranges(claim: &Toml) -> impl Iterator<Item = &str> {
    claim.one_or_more("for")
}

/// What follows a word such as `all`, if it is not the name of an index.
fn behind<'t>(text: &'t str, word: &str) -> Option<&'t str> {
    let rest = text.trim().strip_prefix(word).filter(|rest| rest.starts_with(char::is_whitespace));
    let sign = |rest: &str| SIGNS.iter().any(|(token, _)| rest.starts_with(token));
    rest.map(str::trim).filter(|rest| !sign(rest))
}

/// What follows `all`.
fn of_all(text: &str) -> Option<&str> {
    behind(text, "all")
}

/// An index with real values.
pub struct Real<'a> {
    /// Its name.
    pub name: &'a str,
    /// The signs that stand behind its name, each with an end.
    pub ends: Vec<(Sign, &'a str)>,
}

/// Reads an index with real values: `real v`, `v > 0`, `0 <= v < 1/4` or `v != 1/16`; `None` for an index with others.
pub fn real(text: &str) -> Option<Result<Real<'_>, Stop>> {
    let wrong = || Stop::Wrong(format!("`{text}` is no index with real values"));
    if let Some(name) = behind(text, "real") {
        return Some(is_name(name).then(|| Real { name, ends: Vec::new() }).ok_or_else(wrong));
    }
    if of_all(text).is_some() {
        return None;
    }
    let (mut parts, mut signs, mut rest) = (Vec::new(), Vec::new(), text);
    while let Some((at, which)) = place_of(rest, &SIGNS.map(|(token, _)| token)) {
        let ((token, sign), (part, behind)) = (SIGNS[which], rest.split_at(at));
        parts.push(part.trim());
        signs.push(sign);
        rest = behind.strip_prefix(token).unwrap_or_default();
    }
    parts.push(rest.trim());
    if matches!(signs.first(), None | Some(Sign::Equal | Sign::Near)) {
        return None;
    }
    let read = || match (&parts[..], &signs[..]) {
        (&[name, end], &[sign]) if is_name(name) => Some((name, vec![(sign, end)])),
        (&[end, name], &[sign]) => Some((name, vec![(turned(sign)?, end)])),
        (&[low, name, high], &[first, second]) => {
            Some((name, vec![(turned(first)?, low), (turned(turned(second)?)?, high)]))
        }
        _ => None,
    };
    let found = read().filter(|(name, _)| is_name(name));
    Some(found.map(|(name, ends)| Real { name, ends }).ok_or_else(wrong))
}

/// The sign of the sides in the other order.
fn turned(sign: Sign) -> Option<Sign> {
    Some(match sign {
        Sign::Less => Sign::Greater,
        Sign::AtMost => Sign::AtLeast,
        Sign::Greater => Sign::Less,
        Sign::AtLeast => Sign::AtMost,
        Sign::Equal | Sign::Unequal | Sign::Near => return None,
    })
}

/// The parts of `(a, b)`.
fn parts(text: &str) -> Option<Vec<&str>> {
    let inner = text.trim().strip_prefix('(')?.strip_suffix(')')?;
    Some(split(inner).into_iter().map(str::trim).collect())
}

/// The names of an entry.
pub fn names(text: &str) -> Vec<&str> {
    if let Some(real) = real(text) {
        return real.map_or(Vec::new(), |real| vec![real.name]);
    }
    if let Some(rest) = of_all(text) {
        return rest.split(|c| !in_name(c)).next().into_iter().map(str::trim).collect();
    }
    let Some((name, _)) = text.split_once('=') else { return Vec::new() };
    parts(name).unwrap_or_else(|| vec![name.trim()])
}

/// The names of an entry with listed numbers, and these, row by row.
fn rows(text: &str) -> Option<(Vec<&str>, Vec<Vec<&str>>)> {
    let (name, values) = text.split_once('=').filter(|_| of_all(text).is_none())?;
    if place_of(values, &[".."]).is_some() {
        return None;
    }
    let listed = split(values).into_iter();
    match parts(name) {
        Some(names) => Some((names, listed.map(parts).collect::<Option<_>>()?)),
        None => Some((vec![name.trim()], listed.map(|value| vec![value.trim()]).collect())),
    }
}

/// Reads an index: `n = 1..4`, `n = 1, 2, 4`, `(n, v) = (1, 0.5), (2, 0.25)`, `all n` or `all n >= 3`.
pub fn index(text: &str) -> Result<Index<'_>, Stop> {
    let wrong = || Stop::Wrong(format!("`{text}` is no index with its values"));
    let names = names(text);
    let name = *names.first().ok_or_else(wrong)?;
    if let Some(rest) = of_all(text) {
        let least = rest.get(name.len()..).unwrap_or_default().trim();
        let least = if least.is_empty() {
            1
        } else {
            let least = least.strip_prefix(">=").or(least.strip_prefix('≥')).ok_or_else(wrong)?;
            let least = read_rational(least).filter(Q::is_integer).ok_or_else(wrong)?;
            capped(least.numer(), MAX_INTEGER).ok_or(Stop::Capped("the size of an integer"))?
        };
        return Ok(Index { name, values: Values::From(least) });
    }
    let (_, values) = text.split_once('=').ok_or_else(wrong)?;
    if let Some((at, _)) = place_of(values, &[".."]) {
        let (from, to) = (values.get(..at), values.get(at..).and_then(|to| to.strip_prefix("..")));
        let [from, to] = [from, to].map(|bound| formula(bound.unwrap_or_default()));
        return Ok(Index { name, values: Values::Between(Box::new([from?, to?])) });
    }
    let (names, rows) = rows(text).ok_or_else(wrong)?;
    let number = |text: &&str| read_rational(text);
    let row = |row: &Vec<&str>| row.iter().map(number).collect::<Option<Vec<Q>>>();
    let rows: Option<Vec<Vec<Q>>> = rows.iter().map(row).collect();
    let rows = rows.filter(|rows| rows.iter().all(|row| row.len() == names.len()));
    let rows = rows.ok_or_else(wrong)?;
    Ok(match &names[..] {
        [name] => Index { name, values: Values::Listed(rows.into_iter().flatten().collect()) },
        _ => Index { name, values: Values::Rows(names, rows) },
    })
}

/// What is printed for an index in a case.
pub fn printed(claim: &Toml, case: &Case<'_>, name: &str) -> Option<Decimal> {
    let value = |name: &str| case.iter().find(|(known, _)| *known == name).map(|(_, value)| value);
    ranges(claim).filter_map(rows).find_map(|(names, rows)| {
        let place = names.iter().position(|known| *known == name)?;
        let is = |row: &&Vec<&str>| {
            names.iter().zip(*row).all(|(name, text)| read_rational(text).as_ref() == value(name))
        };
        Decimal::printed(rows.iter().find(is)?.get(place)?)
    })
}
