//! The grammar of what a relation states.

#![warn(clippy::arithmetic_side_effects)]

use crate::formulas::{Expr, formula};
use crate::numbers::Decimal;
use crate::text::Stop;

/// A sign between two formulas.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Sign {
    Equal,
    Unequal,
    Less,
    AtMost,
    Greater,
    AtLeast,
    Near,
}

/// What is said of a formula.
pub enum Rest {
    /// It has this sign before another side.
    Sign(Sign, Box<Side>),
    /// It is one of these.
    Member(Vec<Expr>),
    /// It is 1, or with `not` 0.
    Is(bool),
}

/// A formula, and the printed number that its text is, if it is one.
#[derive(Clone)]
pub struct Side {
    pub expr: Expr,
    pub printed: Option<Decimal>,
}

/// A comparison.
pub struct Comparison {
    pub left: Side,
    pub rest: Rest,
}

impl Comparison {
    /// The same where a side that is the name of an index stands for what is printed for it.
    pub fn printed(&self, of: impl Fn(&str) -> Option<Decimal>) -> Comparison {
        let side = |side: &Side| {
            let named = if let Expr::Name(name) = &side.expr { of(name) } else { None };
            Side { expr: side.expr.clone(), printed: named.or_else(|| side.printed.clone()) }
        };
        let rest = match &self.rest {
            Rest::Sign(sign, right) => Rest::Sign(*sign, Box::new(side(right))),
            Rest::Member(members) => Rest::Member(members.clone()),
            Rest::Is(one) => Rest::Is(*one),
        };
        Comparison { left: side(&self.left), rest }
    }
}

/// What no statement has.
const REFUSED: [&str; 6] = ["==", "=>", "=<", "±", "+-", "+−"];

/// The signs. Those of two characters stand before those with which they begin.
pub const SIGNS: [(&str, Sign); 11] = [
    ("!=", Sign::Unequal),
    ("<=", Sign::AtMost),
    (">=", Sign::AtLeast),
    ("≠", Sign::Unequal),
    ("≤", Sign::AtMost),
    ("≥", Sign::AtLeast),
    ("=", Sign::Equal),
    ("<", Sign::Less),
    (">", Sign::Greater),
    ("≈", Sign::Near),
    ("~", Sign::Near),
];

fn wrong<T>(what: &str) -> Result<T, Stop> {
    Err(Stop::Wrong(format!("what is stated: {what}")))
}

/// Whether a name goes on with this character.
pub fn in_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The first place outside of brackets at which one of these tokens stands, and which of them.
pub fn place_of(text: &str, tokens: &[&str]) -> Option<(usize, usize)> {
    let (mut depth, mut before) = (0_i64, ' ');
    for (at, c) in text.char_indices() {
        let rest = text.get(at..).unwrap_or_default();
        let is = |token: &&str| {
            // A word is no part of another.
            let word = token.starts_with(in_name);
            let behind = rest.strip_prefix(*token);
            behind.is_some_and(|rest| !word || !in_name(before) && !rest.starts_with(in_name))
        };
        if let Some(which) = tokens.iter().position(is)
            && depth == 0
        {
            return Some((at, which));
        }
        depth = match c {
            '(' | '[' | '{' => depth.saturating_add(1),
            ')' | ']' | '}' => depth.saturating_sub(1),
            _ => depth,
        };
        before = c;
    }
    None
}

/// The parts between commas outside of brackets.
pub fn split(text: &str) -> Vec<&str> {
    let (mut parts, mut rest) = (Vec::new(), text);
    while let Some((at, _)) = place_of(rest, &[","]) {
        let (part, behind) = rest.split_at(at);
        parts.push(part);
        rest = behind.strip_prefix(',').unwrap_or_default();
    }
    parts.push(rest);
    parts
}

fn side(text: &str) -> Result<Side, Stop> {
    Ok(Side { expr: formula(text)?, printed: Decimal::printed(text) })
}

/// What is before a token at this place, and what is behind.
fn around<'t>(text: &'t str, at: usize, token: &str) -> (&'t str, &'t str) {
    let (before, behind) = text.split_at(at);
    (before, behind.strip_prefix(token).unwrap_or_default())
}

/// Reads what is stated. It has one comparison at least.
pub fn comparisons(text: &str) -> Result<Vec<Comparison>, Stop> {
    if REFUSED.iter().any(|refused| text.contains(refused)) {
        return wrong("a sign that no relation has");
    }
    if let Some((at, _)) = place_of(text, &["in"]) {
        let (left, set) = around(text, at, "in");
        return members(&side(left)?, set.trim());
    }
    let tokens = SIGNS.map(|(token, _)| token);
    let (mut stated, mut rest, mut last) = (Vec::new(), text, None::<(Side, Sign)>);
    while let Some((at, which)) = place_of(rest, &tokens) {
        let (token, sign) = SIGNS[which];
        let (before, behind) = around(rest, at, token);
        let next = side(before)?;
        if let Some((left, sign)) = last.replace((next.clone(), sign)) {
            stated.push(Comparison { left, rest: Rest::Sign(sign, Box::new(next)) });
        }
        rest = behind;
    }
    if let Some((left, sign)) = last {
        stated.push(Comparison { left, rest: Rest::Sign(sign, Box::new(side(rest)?)) });
        return Ok(stated);
    }
    let negated =
        rest.trim_start().strip_prefix("not").filter(|rest| rest.starts_with(char::is_whitespace));
    let negated = negated.filter(|rest| !rest.trim().is_empty());
    let left = side(negated.unwrap_or(rest))?;
    Ok(vec![Comparison { left, rest: Rest::Is(negated.is_none()) }])
}

/// Reads a set: members between braces, or the two ends of an interval.
fn members(left: &Side, set: &str) -> Result<Vec<Comparison>, Stop> {
    let mut inner = set.chars();
    let ends = (inner.next(), inner.next_back());
    let parts = split(inner.as_str());
    let comparison = |left: &Side, sign, right: &Side| Comparison {
        left: left.clone(),
        rest: Rest::Sign(sign, Box::new(right.clone())),
    };
    match (ends, &parts[..]) {
        ((Some('{'), Some('}')), _) => {
            let members = parts.iter().map(|part| formula(part)).collect::<Result<_, Stop>>()?;
            Ok(vec![Comparison { left: left.clone(), rest: Rest::Member(members) }])
        }
        ((Some(open @ ('[' | '(')), Some(close @ (']' | ')'))), [low, high]) => {
            let [low, high] = [side(low)?, side(high)?];
            let sign = |open| if open { Sign::Less } else { Sign::AtMost };
            Ok(vec![
                comparison(&low, sign(open == '('), left),
                comparison(left, sign(close == ')'), &high),
            ])
        }
        _ => wrong("behind `in` stands no set"),
    }
}
