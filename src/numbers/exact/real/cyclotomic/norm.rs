//! Norms and inverses, modulo primes.

use super::field::Field;
use super::symmetric::product;
use crate::exact::Integer;
use crate::stop::check;
use std::sync::LazyLock;

/// (A, N) with f·A = N for f ≠ 0 in `Z[θ]`. N is the norm of f. A is the product of the
/// other conjugates of f, and lies in `Z[θ]` too.
///
/// Modulo a prime p, N is the resultant of Ψ_n and f, and A = N/f in `F_p[y]`/Ψ_n; both
/// come from one run of the Euclidean algorithm. The Chinese remainder theorem combines
/// the results of several primes until a further prime changes nothing. Then f·A = N is
/// checked, so the answer is right whichever primes were used.
pub(super) fn cofactor(field: &Field, f: &[Integer]) -> (Vec<Integer>, Integer) {
    let mut modulus = Integer::one();
    // The coefficients of A, followed by N.
    let mut lifted = vec![Integer::zero(); field.degree() + 1];
    for p in primes() {
        let residues: Vec<u64> = f.iter().map(|a| u64::from(a.residue(p))).collect();
        let Some(images) = cofactor_modulo(field, residues, u64::from(p)) else { continue };
        let inverse = power(u64::from(modulus.residue(p)), u64::from(p) - 2, u64::from(p));
        let mut stable = true;
        for (value, image) in lifted.iter_mut().zip(images) {
            let p = u64::from(p);
            let step = (image + p - u64::from(value.residue(narrow(p)))) * inverse % p;
            if step == 0 {
                continue;
            }
            stable = false;
            // The residue of least absolute value, so that negative numbers become stable
            // too.
            let step = Integer::from(step);
            let step =
                if &step + &step > Integer::from(p) { step - Integer::from(p) } else { step };
            *value += &(&modulus * step);
        }
        modulus *= Integer::from(p);
        if stable {
            let (norm, a) = lifted.split_last().expect("N is there");
            let product = field.multiply(f, a);
            if product[0] == *norm && product[1..].iter().all(Integer::is_zero) {
                return (a.to_vec(), norm.clone());
            }
        }
    }
    unreachable!("there are 10^8 primes of 31 bits, and N has fewer digits")
}

fn narrow(p: u64) -> u32 {
    u32::try_from(p).expect("a prime of 31 bits")
}

/// The coefficients of A modulo p, followed by N modulo p. `None` when p divides N.
fn cofactor_modulo(field: &Field, mut f: Vec<u64>, p: u64) -> Option<Vec<u64>> {
    let mut psi = vec![0; field.degree() + 1];
    psi[field.degree()] = 1;
    for &(k, a) in field.relation() {
        psi[k] = a.rem_euclid(p.cast_signed()).cast_unsigned();
    }
    trim(&mut f);
    // Invariants: r_i = s_i f modulo Ψ, and res(Ψ, f) = norm·res(r_0, r_1).
    let (mut r0, mut r1) = (psi, f);
    let (mut s0, mut s1) = (vec![0; field.degree() + 1], vec![0; field.degree() + 1]);
    s1[0] = 1;
    let mut norm = 1;
    while r1.len() > 1 {
        check();
        let (high, low) = (r0.len() - 1, r1.len() - 1);
        let leading = r1[low];
        let inverse = power(leading, p - 2, p);
        while r0.len() > low {
            let shift = r0.len() - 1 - low;
            let factor = r0[r0.len() - 1] * inverse % p;
            subtract(&mut r0, factor, shift, &r1, p);
            subtract(&mut s0, factor, shift, &s1[..field.degree() - shift], p);
            trim(&mut r0);
        }
        if high * low % 2 == 1 {
            norm = p - norm;
        }
        let rest = r0.len().checked_sub(1)?;
        norm = norm * power(leading, (high - rest) as u64, p) % p;
        std::mem::swap(&mut r0, &mut r1);
        std::mem::swap(&mut s0, &mut s1);
    }
    let &constant = r1.first()?;
    norm = norm * power(constant, (r0.len() - 1) as u64, p) % p;
    let scale = norm * power(constant, p - 2, p) % p;
    let mut images: Vec<u64> = s1[..field.degree()].iter().map(|s| s * scale % p).collect();
    images.push(norm);
    Some(images)
}

/// target −= factor·C_shift·source modulo p.
fn subtract(target: &mut [u64], factor: u64, shift: usize, source: &[u64], p: u64) {
    let factor = p - factor;
    for (j, &value) in source.iter().enumerate().filter(|(_, value)| **value != 0) {
        let value = factor * value % p;
        let (first, second, times) = product(shift, j);
        target[first] = (target[first] + value) % p;
        target[second] = (target[second] + u64::from(times) * value) % p;
    }
}

/// Removes the leading zeros, those of the highest degrees.
fn trim(coefficients: &mut Vec<u64>) {
    let length = coefficients.iter().rposition(|&c| c != 0).map_or(0, |last| last + 1);
    coefficients.truncate(length);
}

/// base^exponent modulo p < 2^31.
fn power(mut base: u64, mut exponent: u64, p: u64) -> u64 {
    let mut result = 1;
    base %= p;
    while exponent > 0 {
        if exponent % 2 == 1 {
            result = result * base % p;
        }
        base = base * base % p;
        exponent /= 2;
    }
    result
}

/// The first of the primes: most norms need no others.
static FIRST: LazyLock<Vec<u32>> = LazyLock::new(|| primes_below(1 << 31).take(64).collect());

/// The primes below 2^31, in decreasing order.
pub fn primes() -> impl Iterator<Item = u32> {
    let later = std::iter::once_with(|| primes_below(FIRST[FIRST.len() - 1])).flatten();
    FIRST.iter().copied().chain(later)
}

/// The odd primes below a bound, which is even or such a prime, in decreasing order.
fn primes_below(bound: u32) -> impl Iterator<Item = u32> {
    let last = bound - 1 - bound % 2;
    (0..=last).rev().step_by(2).filter(|&candidate| is_prime(candidate))
}

/// Whether n is prime, for odd n with 61 < n < 2^32. In this range every strong probable
/// prime to the bases 2, 7 and 61 is a prime (Jaeschke 1993).
#[must_use]
pub fn is_prime(n: u32) -> bool {
    let n = u64::from(n);
    let twos = (n - 1).trailing_zeros();
    [2, 7, 61].into_iter().all(|base| {
        let mut x = power(base, (n - 1) >> twos, n);
        if x == 1 {
            return true;
        }
        for _ in 0..twos {
            if x == n - 1 {
                return true;
            }
            x = x * x % n;
        }
        false
    })
}
