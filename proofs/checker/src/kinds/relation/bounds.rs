//! Whether a comparison with calls of `smoothness` or `hoelder` is true on a piece, by their bounds.

#![warn(clippy::arithmetic_side_effects)]

use super::compare::{fits, judged};
use super::states::{Comparison, Rest, Sign};
use crate::formulas::{Expr, Scope};
use crate::functions::exponent::{Bounded, bounded, is_call};
use crate::numbers::{Piece, Value};
use crate::schemes::Library;
use crate::text::Stop;
use std::cmp::Ordering;

/// The sign and the sides of a comparison, if one of them is nothing but such a call.
fn sides(comparison: &Comparison) -> Option<(Sign, [&Expr; 2])> {
    let Rest::Sign(sign, right) = &comparison.rest else { return None };
    let sides = [&comparison.left.expr, &right.expr];
    (*sign != Sign::Near && sides.iter().any(|side| is_call(side))).then_some((*sign, sides))
}

/// Whether a side of a comparison is nothing but such a call.
pub fn has_call(comparison: &Comparison) -> bool {
    sides(comparison).is_some()
}

/// Whether a comparison is false on the piece of a scope, by bounds if a side is a call with a mask that depends on the symbol.
pub fn judged_on(
    library: &Library<'_>,
    comparison: &Comparison,
    scope: &Scope<'_>,
) -> Result<bool, Stop> {
    if let (Some((sign, [left, right])), Some(piece)) = (sides(comparison), &scope.piece) {
        let [left, right] = [left, right].map(|side| bounded(library, scope, piece, side));
        let (left, right) = (left?, right?);
        if is_open(&left) || is_open(&right) {
            let undecided = Stop::Undecided("a comparison with bounds of smoothness");
            return truth(sign, (&left, &right), piece)?.map(|holds| !holds).ok_or(undecided);
        }
    }
    judged(comparison, scope).map(|(fails, _)| fails)
}

fn is_open(side: &Bounded<'_>) -> bool {
    matches!(side, Bounded::Call(_))
}

/// Whether a comparison is true for all numbers within the bounds of both sides; `None` if it is so for some of them, as far as
/// the bounds show.
fn truth(
    sign: Sign,
    (left, right): (&Bounded<'_>, &Bounded<'_>),
    piece: &Piece<'_>,
) -> Result<Option<bool>, Stop> {
    let mut orders = [(left, right, Ordering::Less), (right, left, Ordering::Greater)];
    // The upper bound of a call needs less than its lower bound.
    if !is_open(left) {
        orders.reverse();
    }
    let equal = fits(sign, Ordering::Equal);
    for (lower, upper, order) in &orders {
        let holds = fits(sign, *order);
        if below(lower, upper, holds != equal, piece)? {
            return Ok(Some(holds));
        }
    }
    if !matches!(sign, Sign::Equal | Sign::Unequal) {
        return Ok(None);
    }
    // All numbers within the bounds of both sides are equal.
    for (lower, upper, _) in &orders {
        if !below(lower, upper, false, piece)? {
            return Ok(None);
        }
    }
    Ok(Some(equal))
}

/// Whether all numbers within the bounds of one side are less than those within the bounds of another one; at most these, if not
/// strictly.
fn below(
    lower: &Bounded<'_>,
    upper: &Bounded<'_>,
    strictly: bool,
    piece: &Piece<'_>,
) -> Result<bool, Stop> {
    let most = match lower {
        Bounded::Between([_, most]) => most.clone(),
        Bounded::Call(bounds) => bounds.most()?,
    };
    let fits = |least: &Value| {
        let order = most.compare_on(least, Some(piece))?;
        Ok(order.is_lt() || !strictly && order.is_eq())
    };
    let is_limited = || match lower {
        Bounded::Between(_) => Ok(true),
        Bounded::Call(bounds) => bounds.is_limited(),
    };
    match upper {
        Bounded::Between([least, _]) => Ok(fits(least)? && is_limited()?),
        Bounded::Call(bounds) => Ok(is_limited()? && bounds.reaches(fits)?),
    }
}
