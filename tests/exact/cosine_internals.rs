//! Parts of the cosine fields that no one else calls: fixed-point cosines, and primes.

use subcert::exact::Integer;
use subcert::exact::internals::{cosines, is_prime, pi, primes};

// 50 digits of π, from the literature.
#[test]
fn pi_is_pi() {
    let digits = "314159265358979323846264338327950288419716939937510";
    let digits = Integer::from_digits(digits).expect("digits");
    for bits in [64, 128, 160] {
        let (value, error) = pi(bits);
        // |value/2^bits − digits/10^50| ≤ error/2^bits + 10^−50
        let power = Integer::power_of_ten(50);
        let off = (value * &power - digits.shifted_left(bits)).abs();
        assert!(off <= &error * &power + Integer::one().shifted_left(bits), "{bits}");
        assert!(error.bits() < 12, "{bits}: {error}");
    }
}

#[test]
fn a_coarse_table_is_within_one_of_a_fine_one() {
    for n in [5, 7, 12, 499, 2310] {
        let (coarse, fine) = (cosines(n, n, 64), cosines(n, n, 128));
        for (k, (coarse, fine)) in coarse.iter().zip(&fine).enumerate() {
            let off = (coarse.shifted_left(64) - fine).abs();
            let slack = Integer::one().shifted_left(64) + Integer::one();
            assert!(off < slack, "cosine {k} of {n}");
        }
    }
}

#[test]
fn primes_agree_with_trial_division() {
    let prime = |n: u32| (2..=n.isqrt()).all(|d| !n.is_multiple_of(d));
    assert_eq!(primes().next(), Some((1 << 31) - 1));
    let (some, naive): (Vec<u32>, Vec<u32>) = (
        primes().take(70).collect(),
        (3..1 << 31).rev().step_by(2).filter(|&n| prime(n)).take(70).collect(),
    );
    assert_eq!(some, naive);
    assert!((63..20_001).step_by(2).all(|n| is_prime(n) == prime(n)));
}
