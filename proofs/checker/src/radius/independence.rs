//! Whether the shifts of the limit function of a mask are linearly independent. THEOREMS.md, 108.

use crate::decimal::{Q, int};
use crate::polynomial::{divide, gcd, trimmed};
use num_traits::{One, Zero};

/// Whether no z ≠ 0 is a common zero of the n parts of the symbol, and Φ_M(z^n)/Φ_M(z) divides it for no M >
/// 1 without a common divisor with n.
pub fn is_independent(symbol: &[Q], n: usize) -> bool {
    let start = symbol.iter().position(|a| !a.is_zero()).unwrap_or(0);
    let symbol = trimmed(symbol[start..].to_vec());
    let part = |e: usize| trimmed(symbol.iter().skip(e).step_by(n).cloned().collect());
    let common = (0..n).map(part).fold(Vec::new(), |common, part| {
        if part.is_empty() {
            common
        } else if common.is_empty() {
            part
        } else {
            gcd(&common, &part)
        }
    });
    let most = (symbol.len() - 1) / (n - 1);
    // φ(M) ≥ √(M/2).
    let cycle = |m: usize| {
        totient(m) <= most && divisor(m, n) == 1 && {
            let phi = cyclotomic(m);
            let mut stretched = vec![Q::zero(); (phi.len() - 1) * n + 1];
            for (i, c) in phi.iter().enumerate() {
                stretched[i * n] = c.clone();
            }
            let mut product = vec![Q::zero(); symbol.len() + phi.len() - 1];
            for (i, a) in symbol.iter().enumerate() {
                for (j, c) in phi.iter().enumerate() {
                    product[i + j] += a * c;
                }
            }
            product.len() >= stretched.len() && divide(product, &stretched).1.iter().all(Q::is_zero)
        }
    };
    common.len() == 1 && !(2..=2 * most * most).any(cycle)
}

fn divisor(a: usize, b: usize) -> usize {
    if b == 0 { a } else { divisor(b, a % b) }
}

/// φ(m), by the primes that divide m.
fn totient(m: usize) -> usize {
    let (mut rest, mut totient, mut p) = (m, m, 2);
    while p * p <= rest {
        if rest.is_multiple_of(p) {
            totient -= totient / p;
            while rest.is_multiple_of(p) {
                rest /= p;
            }
        }
        p += 1;
    }
    if rest > 1 { totient - totient / rest } else { totient }
}

/// Φ_m.
fn cyclotomic(m: usize) -> Vec<Q> {
    let mut whole = vec![Q::zero(); m + 1];
    (whole[0], whole[m]) = (int(-1), Q::one());
    let divisors = (1..m).filter(|d| m.is_multiple_of(*d));
    divisors.fold(whole, |rest, d| divide(rest, &cyclotomic(d)).0)
}
