//! Where polynomials in a parameter are positive, exactly.

use crate::exact::{
    Interval, IntervalSet, Rational, Real as _, RealAlgebraic, RealCyclotomic, RealExpression,
    Scalar as _,
};
use std::ops::Bound;

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

/// The numbers x with p(x) > 0; `None` where a root is out of reach.
pub(super) fn positive(p: &Coefficients) -> Option<IntervalSet> {
    let mut p = p.clone();
    while p.last().is_some_and(|c| c.sign() == 0) {
        p.pop();
    }
    if p.len() < 2 {
        let holds = p.first().is_some_and(|c| c.sign() > 0);
        return Some(if holds { IntervalSet::everything() } else { IntervalSet::default() });
    }
    let mut roots: Vec<RealAlgebraic> = Vec::new();
    while let Ok(root) = RealExpression::root(&p, roots.len() + 1) {
        roots.push(root.to_algebraic()?);
    }
    let between = RealAlgebraic::rationals_between(&roots);
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

/// p(x).
pub(super) fn value(p: &Coefficients, x: &Rational) -> RealCyclotomic {
    let x = RealCyclotomic::from(x.clone());
    p.iter().rev().fold(RealCyclotomic::zero(), |sum, c| sum.times(&x).plus(c))
}
