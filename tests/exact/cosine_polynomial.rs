//! Ψ_n, the minimal polynomial of 2cos(2π/n), found in other ways.

use subcert::exact::{
    Enclosed, Integer, IntegerPolynomial, Rational, RealAlgebraic, RealCyclotomic, SturmSequence,
    cosine_polynomial,
};

fn gcd(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { gcd(b, a % b) }
}

fn totient(n: u32) -> usize {
    (1..=n).filter(|&k| gcd(k, n) == 1).count()
}

/// C_k with C_k(x + 1/x) = x^k + x^(−k), by its recurrence.
fn chebyshev(most: usize) -> Vec<IntegerPolynomial> {
    let y = IntegerPolynomial::from([0, 1]);
    let mut list = vec![IntegerPolynomial::from([2]), y.clone()];
    for k in 2..=most {
        let next = &(&y * &list[k - 1]) - &list[k - 2];
        list.push(next);
    }
    list
}

#[test]
fn known_polynomials() {
    for (n, text) in [
        (1, "x - 2"),
        (2, "x + 2"),
        (3, "x + 1"),
        (4, "x"),
        (5, "x^2 + x - 1"),
        (6, "x - 1"),
        (7, "x^3 + x^2 - 2x - 1"),
        (8, "x^2 - 2"),
        (9, "x^3 - 3x + 1"),
        (10, "x^2 - x - 1"),
        (11, "x^5 + x^4 - 4x^3 - 3x^2 + 3x + 1"),
        (12, "x^2 - 3"),
        (13, "x^6 + x^5 - 5x^4 - 4x^3 + 6x^2 + 3x - 1"),
        (15, "x^4 - x^3 - 4x^2 + 4x + 1"),
        (16, "x^4 - 4x^2 + 2"),
        (17, "x^8 + x^7 - 7x^6 - 6x^5 + 15x^4 + 10x^3 - 10x^2 - 4x + 1"),
        (24, "x^4 - 4x^2 + 1"),
    ] {
        assert_eq!(cosine_polynomial(n).to_string(), text, "{n}");
    }
}

// Watkins and Zeitlin 1993, for monic polynomials of 2cos: Π_{d|n} Ψ_d is
// C_{s+1} − C_s for n = 2s + 1, and C_{s+1} − C_{s−1} for n = 2s.
#[test]
fn products_over_divisors() {
    let chebyshev = chebyshev(101);
    let psi: Vec<IntegerPolynomial> =
        (0..=200).map(|n| if n == 0 { [0].into() } else { cosine_polynomial(n) }).collect();
    for n in 1..=200 {
        let s = n / 2;
        let below = if n % 2 == 1 { s } else { s - 1 };
        let wanted = &chebyshev[s + 1] - &chebyshev[below];
        let divisors = (1..=n).filter(|d| n % d == 0);
        let product = divisors.fold([1].into(), |product: IntegerPolynomial, d| &product * &psi[d]);
        assert_eq!(product, wanted, "{n}");
        assert_eq!(psi[n].leading(), Integer::one(), "{n}");
        if n > 2 {
            assert_eq!(psi[n].degree(), Some(totient(u32::try_from(n).unwrap()) / 2), "{n}");
        }
    }
}

// Explicitly: with Ψ_n = Σ_k a_k C_k, the coefficient of y^i is
// Σ_k (a_k − a_{k+1}) (−1)^⌊(k−i)/2⌋ binomial(⌊(k+i)/2⌋, i); for a prime n all a_k are 1.
#[test]
fn binomials_for_primes() {
    for n in [3_u32, 5, 29, 37, 101, 499, 1009] {
        let m = (n - 1) / 2;
        let coefficient = |i: u32| {
            let size = Integer::binomial(u32::midpoint(m, i), i);
            if (m - i) / 2 % 2 == 1 { -size } else { size }
        };
        let explicit = IntegerPolynomial::new((0..=m).map(coefficient).collect());
        assert_eq!(cosine_polynomial(n), explicit, "{n}");
    }
}

// Numerically: the real roots are the 2cos(2πj/n), in order, and the number type
// agrees that they are.
#[test]
fn roots_are_cosines() {
    for n in (3..=40).chain([60, 74]) {
        let psi = cosine_polynomial(n);
        let indices: Vec<u32> = (1..=n / 2).rev().filter(|&j| gcd(j, n) == 1).collect();
        let roots = RealAlgebraic::roots_of(&psi);
        assert_eq!(roots.len(), indices.len(), "{n}");
        for (root, j) in roots.iter().zip(indices) {
            let angle = std::f64::consts::TAU * f64::from(j) / f64::from(n);
            let float = subcert::float::nearest(root);
            assert!((float - 2.0 * angle.cos()).abs() < 1e-14, "{j} of {n}: {float}");
            let cosine = RealCyclotomic::cosine(&Rational::new(j, n)).unwrap();
            let twice = &cosine + &cosine;
            assert_eq!(RealAlgebraic::from(&twice), *root, "{j} of {n}");
        }
    }
}

// 2cos(2π/n) is enclosed without Ψ_n; yet it is a root of Ψ_n, the greatest one.
#[test]
fn enclosures_and_polynomials_meet() {
    for n in [5, 9, 12, 35, 52, 148, 210, 500] {
        let psi = cosine_polynomial(n);
        let cosine = RealCyclotomic::cosine(&Rational::new(1, n)).unwrap();
        let e = (&cosine + &cosine).enclosure(2);
        assert_eq!(psi.sign_at(e.lower()) * psi.sign_at(e.upper()), -1, "{n}");
        assert!(e.width() < Rational::from(2).pow(-240), "{n}: {}", e.width());
        if n < 60 {
            let two = Rational::from(2);
            assert_eq!(SturmSequence::new(&psi).count_roots(e.lower(), &two), 1, "{n}");
        }
    }
}

// Ψ_n(2) = Φ_n(1): p when n is a power of the prime p, else 1; and Ψ_n(−2) = ±Φ_n(−1).
#[test]
fn values_at_two() {
    for n in [148, 250, 343, 500, 512, 1000, 1001, 2310, 4096, 5000] {
        let value = cosine_polynomial(n).value_at(&Rational::from(2));
        let expected = match n {
            343 => 7,
            512 | 4096 => 2,
            _ => 1,
        };
        assert_eq!(value, Rational::from(expected), "{n}");
        let odd_part_power = match n {
            250 => 5,
            512 | 4096 => 2,
            _ => 1,
        };
        let value = cosine_polynomial(n).value_at(&Rational::from(-2));
        assert_eq!(value.abs(), Rational::from(odd_part_power), "{n}");
    }
}

#[test]
#[should_panic(expected = "2π/0")]
fn no_polynomial_for_zero() {
    let _ = cosine_polynomial(0);
}
