//! The rule `relation`: what is stated of formulas is true or false in every case.

mod all;
mod compare;
mod states;

use super::equation::cases::{Index, Listing, MAX_CASES, Values, cases, name_of, scope};
use super::kind::{Kind, Proof};
use crate::claims::Paper;
use crate::formulas::{MAX_INTEGER, formula};
use crate::numbers::{Q, capped, read_rational};
use crate::text::{Block, Checked, Reason, Stop, Toml, Verdict, require};
use states::{Comparison, comparisons, in_name, place_of, split};
use std::rc::Rc;

/// Claims of this kind.
pub const KIND: Kind = Kind {
    name: "relation",
    fields: "relation: claim symbols=*text hypotheses=*text states=text for=text|*text absent=text",
    names,
    check: |paper, claim, block| check(paper, claim, block).map(|()| Proof::Other),
};

/// Checks a relation.
fn check<'a>(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<()> {
    if claim.get("absent").is_some() {
        let states = claim.get("states");
        require(states.is_none(), Reason::Malformed("a statement, or what is absent"))?;
        return block.restates("absent", claim.text("absent"));
    }
    block.restates("states", claim.text("states"))?;
    let stated = comparisons(claim.text("states").unwrap_or_default())?;
    let indices = ranges(claim).map(index).collect::<Result<Vec<Index<'_>>, Stop>>()?;
    let every = indices.iter().any(Index::is_all);
    match block.peek().map(|line| line.word()) {
        Some(("holds", "all")) if every => {
            block.any()?;
            all::shown(paper, claim, &indices, &stated)
        }
        Some(("fails", "all")) if every => {
            block.any()?;
            one_case(paper, claim, (&indices, &stated), block)
        }
        _ => every_case(paper, claim, (&indices, &stated), block),
    }
}

/// Checks the verdict on all cases, or on the first ones if an index has all values.
fn every_case<'a>(
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    (indices, stated): (&[Index<'a>], &[Comparison]),
    block: &mut Block<'_>,
) -> Checked<()> {
    let cases = cases(paper, indices)?;
    let open = indices.iter().any(Index::is_all);
    let verdicts: &[Verdict] =
        if open { &[Verdict::Tried] } else { &[Verdict::Holds, Verdict::Fails] };
    let count = cases.len().saturating_mul(stated.len());
    if count > MAX_CASES {
        return Err(Stop::Capped("the number of cases").into());
    }
    let mut listing = Listing::read(block, verdicts, count)?;
    let memory = Rc::default();
    for case in &cases {
        let scope = scope(paper, claim, (case, &[]), &memory)?;
        for (number, comparison) in (1..).zip(stated) {
            let (fails, difference) = compare::judged(comparison, &scope)?;
            let name = numbered(name_of(case), number, stated);
            listing.check(block, &name, (fails, &difference), &scope)?;
        }
    }
    let at = block.at;
    listing.finished(block)?;
    block.finished()?;
    block.at = at;
    require(!open, Reason::Open)
}

/// Checks one case that is false, where an index has all values.
fn one_case<'a>(
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    (indices, stated): (&[Index<'a>], &[Comparison]),
    block: &mut Block<'_>,
) -> Checked<()> {
    block.look();
    let line = block.peek().map(|line| line.word()).filter(|(word, _)| *word == "case");
    let (said, _) = line.and_then(|(_, said)| said.split_once('=')).ok_or(Reason::Case)?;
    let mut words = said.split_whitespace();
    let mut case = Vec::new();
    for index in indices {
        let value = words.next().and_then(read_rational).ok_or(Reason::Case)?;
        require(index.has(paper, &case, &value)?, Reason::Case)?;
        case.push((index.name, value));
    }
    let number = if stated.len() > 1 { words.next().unwrap_or_default() } else { "1" };
    let found = (1..).zip(stated).find(|(place, _)| place.to_string() == number);
    let (number, comparison) = found.ok_or(Reason::Case)?;
    let scope = scope(paper, claim, (&case, &[]), &Rc::default())?;
    let (fails, difference) = compare::judged(comparison, &scope)?;
    // Numbers that are written otherwise name no case.
    let name = numbered(name_of(&case), number, stated);
    require(said.trim() == name, Reason::Case)?;
    let mut listing = Listing::of(Verdict::Fails);
    listing.check(block, &name, (fails, &difference), &scope)?;
    listing.finished(block)
}

/// The name of a case with the number of a comparison, if there are several.
fn numbered(case: String, number: usize, stated: &[Comparison]) -> String {
    match (stated.len() > 1, case.is_empty()) {
        (true, true) => number.to_string(),
        (true, false) => format!("{case} {number}"),
        _ => case,
    }
}

/// The texts of `for`.
fn ranges(claim: &Toml) -> impl Iterator<Item = &str> {
    claim.text("for").into_iter().chain(claim.texts("for"))
}

/// What follows `all`.
fn of_all(text: &str) -> Option<&str> {
    let rest = text.trim().strip_prefix("all").filter(|rest| rest.starts_with(char::is_whitespace));
    rest.map(str::trim).filter(|rest| !rest.starts_with('='))
}

/// The name of an index.
fn name(text: &str) -> Option<&str> {
    let name = match of_all(text) {
        Some(rest) => rest.split(|c| !in_name(c)).next()?,
        None => text.split_once('=')?.0,
    };
    Some(name.trim())
}

/// Reads an index: `n = 1..4`, `n = 1, 2, 4`, `all n` or `all n >= 3`.
fn index(text: &str) -> Result<Index<'_>, Stop> {
    let wrong = || Stop::Wrong(format!("`{text}` is no index with its values"));
    let name = name(text).ok_or_else(wrong)?;
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
    let values: Option<Vec<Q>> = split(values).into_iter().map(read_rational).collect();
    Ok(Index { name, values: Values::Listed(values.ok_or_else(wrong)?) })
}

/// The symbols and the indices of a relation.
fn names(claim: &Toml) -> Vec<&str> {
    claim.texts("symbols").chain(ranges(claim).filter_map(name)).collect()
}
