//! Polynomials over the integers modulo a prime p < 2^31, and their factors.

use crate::stop::check;

/// The coefficients c_0, c_1, …, c_d with c_d ≠ 0; none for 0.
pub(super) type Modular = Vec<u64>;

fn trimmed(mut f: Modular) -> Modular {
    while f.last() == Some(&0) {
        f.pop();
    }
    f
}

fn power(mut base: u64, mut exponent: u64, p: u64) -> u64 {
    let mut result = 1;
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = result * base % p;
        }
        base = base * base % p;
        exponent >>= 1;
    }
    result
}

pub(super) fn inverse(a: u64, p: u64) -> u64 {
    power(a, p - 2, p)
}

pub(super) fn scaled(f: &[u64], factor: u64, p: u64) -> Modular {
    trimmed(f.iter().map(|c| c * factor % p).collect())
}

pub(super) fn monic(f: &[u64], p: u64) -> Modular {
    f.last().map_or_else(Vec::new, |leading| scaled(f, inverse(*leading, p), p))
}

fn minus(f: &[u64], g: &[u64], p: u64) -> Modular {
    let at = |f: &[u64], i: usize| f.get(i).copied().unwrap_or(0);
    trimmed((0..f.len().max(g.len())).map(|i| (at(f, i) + p - at(g, i)) % p).collect())
}

pub(super) fn times(f: &[u64], g: &[u64], p: u64) -> Modular {
    let mut product = vec![0; f.len() + g.len()];
    for (i, a) in f.iter().enumerate() {
        for (j, b) in g.iter().enumerate() {
            product[i + j] = (product[i + j] + a * b) % p;
        }
    }
    trimmed(product)
}

/// Quotient and remainder by a monic g.
fn divided(f: &[u64], g: &[u64], p: u64) -> (Modular, Modular) {
    check();
    let mut rest = f.to_vec();
    let lower = &g[..g.len() - 1];
    let mut quotient = vec![0; (rest.len() + 1).saturating_sub(g.len())];
    for shift in (0..quotient.len()).rev() {
        let top = rest.pop().unwrap_or(0);
        quotient[shift] = top;
        for (c, g) in rest[shift..].iter_mut().zip(lower) {
            *c = (*c + (p - top) * g) % p;
        }
    }
    (trimmed(quotient), trimmed(rest))
}

pub(super) fn remainder(f: &[u64], g: &[u64], p: u64) -> Modular {
    divided(f, g, p).1
}

fn gcd(f: &[u64], g: &[u64], p: u64) -> Modular {
    let (mut a, mut b) = (monic(f, p), monic(g, p));
    while !b.is_empty() {
        let rest = monic(&remainder(&a, &b, p), p);
        (a, b) = (b, rest);
    }
    a
}

/// s with s·f ≡ 1 mod the monic g, for coprime f and g.
pub(super) fn inverse_mod(f: &[u64], g: &[u64], p: u64) -> Modular {
    // Euclid's algorithm with the invariants a ≡ x·f and b ≡ y·f mod g, where a and b are
    // monic.
    let (mut a, mut x) = (g.to_vec(), Vec::new());
    let first = remainder(f, g, p);
    let unit = first.last().map_or(1, |leading| inverse(*leading, p));
    let (mut b, mut y) = (scaled(&first, unit, p), vec![unit]);
    while b.len() > 1 {
        let (quotient, rest) = divided(&a, &b, p);
        let next = minus(&x, &times(&quotient, &y, p), p);
        let unit = rest.last().map_or(1, |leading| inverse(*leading, p));
        (a, b, x, y) = (b, scaled(&rest, unit, p), y, scaled(&next, unit, p));
    }
    debug_assert!(!a.is_empty());
    remainder(&y, g, p)
}

pub(super) fn is_square_free(f: &[u64], p: u64) -> bool {
    let derivative = (0_u64..).zip(f).skip(1).map(|(i, c)| i % p * c % p).collect();
    are_coprime(f.to_vec(), derivative, p)
}

/// Whether f and g have no common root, by Euclid's algorithm without inverses: b_m·a − a_n·x^(n−m)·b takes the place
/// of the longer one, a.
fn are_coprime(f: Modular, g: Modular, p: u64) -> bool {
    let (mut a, mut b) = (trimmed(f), trimmed(g));
    loop {
        check();
        if a.len() < b.len() {
            std::mem::swap(&mut a, &mut b);
        }
        let (Some(&a_n), Some(&b_m)) = (a.last(), b.last()) else { return a.len() == 1 };
        if b.len() == 1 {
            return true;
        }
        let shift = a.len() - b.len();
        for c in &mut a {
            *c = *c * b_m % p;
        }
        for (c, d) in a[shift..].iter_mut().zip(&b) {
            *c = (*c + (p - a_n) * d) % p;
        }
        a = trimmed(a);
    }
}

/// f^exponent mod the monic g.
fn power_mod(f: &[u64], mut exponent: u64, g: &[u64], p: u64) -> Modular {
    let mut base = remainder(f, g, p);
    let mut result = remainder(&[1], g, p);
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = remainder(&times(&result, &base, p), g, p);
        }
        base = remainder(&times(&base, &base, p), g, p);
        exponent >>= 1;
    }
    result
}

/// The monic irreducible factors of a monic square-free f over the odd prime p
/// (Cantor and Zassenhaus 1981).
pub(super) fn factors(f: &[u64], p: u64) -> Vec<Modular> {
    let mut found = Vec::new();
    let mut rest = f.to_vec();
    // x^(p^d) mod `rest`, for the degree d.
    let mut frobenius = vec![0, 1];
    for degree in 1.. {
        if rest.len() - 1 < 2 * degree {
            break;
        }
        frobenius = power_mod(&frobenius, p, &rest, p);
        let product = gcd(&rest, &minus(&frobenius, &[0, 1], p), p);
        if product.len() > 1 {
            rest = divided(&rest, &product, p).0;
            frobenius = remainder(&frobenius, &rest, p);
            split(product, degree, p, &mut found);
        }
    }
    if rest.len() > 1 {
        found.push(rest);
    }
    found
}

/// Appends to `found` the irreducible factors of `product`, which all have the degree
/// `degree`.
fn split(product: Modular, degree: usize, p: u64, found: &mut Vec<Modular>) {
    let mut seed = 1_u64;
    let mut stack = vec![product];
    while let Some(f) = stack.pop() {
        if f.len() - 1 == degree {
            found.push(f);
            continue;
        }
        // Any sequence of trial elements works. Each one splits f with a probability of
        // about one half.
        let trial: Modular = (0..f.len() - 1)
            .map(|_| {
                seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                (seed >> 33) % p
            })
            .collect();
        // trial^((p^d − 1)/2), from the product of the powers trial^(p^i), i < d.
        let (mut conjugate, mut norm) = (trimmed(trial), vec![1]);
        for _ in 0..degree {
            norm = remainder(&times(&norm, &conjugate, p), &f, p);
            conjugate = power_mod(&conjugate, p, &f, p);
        }
        let root = power_mod(&norm, (p - 1) / 2, &f, p);
        let part = gcd(&f, &minus(&root, &[1], p), p);
        if part.len() > 1 && part.len() < f.len() {
            stack.push(divided(&f, &part, p).0);
            stack.push(part);
        } else {
            stack.push(f);
        }
    }
}
