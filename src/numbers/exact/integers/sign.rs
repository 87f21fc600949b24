//! The sign of a polynomial in t and h = cos(π/t) for all integers t from one on (`proofs/THEOREMS.md`, 145).

use crate::exact::{Integer, Polynomial, Rational, RationalPolynomial, common_denominator};
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
const MAX_DEGREE: usize = 200;

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
    if 2 * sums.len() + degree > MAX_DEGREE {
        return None;
    }
    // A positive multiple of p has integers as coefficients.
    let all: Vec<Rational> = sums.iter().flat_map(RationalPolynomial::coefficients).collect();
    let denominator = Rational::from(common_denominator(&all));
    let whole = |c: &Rational| (c * &denominator).numerator();
    let sums = sums.iter().map(|sum| sum.coefficients().iter().map(whole).collect());
    let sums: Vec<Vec<Integer>> = sums.collect();
    let (low, width) = distance(first, sums.len() > 1);
    let powers = shifted(in_distance(&sums, &low), &Integer::from(first));
    let bounds: Vec<[Integer; 2]> = powers.iter().map(|r| bounds_of(r, &width)).collect();
    let [constant, ..] = &bounds[..] else { return None };
    if constant[0].sign() > 0 && bounds.iter().all(|[low, _]| low.sign() >= 0) {
        return Some(Ordering::Greater);
    }
    if constant[1].sign() < 0 && bounds.iter().all(|[_, high]| high.sign() <= 0) {
        return Some(Ordering::Less);
    }
    None
}

/// The denominator of the bounds of u.
const PARTS: i64 = 1 << 12;

/// Integers a and w so that a ≤ 4096u ≤ a + w for all u = t²(1 − h), t ≥ `first`; 0 where there is no h.
fn distance(first: i64, has_cosine: bool) -> (Integer, Integer) {
    if !has_cosine {
        return (Integer::zero(), Integer::zero());
    }
    let [low, high] = pi();
    let first = Rational::from(first);
    let fourth = high.pow(4) / (Rational::from(24) * &first * &first);
    let parts = Rational::from(PARTS);
    let least = ((low.pow(2) / Rational::from(2) - fourth) * &parts).floor();
    let most = (high.pow(2) / Rational::from(2) * &parts).ceil();
    (least.clone(), most - least)
}

/// For each power t^k, the coefficients of the powers of v = 4096u − a in (4096t²)^J Σ_{j≤J} c_j(t)(1 − u/t²)^j.
fn in_distance(sums: &[Vec<Integer>], low: &Integer) -> Vec<Vec<Integer>> {
    let most = sums.len().saturating_sub(1);
    let degree = sums.iter().map(Vec::len).max().unwrap_or(0);
    let parts = Integer::from(PARTS);
    let mut found = vec![vec![Integer::zero(); most + 1]; 2 * most + degree + 1];
    // (4096t² − a − v)^j, as powers of t² and of v.
    let mut power = vec![vec![Integer::one()]];
    for (j, sum) in sums.iter().enumerate() {
        if j > 0 {
            power = raised(&power, &parts, low);
        }
        let rest = most - j;
        let scale = parts.pow(u32::try_from(rest).unwrap_or(u32::MAX));
        for (half, row) in power.iter().enumerate() {
            for (l, c) in row.iter().enumerate() {
                let c = c * &scale;
                for (i, coefficient) in sum.iter().enumerate() {
                    found[i + 2 * (rest + half)][l].add_product(&c, coefficient);
                }
            }
        }
    }
    found
}

/// A polynomial in t² and v, times 4096t² − a − v.
fn raised(power: &[Vec<Integer>], parts: &Integer, low: &Integer) -> Vec<Vec<Integer>> {
    let size = power.len() + 1;
    let mut found = vec![vec![Integer::zero(); size]; size];
    let (minus_low, minus_one) = (-low.clone(), Integer::from(-1));
    for (half, row) in power.iter().enumerate() {
        for (l, c) in row.iter().enumerate() {
            found[half + 1][l].add_product(c, parts);
            found[half][l].add_product(c, &minus_low);
            found[half][l + 1].add_product(c, &minus_one);
        }
    }
    found
}

/// The r_k with Σ q_k t^k = Σ r_k (t − b)^k.
fn shifted(mut powers: Vec<Vec<Integer>>, b: &Integer) -> Vec<Vec<Integer>> {
    for first in 0..powers.len() {
        for k in (first..powers.len() - 1).rev() {
            let (lower, higher) = powers.split_at_mut(k + 1);
            for (c, next) in lower[k].iter_mut().zip(&higher[0]) {
                c.add_product(next, b);
            }
        }
    }
    powers
}

/// Bounds of a polynomial in v, 0 ≤ v ≤ w.
fn bounds_of(r: &[Integer], width: &Integer) -> [Integer; 2] {
    let mut bounds = [Integer::zero(), Integer::zero()];
    let mut power = Integer::one();
    for (k, c) in r.iter().enumerate() {
        let term = c * &power;
        match k {
            0 => bounds = [term.clone(), term],
            _ if term.sign() > 0 => bounds[1] += &term,
            _ => bounds[0] += &term,
        }
        power = &power * width;
    }
    bounds
}
