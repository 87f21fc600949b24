//! The rule `relation`: what is stated of formulas is true or false in every case.

mod all;
mod bounds;
mod compare;
mod ranges;
mod reals;
pub mod states;

use super::equation::cases::{Index, Listing, MAX_CASES, cases, name_of};
use super::equation::scopes::scope;
use super::kind::{Kind, Proof};
use crate::claims::{Paper, value};
use crate::formulas::Scope;
use crate::numbers::{Q, read_rational};
use crate::text::{Block, Checked, Reason, Stop, Toml, Verdict, require};
use ranges::{index, printed, ranges};
use states::{Comparison, comparisons};
use std::rc::Rc;

/// Claims of this kind.
pub const KIND: Kind = Kind {
    name: "relation",
    fields: "relation: claim symbols=*text hypotheses=*text states=text|*text for=text|*text only=flag absent=text",
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
    let mut stated = Vec::new();
    for text in claim.one_or_more("states") {
        block.restates("states", Some(text))?;
        stated.extend(comparisons(text)?);
    }
    // What states nothing would hold.
    require(!stated.is_empty(), Reason::Malformed("a statement"))?;
    if reals::concern(claim) {
        return reals::check(paper, claim, &stated, block);
    }
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
        let scope = scope(paper, claim, case, &memory)?;
        for (number, comparison) in (1..).zip(stated) {
            let name = numbered(name_of(case), number, stated);
            let comparison = &comparison.printed(|name| printed(claim, case, name));
            check_case((paper, claim), &mut listing, block, comparison, (&scope, &name))?;
        }
    }
    let at = block.at;
    listing.finished(block)?;
    block.finished()?;
    block.at = at;
    require(!open, Reason::Open)
}

/// Checks what a certificate says of a case, in which the sides may be real numbers if there are no symbols.
fn check_case(
    (paper, claim): (&Paper<'_>, &Toml),
    listing: &mut Listing,
    block: &mut Block<'_>,
    comparison: &Comparison,
    (scope, name): (&Scope<'_>, &str),
) -> Checked<()> {
    match compare::judged(comparison, scope) {
        Ok((fails, difference)) => listing.check(block, name, (fails, &difference), scope),
        Err(_) if claim.texts("symbols").next().is_none() => {
            let library = paper.library;
            let mut found = compare::judged_reals(library, comparison, scope)?;
            if found.number.is_none()
                && let Some(said) = Listing::said(block, name)
            {
                let said = value(&said, scope)?;
                compare::found_as(library, comparison, scope, &said, &mut found)?;
            }
            let known = (found.fails, &found.difference, found.number.as_ref());
            listing.check_real(block, name, known, scope)
        }
        Err(stop) => Err(stop.into()),
    }
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
    let said = line.map(|(_, said)| said).ok_or(Reason::Case)?;
    let said = said.split_once('=').or_else(|| said.split_once(" in ")).ok_or(Reason::Case)?.0;
    let mut words = said.split_whitespace();
    let mut case = Vec::new();
    for index in indices {
        let names = index.names();
        let values: Option<Vec<Q>> =
            names.iter().map(|_| words.next().and_then(read_rational)).collect();
        let values = values.ok_or(Reason::Case)?;
        require(index.has(paper, &case, &values)?, Reason::Case)?;
        case.extend(names.into_iter().zip(values));
    }
    let number = if stated.len() > 1 { words.next().unwrap_or_default() } else { "1" };
    let found = (1..).zip(stated).find(|(place, _)| place.to_string() == number);
    let (number, comparison) = found.ok_or(Reason::Case)?;
    let scope = scope(paper, claim, &case, &Rc::default())?;
    let comparison = &comparison.printed(|name| printed(claim, &case, name));
    // Numbers that are written otherwise name no case.
    let name = numbered(name_of(&case), number, stated);
    require(said.trim() == name, Reason::Case)?;
    let mut listing = Listing::of(Verdict::Fails);
    check_case((paper, claim), &mut listing, block, comparison, (&scope, &name))?;
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

/// The symbols and the indices of a relation.
fn names(claim: &Toml) -> Vec<&str> {
    claim.texts("symbols").chain(ranges(claim).flat_map(ranges::names)).collect()
}
