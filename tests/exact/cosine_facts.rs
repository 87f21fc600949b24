//! Known facts about cosines, and the caps and forms of their type.

use super::cosine::{cosine, r, rational};
use std::collections::HashSet;
use subcert::exact::{
    CosineError, Enclosed as _, Integer, MAX_CONDUCTOR, Rational, Real as _, RealCyclotomic,
    Scalar as _, common_conductor, format,
};
use subcert::float::nearest;

// Niven: rational multiples of π with rational cosines.
#[test]
fn rational_cosines() {
    for (j, n, p, q) in [
        (0, 1, 1, 1),
        (1, 2, -1, 1),
        (1, 3, -1, 2),
        (2, 3, -1, 2),
        (1, 4, 0, 1),
        (3, 4, 0, 1),
        (1, 6, 1, 2),
        (5, 6, 1, 2),
        (-7, 6, 1, 2),
        (25, 12, -1, 1),
    ] {
        if n != 12 {
            assert_eq!(cosine(j, n).as_rational(), Some(&r(p, q)), "{j}/{n}");
        }
    }
    for n in [5, 7, 8, 9, 10, 11, 12, 14, 18, 30, 100] {
        assert_eq!(cosine(1, n).as_rational(), None, "{n}");
    }
}

#[test]
fn identities() {
    // cos 36° = (1 + √5)/4 and cos 72° = (√5 − 1)/4.
    let root = &(&cosine(1, 10) * &rational(4, 1)) - &rational(1, 1);
    assert_eq!(&root * &root, rational(5, 1));
    assert_eq!(root.sign(), 1);
    assert_eq!(cosine(1, 5), &(&root - &rational(1, 1)) / &rational(4, 1));
    // √2·√3 = √6, from the fields of 8 and 12 to that of 24.
    let (two, three) = (&cosine(1, 8) * &rational(2, 1), &cosine(1, 12) * &rational(2, 1));
    assert_eq!(&two * &two, rational(2, 1));
    assert_eq!(&three * &three, rational(3, 1));
    let six = &two * &three;
    assert_eq!((&six * &six, six.conductor()), (rational(6, 1), 24));
    assert_eq!(six.minimal_polynomial().to_string(), "x^2 - 6");
    assert_eq!((&two + &three).minimal_polynomial().to_string(), "x^4 - 10x^2 + 1");
    // Morrie: cos20° cos40° cos80° = 1/8.
    let morrie = &(&cosine(1, 18) * &cosine(1, 9)) * &cosine(2, 9);
    assert_eq!(morrie, rational(1, 8));
    // Gauss: cos(2π/17) in square roots is of degree 8.
    assert_eq!(cosine(1, 17).minimal_polynomial().degree(), Some(8));
    for n in [5, 7, 9, 12, 20, 101, 148] {
        // Σ_j cos(2πj/n) = 0, and over j = 1, …, (n−1)/2 it is −1/2 for odd n.
        let sum = (0..n).fold(rational(0, 1), |sum, j| &sum + &cosine(j, n));
        assert_eq!(sum, rational(0, 1), "{n}");
        if n % 2 == 1 {
            let half = (1..=n / 2).fold(rational(0, 1), |sum, j| &sum + &cosine(j, n));
            assert_eq!(half, rational(-1, 2), "{n}");
        }
        // Π_{j=1}^{n−1} 2sin(πj/n) = n; with 2sin(πj/n) = 2cos(π/2 − πj/n).
        let sine = |j: i64| &rational(2, 1) * &cosine(n - 2 * j, 4 * n);
        let product = (1..n).fold(rational(1, 1), |product, j| &product * &sine(j));
        assert_eq!(product, rational(n, 1), "{n}");
        // cos²x + sin²x = 1.
        let square = &(&sine(1) * &sine(1)) * &rational(1, 4);
        let other = cosine(1, 2 * n);
        assert_eq!(&square + &(&other * &other), rational(1, 1), "{n}");
    }
}

// Equal numbers, of different fields and forms, are equal in every way.
#[test]
fn equality_and_hashes_across_fields() {
    let golden = &cosine(1, 5) * &rational(2, 1);
    let in_15 = &(&golden + &cosine(1, 15)) - &cosine(1, 15);
    let in_60 = &(&golden + &cosine(1, 60)) - &cosine(1, 60);
    assert_eq!((in_15.conductor(), in_60.conductor()), (15, 60));
    let set = HashSet::from([golden.clone(), in_15.clone(), in_60.clone()]);
    assert_eq!(set.len(), 1);
    assert!(golden == in_15 && in_15 == in_60 && in_60 == golden);
    assert_eq!(in_60.minimal_polynomial().to_string(), "x^2 + x - 1");
    assert!(!set.contains(&cosine(1, 7)) && !set.contains(&rational(1, 2)));
    // What cancels is rational, and so in no field.
    let one = &(&in_60 * &in_60) + &golden;
    assert_eq!((one.conductor(), one.as_rational()), (1, Some(&r(1, 1))));
    // Numbers far apart compare without a common field, which would be too large.
    assert!(cosine(1, 4999) > cosine(1, 4993) && cosine(1, 4999) != cosine(1, 5));
}

