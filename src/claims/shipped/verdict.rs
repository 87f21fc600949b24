//! The verdict of a number.

use super::claim::{Digits, NumberType, ShippedNumber};
use super::finding::Verdict;
use super::misprint::{Slip, misprint};
use super::number::{Settled as _, unit};
use crate::exact::{Rational, RealExpression};
use std::cmp::Ordering;

/// The most units in the last place of which it is said how many they are.
const MAX_ULPS: u64 = 100;

/// The most digits that are counted as agreeing.
const MAX_DIGITS: u32 = 60;

/// What is said of a shipped number of this type whose exact value is `x`.
pub(super) fn verdict(x: &RealExpression, number: &ShippedNumber, kind: NumberType) -> Verdict {
    decided(x, number, kind).unwrap_or(Verdict::Open)
}

/// As [`verdict`]; `None` when it is not decided within the caps.
fn decided(x: &RealExpression, number: &ShippedNumber, kind: NumberType) -> Option<Verdict> {
    let (lower, upper) = kind.cell(&number.held);
    if x.lies_in(&lower, &upper)? {
        return Some(Verdict::Nearest);
    }
    if let Some(Digits { value, count: Some((digits, places)) }) = &number.written {
        let half = unit(*places) * Rational::new(1, 2);
        if *digits >= 2 && x.is_near(value, &half)? {
            return Some(Verdict::Rounded(*digits));
        }
        if *digits >= 3 && is_cut(x, value, *places)? {
            return Some(Verdict::Cut(*digits));
        }
    }
    let nearest = x.settled(|x| kind.nearest(x))?;
    let steps = nearest.and_then(|nearest| kind.steps(&nearest, &number.held));
    if let Some(steps) = steps.filter(|steps| (1..=MAX_ULPS).contains(steps)) {
        return Some(Verdict::Ulps(steps));
    }
    if let Some(Digits { value, count: Some(count) }) = &number.written
        && let Slip::Of(slip) = misprint(x, value, *count, kind)?
    {
        return Some(Verdict::Misprint(slip));
    }
    Some(Verdict::Refuted(agreeing(x, &number.held)?))
}

/// Whether `value` is x without its digits beyond `places`: 0 ≤ |x| − |value| < 10^−places, with one sign.
fn is_cut(x: &RealExpression, value: &Rational, places: i64) -> Option<bool> {
    let (inner, outer) = match value.sign() {
        // Of 0.000 it is not known which sign it has.
        0 => return Some(false),
        1 => (Ordering::Greater, value + unit(places)),
        _ => (Ordering::Less, value - unit(places)),
    };
    let beyond = x.against(value)?;
    Some((beyond == inner || beyond.is_eq()) && x.against(&outer)? == inner.reverse())
}

/// The greatest a with |held − x| ≤ |x|·10^−a/2: how many leading digits agree.
pub(super) fn agreeing(x: &RealExpression, held: &Rational) -> Option<u32> {
    let near = |agree: u32| {
        let part = unit(i64::from(agree)) * Rational::new(1, 2);
        // Where x ≥ 0, it lies between held/(1 + part) and held/(1 − part); else between them exchanged.
        let one = Rational::one();
        let ends = [held / (&one + &part), held / (&one - &part)];
        x.lies_in((&ends[0]).min(&ends[1]), (&ends[0]).max(&ends[1]))
    };
    let mut agree = 0;
    if held.is_zero() || !near(0)? {
        return Some(0);
    }
    while agree < MAX_DIGITS && near(agree + 1)? {
        agree += 1;
    }
    Some(agree)
}
