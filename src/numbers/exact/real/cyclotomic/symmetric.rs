//! Sums of C_k = x^k + x^(−k), and the cyclotomic polynomials among them.
//!
//! A symmetric Laurent polynomial a_0 + Σ_{k≥1} a_k C_k is stored as its coefficients
//! a_0, a_1, … With y = x + 1/x, C_k = 2T_k(y/2) is a monic polynomial of degree k in y,
//! where T_k is the Chebyshev polynomial. So the C_k are a basis of the polynomials in y.
//! In this basis the numbers in products, in reductions modulo Φ_n and in values stay
//! small.

use crate::exact::{Integer, IntegerPolynomial};

/// (first, second, times) with C_t·C_j = C_first + times·C_second, where C_0 stands for
/// 1.
pub(super) fn product(t: usize, j: usize) -> (usize, usize, u8) {
    match (t, j) {
        (0, k) | (k, 0) => (k, 0, 0),
        _ if t == j => (2 * t, 0, 2),
        _ => (t + j, t.abs_diff(j), 1),
    }
}

/// The prime divisors of n ≥ 1, in increasing order.
pub(super) fn prime_divisors(mut n: usize) -> Vec<usize> {
    let mut primes = Vec::new();
    let mut p = 2;
    while p * p <= n {
        if n.is_multiple_of(p) {
            primes.push(p);
            while n.is_multiple_of(p) {
                n /= p;
            }
        }
        p += 1;
    }
    if n > 1 {
        primes.push(n);
    }
    primes
}

/// Euler's φ(n).
pub(super) fn totient(n: usize) -> usize {
    prime_divisors(n).into_iter().fold(n, |phi, p| phi / p * (p - 1))
}

/// a_0, …, a_m with Φ_n(x) = x^m (a_0 + Σ_k a_k C_k), m = φ(n)/2, for n ≥ 3; a_m = 1.
///
/// Φ_n = Π_{d|n} (1 − x^d)^{μ(n/d)} as a power series, up to x^m. Intermediate sums may
/// wrap around. They are right modulo 2^64, and the coefficients of every cyclotomic
/// polynomial that fits in memory fit in 64 bits.
pub(super) fn cyclotomic(n: usize) -> Vec<i64> {
    let m = totient(n) / 2;
    let mut series = vec![0_i64; m + 1];
    series[0] = 1;
    // n/d runs through the products of distinct primes; the bits of `choice` select the
    // primes.
    let primes = prime_divisors(n);
    for choice in 0_usize..1 << primes.len() {
        let chosen = primes.iter().enumerate().filter(|(bit, _)| choice >> bit & 1 == 1);
        let d = chosen.fold(n, |d, (_, p)| d / p);
        if choice.count_ones() % 2 == 0 {
            for i in (d..=m).rev() {
                series[i] = series[i].wrapping_sub(series[i - d]);
            }
        } else {
            for i in d..=m {
                series[i] = series[i].wrapping_add(series[i - d]);
            }
        }
    }
    series.reverse();
    series
}

/// Ψ_n, the minimal polynomial of 2cos(2π/n) over the rationals, n ≥ 1. It is
/// monic with integer coefficients, of degree φ(n)/2 for n ≥ 3, and its roots are
/// 2cos(2πj/n) with gcd(j, n) = 1 (Lehmer 1933; Watkins and Zeitlin 1993).
///
/// Φ_n(x) = x^m Ψ_n(x + 1/x) with m = φ(n)/2. With Φ_n(x) = x^m (a_0 + Σ_k a_k C_k)
/// and C_k = S_k − S_{k−2}, where S_k(2cos t) = sin((k+1)t)/sin t, this gives
/// Ψ_n = Σ_k (a_k − a_{k+2}) S_k. The coefficients of S_k are binomial coefficients. Where few
/// of these S_k occur, they are added one by one, which takes a product and a quotient by a small
/// number for each; a prime n = 2m + 1 has two, Ψ_n = S_m + S_{m−1}. Otherwise Clenshaw's
/// recurrence b_k = y b_{k+1} − b_{k+2} + (a_k − a_{k+2}), Ψ_n = b_0, takes m²/2 additions.
///
/// # Panics
/// When n is 0.
///
/// ```
/// use subcert::exact::cosine_polynomial;
///
/// assert_eq!(cosine_polynomial(5).to_string(), "x^2 + x - 1");
/// assert_eq!(cosine_polynomial(7).to_string(), "x^3 + x^2 - 2x - 1");
/// assert_eq!(cosine_polynomial(148).degree(), Some(36));
/// ```
#[must_use]
pub fn cosine_polynomial(n: u32) -> IntegerPolynomial {
    match n {
        0 => panic!("there is no angle 2π/0"),
        1 => return IntegerPolynomial::from([-2, 1]),
        2 => return IntegerPolynomial::from([2, 1]),
        _ => {}
    }
    let a = cyclotomic(n as usize);
    let factors: Vec<i64> =
        a.iter().enumerate().map(|(k, a_k)| a_k - a.get(k + 2).unwrap_or(&0)).collect();
    let occurring = factors.iter().filter(|factor| **factor != 0).count();
    let few = occurring * ADDITIONS < factors.len();
    IntegerPolynomial::new(if few { one_by_one(&factors) } else { by_clenshaw(&factors) })
}

/// So many additions take about as long as a product and a quotient by a small number.
const ADDITIONS: usize = 12;

/// Σ_k f_k S_k from S_k = Σ_j (−1)^j C(k−j, j) y^{k−2j}, where C(k−j−1, j+1) =
/// C(k−j, j)·(k−2j)(k−2j−1)/((k−j)(j+1)).
fn one_by_one(factors: &[i64]) -> Vec<Integer> {
    let product = |a: usize, b: usize| Integer::from(a) * Integer::from(b);
    let mut sum = vec![Integer::zero(); factors.len()];
    for (k, &factor) in factors.iter().enumerate().filter(|(_, factor)| **factor != 0) {
        let mut term = Integer::from(factor);
        for j in 0..=k / 2 {
            sum[k - 2 * j] += &term;
            let rest = k - 2 * j;
            if rest >= 2 {
                term *= &-product(rest, rest - 1);
                term = term.div_exact(&product(k - j, j + 1));
            }
        }
    }
    sum
}

/// Σ_k f_k S_k by Clenshaw's recurrence.
fn by_clenshaw(factors: &[i64]) -> Vec<Integer> {
    let m = factors.len() - 1;
    // ±b_k and ±b_{k+1}, where the sign changes at every second k. With these signs
    // b_{k+2} becomes b_k in place, by additions only or by subtractions only.
    let (mut this, mut other) = (vec![Integer::zero(); m + 1], vec![Integer::zero(); m + 1]);
    let negated = |k: usize| k / 2 % 2 == 1;
    for k in (0..=m).rev() {
        // `this` holds ±b_{k+2}, of degree m − k − 2, and `other` ±b_{k+1}.
        let subtract = negated(k) != negated(k + 1);
        for (to, from) in this[1..].iter_mut().zip(&other[..m - k]) {
            if subtract {
                *to -= from;
            } else {
                *to += from;
            }
        }
        let start = Integer::from(factors[k]);
        if negated(k) {
            this[0] -= &start;
        } else {
            this[0] += &start;
        }
        std::mem::swap(&mut this, &mut other);
    }
    other
}
