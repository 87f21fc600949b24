//! The sign of a polynomial in t and h = cos(π/t) for all integers t from one on (`proofs/THEOREMS.md`, 145).

use crate::exact::{Polynomial, Rational, RationalPolynomial};
use std::cmp::Ordering;

/// The name of t.
pub(super) const INDEX: &str = "t";

/// The name of h = cos(π/t).
pub(super) const COSINE: &str = "h";

/// The name of an integer d of which only [`NEAR`] < d < t − [`NEAR`] is known.
pub(super) const PLACE: &str = "d";

/// The name of cos(2πd/t).
pub(super) const TURN: &str = "g";

/// The name of a number of which nothing is known.
pub(super) const FREE: &str = "x";

/// How far from 0 and from t the integer d is.
pub(super) const NEAR: i64 = 6;

/// The highest degree of a polynomial whose sign is looked for.
const MAX_DEGREE: usize = 400;

/// Bounds of π.
fn pi() -> [Rational; 2] {
    [314_159_265, 314_159_266].map(|n| Rational::new(n, 100_000_000))
}

/// The sign of p for all integers t ≥ `first`, if it is one and is found.
pub(super) fn sign_from(p: &Polynomial, first: i64) -> Option<Ordering> {
    if let Some(constant) = p.as_constant() {
        return Some(constant.as_rational()?.sign().cmp(&0));
    }
    let place = p.by_powers(PLACE);
    if let [at_zero, slope] = &place[..] {
        // It is linear in d, and takes its greatest and its least value at the ends.
        let slope = Polynomial::constant(slope.as_constant()?);
        let near = Polynomial::constant(NEAR + 1);
        let far = &Polynomial::variable(INDEX) - &near;
        let [low, high] = [near, far].map(|d| sign_from(&(at_zero + &(&slope * &d)), first));
        let (low, high) = (low?, high?);
        return (low == high && low.is_ne()).then_some(low);
    }
    let mut sums = Vec::new();
    for coefficient in p.by_powers(COSINE) {
        sums.push(coefficient.in_variable(INDEX)?);
    }
    let degree = sums.iter().filter_map(RationalPolynomial::degree).max().unwrap_or(0);
    if sums.len() + degree > MAX_DEGREE {
        return None;
    }
    let least = Rational::from(first);
    let coefficients = shifted(&in_distance(&sums), &least);
    let ends = distance(&least, sums.len() > 1);
    let bounds: Vec<[Rational; 2]> = coefficients.iter().map(|r| bounds_of(r, &ends)).collect();
    let [constant, ..] = &bounds[..] else { return None };
    let zero = Rational::zero();
    if constant[0] > zero && bounds.iter().all(|[low, _]| *low >= zero) {
        return Some(Ordering::Greater);
    }
    if constant[1] < zero && bounds.iter().all(|[_, high]| *high <= zero) {
        return Some(Ordering::Less);
    }
    None
}

/// An interval with all u = t²(1 − h), t ≥ `first`; 0 where there is no h.
fn distance(first: &Rational, has_cosine: bool) -> [Rational; 2] {
    if !has_cosine {
        return [Rational::zero(), Rational::zero()];
    }
    let [low, high] = pi();
    let fourth = high.pow(4) / (Rational::from(24) * first * first);
    [low.pow(2) / Rational::from(2) - fourth, high.pow(2) / Rational::from(2)]
}

/// The polynomials q_k(u) with Σ_k q_k(u)t^k = t^{2J} Σ_{j≤J} c_j(t)(1 − u/t²)^j.
fn in_distance(sums: &[RationalPolynomial]) -> Vec<RationalPolynomial> {
    let most = sums.len().saturating_sub(1);
    let degree = sums.iter().filter_map(RationalPolynomial::degree).max().unwrap_or(0);
    let mut powers = vec![vec![Rational::zero(); most + 1]; 2 * most + degree + 1];
    for (j, sum) in sums.iter().enumerate() {
        // t^{2(J−j)}(t² − u)^j, and C(j, l) by its neighbour.
        let mut binomial = Rational::one();
        for l in 0..=j {
            for (i, c) in sum.coefficients().iter().enumerate() {
                let sign = Rational::from(if l % 2 == 0 { 1 } else { -1 });
                powers[i + 2 * (most - l)][l] += &(c * &binomial * sign);
            }
            binomial *= Rational::new(j - l, l + 1);
        }
    }
    powers.iter().map(|power| RationalPolynomial::new(power)).collect()
}

/// The r_k with Σ q_k t^k = Σ r_k (t − b)^k.
fn shifted(powers: &[RationalPolynomial], b: &Rational) -> Vec<RationalPolynomial> {
    let mut found = powers.to_vec();
    let b = RationalPolynomial::constant(b.clone());
    for first in 0..found.len() {
        for k in (first..found.len() - 1).rev() {
            found[k] = found[k].plus(&found[k + 1].times(&b));
        }
    }
    found
}

/// Bounds of a polynomial on an interval, by powers of the distance to its lower end.
fn bounds_of(r: &RationalPolynomial, [low, high]: &[Rational; 2]) -> [Rational; 2] {
    let numbers: Vec<RationalPolynomial> =
        r.coefficients().into_iter().map(RationalPolynomial::constant).collect();
    let mut bounds = [Rational::zero(), Rational::zero()];
    let mut power = Rational::one();
    for (k, c) in shifted(&numbers, low).iter().enumerate() {
        let term = &c.as_constant().unwrap_or_else(Rational::zero) * &power;
        match k {
            0 => bounds = [term.clone(), term],
            _ if term.sign() > 0 => bounds[1] += &term,
            _ => bounds[0] += &term,
        }
        power *= high - low;
    }
    bounds
}
