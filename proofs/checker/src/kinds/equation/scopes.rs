//! The meanings of names in the cases of a claim.

#![warn(clippy::arithmetic_side_effects)]

use super::cases::Case;
use super::hypotheses;
use crate::claims::Paper;
use crate::formulas::{Memory, Scope};
use crate::numbers::{Piece, Value};
use crate::schemes::Every;
use crate::text::{Stop, Toml};
use std::rc::Rc;

/// The scope of a case. It shares the known values of definitions with other cases.
pub fn scope<'a>(
    paper: &'a Paper<'a>,
    claim: &Toml,
    case: &Case<'_>,
    memory: &Rc<Memory>,
) -> Result<Scope<'a>, Stop> {
    let mut scope = names(paper, claim, (case, &[]), memory)?;
    resolve(paper, claim, &mut scope)?;
    Ok(scope)
}

/// The scope of a case in which the indices with all values are symbols.
///
/// What holds of a mask with a symbol need not hold of a number in its place: the mask may be shorter there. So a scheme that
/// depends on them is a family.
pub fn scope_of_all<'a>(
    paper: &'a Paper<'a>,
    claim: &Toml,
    (case, every): (&Case<'_>, Every),
    memory: &Rc<Memory>,
) -> Result<Scope<'a>, Stop> {
    let mut scope = scope_of_every(paper, claim, (case, every), memory)?;
    resolve(paper, claim, &mut scope)?;
    Ok(scope)
}

/// The same without the scheme of the claim.
pub fn scope_of_every<'a>(
    paper: &'a Paper<'a>,
    claim: &Toml,
    (case, every): (&Case<'_>, Every),
    memory: &Rc<Memory>,
) -> Result<Scope<'a>, Stop> {
    let symbols: Vec<&str> = every.indices.iter().map(|all| &all.index[..]).collect();
    let mut scope = names(paper, claim, (case, &symbols), memory)?;
    scope.every = Some(every);
    Ok(scope)
}

/// The scope of a case on a piece of another index, which is a symbol also in the mask.
pub fn scope_on<'a>(
    paper: &'a Paper<'a>,
    claim: &Toml,
    case: &Case<'_>,
    (name, piece): (&str, Piece<'a>),
) -> Result<Scope<'a>, Stop> {
    // What is known of definitions is known of this piece.
    let mut scope = names(paper, claim, (case, &[name]), &Rc::default())?;
    scope.piece = Some(piece.of_masks());
    resolve(paper, claim, &mut scope)?;
    Ok(scope)
}

/// The scope of a case without the scheme.
fn names<'a>(
    paper: &'a Paper<'a>,
    claim: &Toml,
    (case, symbols): (&Case<'_>, &[&str]),
    memory: &Rc<Memory>,
) -> Result<Scope<'a>, Stop> {
    // Relations have the values that the file states.
    let relation = claim.get("states").is_some();
    let mut scope = if relation { paper.stated() } else { paper.scope() };
    for (name, _) in case {
        scope.beyond.remove(*name);
    }
    for name in claim.texts("symbols").chain(symbols.iter().copied()) {
        scope.beyond.remove(name);
    }
    for symbol in claim.texts("symbols") {
        scope.values.insert(symbol.to_owned(), Value::symbol(symbol));
        scope.families.insert(symbol.to_owned());
    }
    scope.memory = Rc::clone(memory);
    scope.filters = true;
    let symbols = symbols.iter().map(|name| (*name, Value::symbol(name)));
    let values = case.iter().map(|(name, value)| (*name, Value::from(value.clone())));
    for (name, value) in values.chain(symbols) {
        scope.hidden.insert(name.to_owned());
        scope.values.insert(name.to_owned(), value);
    }
    hypotheses::suppose(claim, &mut scope)?;
    Ok(scope)
}

/// Gives a scope the scheme of the claim.
fn resolve(paper: &Paper<'_>, claim: &Toml, scope: &mut Scope<'_>) -> Result<(), Stop> {
    if let Some(reference) = claim.text("scheme") {
        if let Some(entries) = paper.library.depending(reference, scope)? {
            if let Some(every) = &mut scope.every {
                every.family = Some(Rc::new(paper.library.family(entries, every)?));
            }
        } else if paper.library.is_lattice(reference) {
            scope.lattice = Some(paper.library.lattice(reference, scope)?);
        } else if paper.library.is_ring(reference) {
            scope.ring = Some(Rc::new(paper.library.ring(reference, scope)?));
        } else {
            scope.scheme = paper.library.resolve_any(reference, scope)?.first().cloned();
        }
    }
    Ok(())
}
