//! Enclosures of cosines in fixed point: integers over a power of two.
//!
//! θ = 2cos(2π/n) comes from the alternating series of the arc tangent and the cosine,
//! with a running bound on the rounding errors. The cost does not depend on n. Bisection
//! or Newton's method for a root of Ψ_n would evaluate, in each step, a polynomial with
//! coefficients of up to 0.7·φ(n)/2 bits.

use crate::exact::Integer;

/// Integers within 1 of 2^bits·2cos(2πk/n) for k = 0, …, count − 1, where n ≥ 5 and count
/// ≤ n.
///
/// They come from the recurrence c_{k+1} = θ c_k − c_{k−1}, with an approximation θ̃ =
/// 2cos t̃ of θ, with g guard bits and units u = 2^−(bits+g). Rounding down adds an error
/// below u in each step, and an error e made in c_i grows to e·sin((k+1−i)t̃)/sin t̃, at
/// most (k − i + 1)e; these sum to less than k²u/2. If |θ̃ − θ| ≤ δu, then c_k moves by
/// at most k²δu, for |dC_k/dθ| ≤ k². The guard bits make k²(δ + 1)u a quarter of 2^−bits,
/// and the final rounding to the nearest integer adds at most one half.
#[must_use]
pub fn cosines(n: usize, count: usize, bits: u32) -> Vec<Integer> {
    let mut guard = 2 * (n.ilog2() + 1) + bits.ilog2() + 8;
    let theta = loop {
        let (theta, error) = twice_cosine(n, bits + guard);
        let spread = Integer::from(count).pow(2) * (error + Integer::one());
        if spread.bits() + 2 <= u64::from(guard) {
            break theta;
        }
        guard += 8;
    };
    let working = bits + guard;
    let mut cosines = vec![Integer::one().shifted_left(working + 1), theta.clone()];
    for k in 2..count {
        let product = (&theta * &cosines[k - 1]).shifted_right(working);
        cosines.push(product - &cosines[k - 2]);
    }
    let half = Integer::one().shifted_left(guard - 1);
    cosines.iter().take(count).map(|cosine| (cosine + &half).shifted_right(guard)).collect()
}

/// 2^bits·2cos(2π/n), n ≥ 5, with a bound on its error.
///
/// 2Σ_i (−1)^i x^{2i}/(2i)! at x = X/2^bits, X an integer near 2^bits·2π/n. Here x < 1.3,
/// so x²/((2i+1)(2i+2)) < 1. Each term is rounded down. From one term to the next, an
/// error e becomes at most 0.85e + 1 in the first step and 0.15e + 1 in all later ones,
/// so it stays below 2. The rest of the series is at most the first term that rounds to
/// 0, hence below 2.
fn twice_cosine(n: usize, bits: u32) -> (Integer, Integer) {
    let (pi, pi_error) = pi(bits);
    let n = Integer::from(n);
    let x = (&pi + &pi).div_floor(&n);
    // A bound on |x − 2π/n|, and so on its effect on the cosine.
    let x_error = (&pi_error + &pi_error).div_floor(&n) + Integer::from(2);
    let square = &x * &x;
    let (mut term, mut sum, mut count) = (Integer::one().shifted_left(bits), Integer::zero(), 0);
    while !term.is_zero() {
        if count % 2 == 0 {
            sum += &term;
        } else {
            sum -= &term;
        }
        let divisor = Integer::from((2 * count + 1) * (2 * count + 2));
        term = (term * &square).shifted_right(2 * bits).div_floor(&divisor);
        count += 1;
    }
    let error = x_error + Integer::from(2 * count + 2);
    (&sum + &sum, &error + &error)
}

/// 2^bits·π with a bound on its error: π = 16 arctan(1/5) − 4 arctan(1/239)
/// (Machin 1706).
#[must_use]
pub fn pi(bits: u32) -> (Integer, Integer) {
    let (fifth, fifth_error) = inverse_arctangent(5, bits);
    let (small, small_error) = inverse_arctangent(239, bits);
    let (four, sixteen) = (Integer::from(4), Integer::from(16));
    (&sixteen * fifth - &four * small, sixteen * fifth_error + four * small_error)
}

/// 2^bits·arctan(1/q), with a bound on its error: Σ_i (−1)^i /((2i+1)q^{2i+1}), each term
/// rounded down once, since ⌊⌊x/a⌋/b⌋ = ⌊x/ab⌋. The omitted terms sum to less than 1.
fn inverse_arctangent(q: u32, bits: u32) -> (Integer, Integer) {
    let (square, mut power) = (Integer::from(q * q), Integer::one().shifted_left(bits));
    power = power.div_floor(&Integer::from(q));
    let (mut sum, mut count) = (Integer::zero(), 0_u32);
    while !power.is_zero() {
        let term = power.div_floor(&Integer::from(2 * count + 1));
        if count % 2 == 0 {
            sum += &term;
        } else {
            sum -= &term;
        }
        power = power.div_floor(&square);
        count += 1;
    }
    (sum, Integer::from(count + 1))
}
