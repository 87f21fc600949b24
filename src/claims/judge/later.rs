//! Bounds of the distance at a level by the bound of a later level.

use crate::bound::{Constants, Operator, Order, SoundBound};
use crate::exact::Rational;
use crate::finding::Later;
use crate::limit::greatest_change;
use crate::scheme::{Axes, Rules};

/// The most coefficients of a product of sequences whose classes are computed one by one.
const MAX_LENGTH: u64 = 1 << 16;

/// Whether the product of c sequences is too long for computing every class.
pub(crate) fn is_long(rules: &Rules, c: u32) -> bool {
    let (n, width) = (rules.arity() as u64, rules.width() as u64);
    let last = |classes: u64| (n * width - 1).checked_mul((classes - 1) / (n - 1));
    n.checked_pow(c).and_then(last).is_none_or(|last| last >= MAX_LENGTH)
}

/// The first level l from `level` to `level` + `longest` for which the sum of the sound bound at l
/// and of `change(l)` is `small`. `change(l)` bounds the distance of the levels l and `level` from
/// each other.
pub(crate) fn later(
    bound: &SoundBound,
    level: u32,
    longest: u32,
    change: impl Fn(u32) -> Option<Rational>,
    small: impl Fn(&Rational) -> bool,
) -> Option<Later> {
    let levels = bound.constants().len() - 1;
    let mut sums = (level..=level.saturating_add(longest)).map_while(|later| {
        let (value, block) = bound.level(later)?;
        Some((value + change(later)?, Later { later, levels, block }))
    });
    sums.find(|(sum, _)| small(sum)).map(|(_, later)| later)
}

/// A bound of ‖P^l − P^k‖ for data of spread 1; of a net, of spread 1 along both indices.
///
/// Source: `proofs/THEOREMS.md`, 32, with level l in place of the limit.
pub(crate) fn change(
    axes: &Axes<&Constants>,
    offset: Option<i64>,
    k: u32,
    l: u32,
) -> Option<Rational> {
    if k == l {
        return Some(Rational::zero());
    }
    let of = |constants: &Constants| {
        let mask = constants.mask();
        greatest_change(&mask.with_offset(offset.unwrap_or(mask.offset())), k, l).ok()
    };
    // The checker computes every class.
    let norm = |constants: &Constants, level| {
        let few = !is_long(constants.mask().rules(), level);
        constants.norm(Operator::Scheme, level, Order::Adjoint).ok().filter(|_| few)
    };
    match axes {
        Axes::Curve(curve) => of(curve),
        Axes::Tensor(first, second) => {
            let (c, d) = (of(first)?, of(second)?);
            let one = &c * &norm(second, l)? + &d * &norm(first, k)?;
            let other = &d * &norm(first, l)? + &c * &norm(second, k)?;
            Some(one.min(other))
        }
    }
}
