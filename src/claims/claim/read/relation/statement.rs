//! The texts of relations: `a < b <= c`, `x in {1, 2}`, `not symmetric()`, and `all n >= 2`.

use crate::claim::Sign;
use std::ops::Range;

/// The signs of relations. Of two that begin alike, the longer one stands first.
const SIGNS: [(&str, Sign); 11] = [
    ("!=", Sign::Unequal),
    ("<=", Sign::AtMost),
    (">=", Sign::AtLeast),
    ("≠", Sign::Unequal),
    ("≤", Sign::AtMost),
    ("≥", Sign::AtLeast),
    ("≈", Sign::Near),
    ("~", Sign::Near),
    ("=", Sign::Equal),
    ("<", Sign::Less),
    (">", Sign::Greater),
];

/// A statement, with the texts of its formulas.
#[derive(Debug)]
pub(super) enum Statement<'t> {
    /// Formulas with signs between them.
    Chain(&'t str, Vec<(Sign, &'t str)>),
    /// One formula, after `not` or not.
    Alone(&'t str, bool),
    /// A formula that is claimed to be one of those.
    OneOf(&'t str, Vec<&'t str>),
    /// A formula that is claimed to be between two others: `x in [a, b)`.
    Between(&'t str, [(Sign, &'t str); 2]),
}

/// Why a text is no statement.
#[derive(Clone, Copy, Debug)]
pub(super) enum NoStatement {
    /// Nothing stands on one side of a sign.
    NoSide,
    /// `==`, `=>` or `=<`.
    Doubled,
    /// `+-`, or `±`.
    PlusMinus,
    /// What stands behind `in` is no set.
    NoSet,
    /// There is a sign beside `in`.
    SignAndSet,
    /// A bracket has no partner.
    Bracket,
}

/// The statement that a text makes.
pub(super) fn statement(text: &str) -> Result<Statement<'_>, NoStatement> {
    if ["==", "=>", "=<"].iter().any(|sign| text.contains(sign)) {
        return Err(NoStatement::Doubled);
    }
    if ["+-", "±", "+−"].iter().any(|sign| text.contains(sign)) {
        return Err(NoStatement::PlusMinus);
    }
    let outer = outer(text).ok_or(NoStatement::Bracket)?;
    let signs = signs(text, &outer);
    if let Some(at) = word(text, &outer, "in") {
        if !signs.is_empty() {
            return Err(NoStatement::SignAndSet);
        }
        return set(side(&text[..at.start])?, text[at.end..].trim());
    }
    let Some((_, first)) = signs.first() else {
        let trimmed = text.trim();
        let negated =
            trimmed.strip_prefix("not").filter(|rest| rest.starts_with(char::is_whitespace));
        return Ok(Statement::Alone(side(negated.unwrap_or(trimmed))?, negated.is_none()));
    };
    let left = side(&text[..first.start])?;
    let ends = signs.iter().skip(1).map(|(_, at)| at.start).chain([text.len()]);
    let parts = signs.iter().zip(ends);
    let parts = parts.map(|((sign, at), end)| Ok((*sign, side(&text[at.end..end])?)));
    Ok(Statement::Chain(left, parts.collect::<Result<_, NoStatement>>()?))
}

fn side(text: &str) -> Result<&str, NoStatement> {
    Some(text.trim()).filter(|text| !text.is_empty()).ok_or(NoStatement::NoSide)
}

/// `{a, b}`, `[a, b]`, `(a, b]`, `[a, b)` or `(a, b)`.
fn set<'t>(left: &'t str, text: &'t str) -> Result<Statement<'t>, NoStatement> {
    let mut inner = text.chars();
    let ends = inner.next().zip(inner.next_back()).ok_or(NoStatement::NoSet)?;
    let members = separated(inner.as_str()).ok_or(NoStatement::Bracket)?;
    let members = members.into_iter().map(side).collect::<Result<Vec<&str>, _>>();
    let members = members.map_err(|_| NoStatement::NoSet)?;
    match (ends, &members[..]) {
        (('{', '}'), _) => Ok(Statement::OneOf(left, members)),
        ((open @ ('[' | '('), close @ (']' | ')')), [low, high]) => {
            let low = (if open == '[' { Sign::AtMost } else { Sign::Less }, *low);
            let high = (if close == ']' { Sign::AtMost } else { Sign::Less }, *high);
            Ok(Statement::Between(left, [low, high]))
        }
        _ => Err(NoStatement::NoSet),
    }
}

/// The parts between the commas outside of brackets; `None` if a bracket has no partner.
pub(super) fn separated(text: &str) -> Option<Vec<&str>> {
    let outer = outer(text)?;
    let mut parts = Vec::new();
    let mut from = 0;
    for at in outer.into_iter().filter(|at| text[*at..].starts_with(',')) {
        parts.push(&text[from..at]);
        from = at.checked_add(1)?;
    }
    parts.push(&text[from..]);
    Some(parts)
}

/// The places of the characters outside of brackets; `None` if a bracket has no partner. The set of an interval may open and
/// close with different ones, so that only their number counts.
fn outer(text: &str) -> Option<Vec<usize>> {
    let (mut depth, mut outer) = (0_usize, Vec::new());
    for (at, c) in text.char_indices() {
        match c {
            '(' | '[' | '{' => depth = depth.checked_add(1)?,
            ')' | ']' | '}' => depth = depth.checked_sub(1)?,
            _ if depth == 0 => outer.push(at),
            _ => {}
        }
    }
    (depth == 0).then_some(outer)
}

