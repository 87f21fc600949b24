//! The masks of box splines.

use super::dilation::{Dilation, Point};
use crate::exact::{Rational, Scalar as _};
use crate::formula::{Laurent, Value as _};

/// The symbol of the box spline with these directions: m·Π_ξ (1 − z^{Mξ})/(c_ξ(1 − z^{η})), where Mξ = c_ξη and η runs over the directions too.
///
/// For M = nI it is η = ξ and c = n. From φ̂(ω) = Π_ξ (1 − e^{−iξω})/(iξω) follows φ̂(Mᵀω) = A(e^{−iω})/m·φ̂(ω).
///
/// `None` where M takes the directions to no multiples of directions, one each.
pub(super) fn symbol(
    directions: &[Point],
    dilation: &Dilation,
) -> Option<Laurent<Rational, Point>> {
    let classes = Rational::from(dilation.class_count());
    let mut product = Laurent::constant(classes);
    for (other, count) in paired(directions, dilation)? {
        // (1 − z^{cη})/(1 − z^η) = 1 + z^η + … + z^{(c−1)η}; for c < 0 it is −(z^{−η} + … + z^{cη}).
        let (powers, size) = if count > 0 { (0..count, count) } else { (count..0, -count) };
        let weight = Rational::new(1, size);
        let terms = powers.map(|k| (other.map(|x| k * x), weight.clone()));
        product = product.times(&Laurent::of(terms.collect::<Vec<_>>()));
        if product.size() > MAX_BITS {
            return None;
        }
    }
    Some(product)
}

/// For each direction ξ another η, each once, and c with Mξ = cη. The product is the same for all ways to pair them.
fn paired(directions: &[Point], dilation: &Dilation) -> Option<Vec<(Point, i64)>> {
    let factor = |i: usize, j: usize| ratio(dilation.times(directions[i]), directions[j]);
    // Which ξ has the j-th η.
    let mut taken: Vec<Option<usize>> = vec![None; directions.len()];
    for i in 0..directions.len() {
        let mut seen = vec![false; directions.len()];
        if !finds(i, &mut taken, &mut seen, &factor) {
            return None;
        }
    }
    let pair = |(j, i): (usize, &Option<usize>)| Some((directions[j], factor((*i)?, j)?));
    taken.iter().enumerate().map(pair).collect()
}

/// Finds an η for the i-th ξ, for which others may move to another.
fn finds(
    i: usize,
    taken: &mut [Option<usize>],
    seen: &mut [bool],
    factor: &dyn Fn(usize, usize) -> Option<i64>,
) -> bool {
    for j in 0..taken.len() {
        if factor(i, j).is_none() || std::mem::replace(&mut seen[j], true) {
            continue;
        }
        let free = match taken[j] {
            None => true,
            Some(other) => finds(other, taken, seen, factor),
        };
        if free {
            taken[j] = Some(i);
            return true;
        }
    }
    false
}

/// The most bits of a symbol.
const MAX_BITS: u64 = 1 << 20;

/// c with a = cb, a ≠ 0, if there is such an integer.
fn ratio(a: Point, b: Point) -> Option<i64> {
    let axis = b.iter().position(|x| *x != 0)?;
    let factor = a[axis].checked_div(b[axis])?;
    (factor != 0 && b.map(|x| factor * x) == a).then_some(factor)
}
