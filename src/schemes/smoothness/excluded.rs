//! Parameters at which a product of matrices has too large an eigenvalue.

use super::parametric::{PolynomialMatrix, exterior_square, unit_determinants};
use crate::exact::{
    Interval, IntervalSet, PiecewisePolynomial, Rational, RationalPolynomial, RealAlgebraic,
};
use crate::joint::{MatrixSet, expands};
use std::collections::BTreeSet;
use std::ops::Bound;

/// The largest matrices of which the products of two eigenvalues are taken.
const MAX_SQUARED: usize = 4;

/// Where a product has a spectral radius of 1 or more, as far as that is looked at.
///
/// Of a short product of small matrices, everywhere: an eigenvalue crosses the unit circle at 1, at −1,
/// or with its conjugate, so only at zeros of the three determinants. At these the radius is 1 at least,
/// and between them one parameter decides. Of others, where a determinant is negative.
pub(super) fn excluded(
    word: &[usize],
    product: &PolynomialMatrix,
    set_at: impl Fn(&Rational) -> Option<MatrixSet>,
) -> IntervalSet {
    let mut determinants = unit_determinants(product).to_vec();
    if product.len() > MAX_SQUARED || word.len() > 2 {
        let reached = |p| PiecewisePolynomial::from(p).at_most(&Rational::zero());
        let sets = determinants.into_iter().map(reached);
        return sets.fold(IntervalSet::default(), |union, set| union.union(&set));
    }
    let [of_pairs, _] = unit_determinants(&exterior_square(product));
    determinants.push(of_pairs);
    if determinants.iter().any(RationalPolynomial::is_zero) {
        return IntervalSet::everything();
    }
    let roots = determinants.iter().flat_map(|p| RealAlgebraic::roots_of(p.numerator()));
    let roots: Vec<RealAlgebraic> = roots.collect::<BTreeSet<_>>().into_iter().collect();
    let points = roots.iter().map(|root| (included(root), included(root)));
    let mut sets: Vec<(Bound<RealAlgebraic>, Bound<RealAlgebraic>)> = points.collect();
    for (i, value) in RealAlgebraic::rationals_between(&roots).iter().enumerate() {
        if set_at(value).is_some_and(|set| expands(&set, word)) {
            let low = i.checked_sub(1).map_or(Bound::Unbounded, |i| included(&roots[i]));
            sets.push((low, roots.get(i).map_or(Bound::Unbounded, included)));
        }
    }
    let sets = sets.into_iter().map(|(low, high)| IntervalSet::from(Interval { low, high }));
    sets.fold(IntervalSet::default(), |union, set| union.union(&set))
}

/// Words of up to four letters, as long as there are few, one of each set of rotations.
pub(super) fn first_words(letters: usize) -> Vec<Vec<usize>> {
    let longest = match letters {
        2 => 4,
        3 => 3,
        4..=6 => 2,
        _ => 1,
    };
    let (mut all, mut level) = (Vec::new(), vec![Vec::new()]);
    for _ in 0..longest {
        let longer = |word: &Vec<usize>| (0..letters).map(|i| [&word[..], &[i]].concat()).collect();
        let next: Vec<Vec<usize>> = level.iter().flat_map::<Vec<_>, _>(longer).collect();
        let first = |word: &&Vec<usize>| {
            (1..word.len()).all(|i| [&word[i..], &word[..i]].concat() > **word)
        };
        all.extend(next.iter().filter(first).cloned());
        level = next;
    }
    all
}

/// This number as an end that belongs to an interval.
pub(super) fn included(place: &RealAlgebraic) -> Bound<RealAlgebraic> {
    Bound::Included(place.clone())
}
