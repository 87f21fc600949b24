//! Parameters at which a product of matrices has too large an eigenvalue.

use super::parametric::PolynomialMatrix;
use crate::exact::{
    Integer, Interval, IntervalSet, PiecewisePolynomial, Rational, RationalPolynomial,
    RealAlgebraic, Scalar, characteristic_coefficients,
};
use std::collections::BTreeSet;
use std::ops::Bound;

/// The greatest degree in the parameter of a determinant of pairs of eigenvalues.
const MAX_PAIR_DEGREE: usize = 64;

/// Where a product has a spectral radius of 1 or more, as far as that is looked at; `degree` is the greatest of
/// its entries.
///
/// Where the determinant of pairs is of a low degree, everywhere: an eigenvalue crosses the unit circle at 1, at
/// −1, or with its conjugate, so only at zeros of the three determinants. At these the radius is 1 at least, and
/// between them one parameter decides. Of others, where a determinant is not positive, or a coefficient of the
/// characteristic polynomial too large. `proofs/THEOREMS.md`, 112 (a) and 122 (b).
pub(super) fn excluded(product: &PolynomialMatrix, degree: usize) -> IntervalSet {
    let size = product.len();
    let coefficients = characteristic_coefficients(product);
    if size * size.saturating_sub(1) * degree > MAX_PAIR_DEGREE {
        let reached = |p| PiecewisePolynomial::from(p).at_most(&Rational::zero());
        let sets = excluding(&coefficients).into_iter().map(reached);
        return sets.fold(IntervalSet::default(), |union, set| union.union(&set));
    }
    let [at_one, at_minus_one] = at_units(&coefficients);
    let determinants = [at_one, at_minus_one, of_pairs(&coefficients)];
    if determinants.iter().any(RationalPolynomial::is_zero) {
        return IntervalSet::everything();
    }
    let roots = determinants.iter().flat_map(|p| RealAlgebraic::roots_of(p.numerator()));
    let roots: Vec<RealAlgebraic> = roots.collect::<BTreeSet<_>>().into_iter().collect();
    let points = roots.iter().map(|root| (included(root), included(root)));
    let mut sets: Vec<(Bound<RealAlgebraic>, Bound<RealAlgebraic>)> = points.collect();
    for (i, value) in RealAlgebraic::rationals_between(&roots).iter().enumerate() {
        let there = coefficients.iter().map(|c| c.value_at(value)).collect();
        if !is_stable(there) {
            let low = i.checked_sub(1).map_or(Bound::Unbounded, |i| included(&roots[i]));
            sets.push((low, roots.get(i).map_or(Bound::Unbounded, included)));
        }
    }
    let sets = sets.into_iter().map(|(low, high)| IntervalSet::from(Interval { low, high }));
    sets.fold(IntervalSet::default(), |union, set| union.union(&set))
}

/// Polynomials of which one is at most 0 only where a matrix has an eigenvalue of 1 or more in absolute value:
/// det(I ∓ P), and C(d, k) ∓ c_k for the coefficients c_k of the characteristic polynomial, which are sums of
/// C(d, k) products of eigenvalues. `coefficients` are c_d, …, c_1, 1.
pub(in crate::smoothness) fn excluding<P: Scalar + PartialEq>(coefficients: &[P]) -> Vec<P> {
    let size = coefficients.len() - 1;
    let small = |x| u32::try_from(x).expect("a small matrix");
    let mut found = at_units(coefficients).to_vec();
    for k in 1..=size {
        let count = Rational::from(Integer::binomial(small(size), small(k)));
        let most = P::from_rational(&count);
        found.push(most.minus(&coefficients[size - k]));
        found.push(most.plus(&coefficients[size - k]));
    }
    found
}

/// det(I − P) and det(I + P): Σc_k and Σ(−1)^k c_k.
fn at_units<P: Scalar + PartialEq>(coefficients: &[P]) -> [P; 2] {
    let zero = [P::zero(), P::zero()];
    coefficients.iter().rev().enumerate().fold(zero, |[one, other], (k, c)| {
        let sum = if k.is_multiple_of(2) { other.plus(c) } else { other.minus(c) };
        [one.plus(c), sum]
    })
}

/// Π(1 − λ_i λ_j), i < j, over the eigenvalues, from the coefficients c_d, …, c_1, 1 of the characteristic
/// polynomial: det(X − Y) of size d − 1 with X_{ij} = c_{j−i} and Y_{ij} = c_{2d−2−i−j}, i and j from 0 on, where
/// c_k = 0 for k < 0 and for k > d (E. I. Jury, Theory and Application of the z-Transform Method, 1964).
fn of_pairs(coefficients: &[RationalPolynomial]) -> RationalPolynomial {
    let d = coefficients.len() - 1;
    let zero = RationalPolynomial::constant(Rational::zero());
    let c = |k: Option<usize>| {
        let place = k.and_then(|k| d.checked_sub(k));
        place.map_or(zero.clone(), |place| coefficients[place].clone())
    };
    let size = d.saturating_sub(1);
    let entry = |i: usize, j: usize| c(j.checked_sub(i)).minus(&c((2 * d - 2).checked_sub(i + j)));
    let rows: PolynomialMatrix =
        (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect();
    let last = characteristic_coefficients(&rows).swap_remove(0);
    // The constant term is det(−(X − Y)).
    if size.is_multiple_of(2) { last } else { last.negated() }
}

/// Whether all roots of p = Σ p_i x^i, p_d ≠ 0, are less than 1 in absolute value, by the recursion of Schur and
/// Cohn: this is so if and only if |p_0| < |p_d|, and it is so for (p − (p_0/p_d)·x^d p(1/x))/x.
fn is_stable(mut p: Vec<Rational>) -> bool {
    while p.len() > 1 {
        let (first, last) = (p[0].clone(), p[p.len() - 1].clone());
        if first.abs() >= last.abs() {
            return false;
        }
        let reversed: Vec<Rational> = p.iter().rev().cloned().collect();
        let next = p.iter().zip(&reversed).skip(1).map(|(x, y)| x - y * &first / &last);
        p = next.collect();
    }
    true
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