/// The signs outside of brackets, with their places.
fn signs(text: &str, outer: &[usize]) -> Vec<(Sign, Range<usize>)> {
    let mut found: Vec<(Sign, Range<usize>)> = Vec::new();
    for &at in outer {
        let within = found.last().is_some_and(|(_, last)| at < last.end);
        let sign = SIGNS.iter().find(|(mark, _)| text[at..].starts_with(mark));
        if let Some((mark, sign)) = sign.filter(|_| !within) {
            found.push((*sign, at..at.saturating_add(mark.len())));
        }
    }
    found
}

/// The place of a word outside of brackets.
fn word(text: &str, outer: &[usize], word: &str) -> Option<Range<usize>> {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    outer.iter().find_map(|&at| {
        let after = text[at..].strip_prefix(word)?;
        let alone = !text[..at].ends_with(is_part) && !after.starts_with(is_part);
        alone.then(|| at..at.saturating_add(word.len()))
    })
}

/// The values of an index.
#[derive(Debug)]
pub(super) enum Values<'t> {
    /// `n = 2..8`
    Range(&'t str, &'t str),
    /// `n = 2, 4, 8`
    Listed(Vec<&'t str>),
    /// `(n, v) = (3, 0.41), (4, 0.5)`
    Rows(Vec<Vec<&'t str>>),
    /// `all n >= 2`
    All(Option<&'t str>),
    /// `real v`, `0 < v <= 1`, `v != 0`: the signs behind `v`, each with what stands behind it.
    Real(Vec<(Sign, &'t str)>),
}

/// An index with its values: `n = 2..8`, `n = 2, 4, 8`, `all n` or `all n >= 2`; or several with rows of values.
pub(super) fn index(text: &str) -> Option<(Vec<&str>, Values<'_>)> {
    let text = text.trim();
    if let Some(rest) =
        text.strip_prefix("all").filter(|rest| rest.starts_with(char::is_whitespace))
    {
        let bound = [">=", "≥"].into_iter().find_map(|sign| rest.split_once(sign));
        let (name, from) = bound.map_or((rest, None), |(name, from)| (name, Some(from.trim())));
        return Some((vec![name.trim()], Values::All(from)));
    }
    if let Some(rest) =
        text.strip_prefix("real").filter(|rest| rest.starts_with(char::is_whitespace))
    {
        return Some((vec![rest.trim()], Values::Real(Vec::new())));
    }
    if let Some((name, signs)) = described(text) {
        return Some((vec![name], Values::Real(signs)));
    }
    let (name, values) = text.split_once('=')?;
    if name.starts_with('(') {
        let rows = separated(values)?.into_iter().map(listed).collect::<Option<Vec<_>>>()?;
        return Some((listed(name)?, Values::Rows(rows)));
    }
    let range = outer(values)?.into_iter().find(|&at| values[at..].starts_with(".."));
    let values = match range.and_then(|at| Some((&values[..at], values.get(at.checked_add(2)?..)?)))
    {
        Some((from, to)) => Values::Range(from.trim(), to.trim()),
        None => Values::Listed(values.split(',').map(str::trim).collect()),
    };
    Some((vec![name.trim()], values))
}

/// `a < v <= b`, `v > a`, `a >= v`, `v != a`: the name, and the signs behind it with what stands behind them.
fn described(text: &str) -> Option<(&str, Vec<(Sign, &str)>)> {
    let found = signs(text, &outer(text)?);
    let end = |at: usize| found.get(at).map_or(text.len(), |(_, place)| place.start);
    let behind = |at: usize| Some(text.get(found.get(at)?.1.end..end(at.checked_add(1)?))?.trim());
    let before = text.get(..end(0))?.trim();
    let is_order = |sign| !matches!(sign, Sign::Equal | Sign::Near);
    if !found.iter().all(|(sign, _)| is_order(*sign)) {
        return None;
    }
    match found[..] {
        // The formula may stand on either side: a name is no number.
        [(sign, _)] if is_name(before) => Some((before, vec![(sign, behind(0)?)])),
        [(sign, _)] => Some((behind(0)?, vec![(turned(sign), before)])),
        [(first, _), (second, _)] if first != Sign::Unequal && second != Sign::Unequal => {
            Some((behind(0)?, vec![(turned(first), before), (second, behind(1)?)]))
        }
        _ => None,
    }
}

fn is_name(text: &str) -> bool {
    text.starts_with(char::is_alphabetic) && text.chars().all(|c| c.is_alphanumeric() || c == '_')
}

/// The sign with which the sides change places.
fn turned(sign: Sign) -> Sign {
    match sign {
        Sign::Less => Sign::Greater,
        Sign::AtMost => Sign::AtLeast,
        Sign::Greater => Sign::Less,
        Sign::AtLeast => Sign::AtMost,
        other => other,
    }
}

/// The parts of `(a, b)`.
fn listed(text: &str) -> Option<Vec<&str>> {
    let inner = text.trim().strip_prefix('(')?.strip_suffix(')')?;
    Some(inner.split(',').map(str::trim).collect())
}
