//! Slips in typing a number.

use super::claim::NumberType;
use super::finding::Misprint;
use super::number::{Settled as _, unit};
use crate::exact::{Rational, RealExpression};

/// The fewest digits of which a moved point is recognised.
const POINT_DIGITS: usize = 4;

/// The fewest digits of which one that is wrong, exchanged or missing is recognised.
const SLIP_DIGITS: usize = 5;

/// How many of the last digits a wrong or missing digit must not be among: there it may be another kind of error.
const LAST: usize = 2;

/// Whether a number differs from the right one by a slip.
pub(super) enum Slip {
    /// It does, by this one.
    Of(Misprint),
    /// It does not.
    No,
}

/// The slip by which the literal `value`, with `digits` significant digits and `places` after the point, differs from
/// x; `None` when it is not decided.
pub(super) fn misprint(
    x: &RealExpression,
    value: &Rational,
    (digits, places): (usize, i64),
    kind: NumberType,
) -> Option<Slip> {
    let half = Rational::new(1, 2);
    if digits >= 3 {
        let (lower, upper) = kind.cell(&kind.nearest(&-value)?);
        let is_nearest = x.lies_in(&lower, &upper)?;
        if is_nearest || x.is_near(&-value, &(unit(places) * &half))? {
            return Some(Slip::Of(Misprint::Sign));
        }
    }
    if digits >= POINT_DIGITS {
        for shift in [1, -1, 2, -2, 3, -3] {
            // The moved number has as many digits, of which `shift` more stand after the point.
            if x.is_near(&(value * unit(shift)), &(unit(places + shift) * &half))? {
                return Some(Slip::Of(Misprint::Point));
            }
        }
    }
    if digits < SLIP_DIGITS {
        return Some(Slip::No);
    }
    let typed = text(value, places);
    let right = x.settled(|x| text(x, places))?;
    if x.against(&Rational::zero())?.is_lt() == (value.sign() < 0) {
        if let Some(slip) = changed(&typed, &right) {
            return Some(Slip::Of(slip));
        }
        let longer = x.settled(|x| text(x, places + 1))?;
        if is_dropped(&typed, &longer) {
            return Some(Slip::Of(Misprint::Dropped));
        }
    }
    Some(Slip::No)
}

/// The digits of |value|, rounded to `places` after the point, from the first that is not 0.
fn text(value: &Rational, places: i64) -> String {
    (value.abs() / unit(places)).round_half_even().to_string()
}

/// The slip that makes `typed` of `right`, if it changes one digit or exchanges two neighbours.
fn changed(typed: &str, right: &str) -> Option<Misprint> {
    let (typed, right) = (typed.as_bytes(), right.as_bytes());
    if typed.len() != right.len() {
        return None;
    }
    let wrong: Vec<usize> = (0..typed.len()).filter(|&at| typed[at] != right[at]).collect();
    match wrong[..] {
        [at] if at + LAST < typed.len() => Some(Misprint::Digit),
        [a, b] if a + 1 == b && typed[a] == right[b] && typed[b] == right[a] => {
            Some(Misprint::Exchanged)
        }
        _ => None,
    }
}

/// Whether `typed` is `longer` without one of its digits, which is not among the last.
fn is_dropped(typed: &str, longer: &str) -> bool {
    if typed.len() + 1 != longer.len() {
        return false;
    }
    (0..longer.len().saturating_sub(LAST)).any(|at| {
        let without = longer.bytes().enumerate().filter(|(place, _)| *place != at);
        without.map(|(_, digit)| digit).eq(typed.bytes())
    })
}
