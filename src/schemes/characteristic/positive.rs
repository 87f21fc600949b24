//! Where polynomials in a parameter are positive, exactly.

use super::ball::Ball;
use crate::exact::{
    Interval, IntervalSet, Rational, Real as _, RealAlgebraic, RealCyclotomic, RealExpression,
    Scalar as _,
};
use std::ops::Bound;

/// The most halvings of an interval.
const MAX_HALVINGS: u32 = 7;

/// A polynomial in one variable over Q(2cos(2π/n)), its coefficients from the constant one on.
pub(super) type Coefficients = Vec<RealCyclotomic>;

/// The numbers x with c_0 + c_1x > 0; `None` where the end is out of reach.
pub(super) fn affine(constant: &RealExpression, slope: &RealExpression) -> Option<IntervalSet> {
    let everything = |holds| if holds { IntervalSet::everything() } else { IntervalSet::default() };
    let side = slope.sign();
    if side == 0 {
        return Some(everything(constant.sign() > 0));
    }
    let end = RealExpression::zero().minus(constant).over(slope).to_algebraic()?;
    let (end, free) = (Bound::Excluded(end), Bound::Unbounded);
    let (low, high) = if side > 0 { (end, free) } else { (free, end) };
    Some(IntervalSet::from(Interval { low, high }))
}

/// The numbers x between two numbers with p(x) > 0, and any others beyond them; `None` where a root is out of reach.
pub(super) fn positive(p: &Coefficients, low: &Rational, high: &Rational) -> Option<IntervalSet> {
    let mut p = p.clone();
    while p.last().is_some_and(|c| c.sign() == 0) {
        p.pop();
    }
    let all = |holds| if holds { IntervalSet::everything() } else { IntervalSet::default() };
    if p.len() < 2 {
        return Some(all(p.first().is_some_and(|c| c.sign() > 0)));
    }
    let balls: Vec<Ball> = p.iter().map(Ball::of).collect();
    if let Some(sign) = sign_between(&balls, low, high, MAX_HALVINGS) {
        return Some(all(sign > 0));
    }
    let mut roots: Vec<RealAlgebraic> = Vec::new();
    for root in RealExpression::roots(&p).ok()? {
        let beyond = |end: &Rational| root.minus(&RealExpression::from(end.clone())).sign();
        if beyond(low) > 0 && beyond(high) < 0 {
            roots.push(root.to_algebraic()?);
        }
    }
    let mut between = RealAlgebraic::rationals_between(&roots);
    // The first and the last may be beyond the ends.
    let two = Rational::from(2);
    if let (Some(first), Some(last)) = (roots.first(), roots.last()) {
        let count = between.len();
        between[0] = (low + &first.bounds().0.max(low.clone())) / &two;
        between[count - 1] = (high + &last.bounds().1.min(high.clone())) / &two;
    } else {
        between = vec![(low + high) / &two];
    }
    let mut set = IntervalSet::default();
    for (place, at) in between.iter().enumerate() {
        if value(&p, at).sign() > 0 {
            let end = |place: Option<usize>| match place.and_then(|place| roots.get(place)) {
                Some(root) => Bound::Excluded(root.clone()),
                None => Bound::Unbounded,
            };
            let interval = Interval { low: end(place.checked_sub(1)), high: end(Some(place)) };
            set = set.union(&IntervalSet::from(interval));
        }
    }
    Some(set)
}

/// The sign of a polynomial between two numbers, by its Bernstein coefficients on parts of the interval; `None` where they do
/// not show that there is one.
fn sign_between(p: &[Ball], low: &Rational, high: &Rational, left: u32) -> Option<i8> {
    // p(low + (high − low)t), by Horner's rule.
    let (from, width) = (Ball::from_rational(low), Ball::from_rational(&(high - low)));
    let mut shifted: Vec<Ball> = Vec::new();
    for c in p.iter().rev() {
        let mut next = vec![Ball::zero(); shifted.len() + 1];
        for (i, x) in shifted.iter().enumerate() {
            next[i] = next[i].plus(&x.times(&from));
            next[i + 1] = next[i + 1].plus(&x.times(&width));
        }
        next[0] = next[0].plus(c);
        shifted = next;
    }
    let d = shifted.len() - 1;
    let share = |i: usize, j: usize| {
        // C(j, i)/C(d, i).
        (0..i).fold(Rational::one(), |product, m| product * Rational::new(j - m, d - m))
    };
    let coefficient = |j: usize| {
        (0..=j).fold(Ball::zero(), |sum, i| {
            sum.plus(&shifted[i].times(&Ball::from_rational(&share(i, j))))
        })
    };
    let signs: Vec<Option<i8>> = (0..=d).map(|j| coefficient(j).sign()).collect();
    if [Some(1), Some(-1)].contains(&signs[0]) && signs.iter().all(|sign| *sign == signs[0]) {
        return signs[0];
    }
    let apart = |sign: Option<i8>| matches!(sign, Some(1 | -1));
    if left == 0 || !apart(signs[0]) || signs[0] != signs[d] {
        return None;
    }
    let middle = (low + high) / Rational::from(2);
    let first = sign_between(p, low, &middle, left - 1)?;
    (sign_between(p, &middle, high, left - 1)? == first).then_some(first)
}

/// p(x).
pub(super) fn value(p: &Coefficients, x: &Rational) -> RealCyclotomic {
    let x = RealCyclotomic::from(x.clone());
    p.iter().rev().fold(RealCyclotomic::zero(), |sum, c| sum.times(&x).plus(c))
}