// 2cos(2π/n) is as near to 2 as 4π²/n²; a difference of nearly equal numbers needs
// refinements, and only as many as it takes.
#[test]
fn signs_refine_only_as_needed() {
    assert_eq!(cosine(1, 500).sign_with_refinements(), (1, 0));
    assert_eq!(rational(-3, 7).sign_with_refinements(), (-1, 0));
    let root = &(&cosine(1, 10) * &rational(4, 1)) - &rational(1, 1);
    // Convergents of √5: |p/q − √5| < 1/q², on alternating sides.
    let (mut p, mut q) =
        ((Integer::from(2), Integer::from(9)), (Integer::from(1), Integer::from(4)));
    let mut seen = HashSet::new();
    for i in 0..500 {
        let off = &root - &RealCyclotomic::from(Rational::new(p.1.clone(), q.1.clone()));
        let (sign, refinements) = off.sign_with_refinements();
        assert_eq!(sign, if i % 2 == 0 { -1 } else { 1 }, "{i}");
        if refinements > 0 {
            assert!(off.enclosure(refinements - 1).contains(&Rational::zero()));
        }
        // 64·2^refinements digits, where 2·log2 q and a few decide.
        let digits = 2 * q.1.bits() + 8;
        let needed = (0..32).find(|level| 64_u64 << level >= digits).unwrap();
        assert!(refinements <= needed, "{i}: {refinements} for {digits} digits");
        seen.insert(refinements);
        let four = Integer::from(4);
        p = (p.1.clone(), &four * &p.1 + &p.0);
        q = (q.1.clone(), &four * &q.1 + &q.0);
    }
    assert_eq!(seen, (0..=6).collect());
    // 0 is seen without any enclosure, however it came about.
    let zero = &(&root * &root) - &rational(5, 1);
    assert_eq!(zero.sign_with_refinements(), (0, 0));
}

#[test]
fn inverses_in_large_fields() {
    for n in [77, 148, 210, 500] {
        let a = &(&cosine(1, n) + &(&cosine(3, n) * &rational(-2, 7))) + &rational(5, 3);
        assert_eq!(&a * &a.recip(), rational(1, 1), "{n}");
        assert_eq!(a.recip().recip(), a, "{n}");
    }
    // Units: 1/(2cos(2π/5)) = 1 + 2cos(2π/5), and 2cos(2π/n) for odd n.
    let unit = &rational(2, 1) * &cosine(1, 5);
    assert_eq!(unit.recip(), &unit + &rational(1, 1));
    let inverse = (&rational(2, 1) * &cosine(1, 35)).recip();
    assert_eq!(inverse.minimal_polynomial().leading(), Integer::one());
}

#[test]
fn decimals() {
    // cos 1°, from the literature.
    let degree = cosine(1, 360);
    assert_eq!(format::fixed(&degree, 30), "0.999847695156391239157011558814");
    assert_eq!(format::scientific(&(&degree - &rational(1, 1)), 6), "-1.52305e-4");
    assert_eq!(format::short(&cosine(1, 5), 8), "0.30901699");
    assert_eq!(format::short(&rational(5, 2), 8), "2.5");
    assert_eq!(format::fixed(&(-&degree), 0), "-1");
    assert_eq!((degree.floor(), (-&degree).floor()), (0.into(), Integer::from(-1)));
    assert_eq!((rational(3, 1).floor(), rational(-3, 2).floor()), (3.into(), Integer::from(-2)));
    let float: f64 = 0.309_016_994_374_947_45;
    assert_eq!(nearest(&cosine(1, 5)).to_bits(), float.to_bits());
}

#[test]
fn display() {
    for (number, text) in [
        (rational(-3, 4), "-3/4"),
        (cosine(1, 5), "cos(2*pi/5)"),
        (cosine(2, 5), "-1/2 - cos(2*pi/5)"),
        (cosine(1, 8), "cos(pi/4)"),
        (&rational(3, 4) + &(&rational(-2, 1) * &cosine(3, 16)), "3/4 - 2*cos(3*pi/8)"),
        (&rational(1, 3) * &cosine(2, 7), "1/3*cos(4*pi/7)"),
    ] {
        assert_eq!(number.to_string(), text);
    }
    assert_eq!(format!("{:>14}|", cosine(1, 5)), "   cos(2*pi/5)|");
}

#[test]
fn caps() {
    let most = i64::from(MAX_CONDUCTOR);
    assert_eq!(cosine(1, most).conductor(), MAX_CONDUCTOR);
    assert_eq!(cosine(1, 2 * (most - 1)).conductor(), MAX_CONDUCTOR - 1);
    for n in [most + 1, 2 * (most + 1), i64::MAX] {
        let error = RealCyclotomic::cosine(&r(1, n)).unwrap_err();
        assert!(matches!(error, CosineError::Conductor { .. }), "{n}");
    }
    assert_eq!(common_conductor(12, 20), Ok(60));
    assert_eq!(common_conductor(MAX_CONDUCTOR, 1), Ok(MAX_CONDUCTOR));
    for (m, n) in [(MAX_CONDUCTOR, 3), (4999, 4993), (u32::MAX, u32::MAX - 1)] {
        assert!(common_conductor(m, n).unwrap_err().to_string().contains("10000"));
    }
}

#[test]
#[should_panic(expected = "beyond the cap of 10000")]
fn no_field_beyond_the_cap() {
    let _ = &cosine(1, 101) + &cosine(1, 103);
}

#[test]
#[should_panic(expected = "a multiplier prime to 15")]
fn conjugates_need_units() {
    let _ = cosine(1, 15).conjugate(6);
}

#[test]
#[should_panic(expected = "denominator 0")]
fn no_inverse_of_zero() {
    let _ = rational(0, 1).recip();
}

// The trait's sums are the operators'.
#[test]
fn sums_of_magnitudes() {
    let terms = [cosine(1, 5), cosine(2, 5)];
    assert_eq!(RealCyclotomic::total(&terms), rational(-1, 2));
    let root = &(&cosine(1, 10) * &rational(4, 1)) - &rational(1, 1);
    assert_eq!(RealCyclotomic::sum_of_magnitudes(&terms), &root * &rational(1, 2));
    assert_eq!(RealCyclotomic::maximum(terms.clone()), terms[0]);
}
