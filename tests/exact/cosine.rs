//! Real numbers of Q(2cos(2π/n)): the laws they follow.

use proptest::prelude::*;
use std::cmp::Ordering;
use subcert::exact::{
    Enclosed as _, IntegerPolynomial, Rational, Real as _, RealCyclotomic, Scalar as _, format,
};
use subcert::float::{exact, nearest};

pub(super) fn r(p: i64, q: i64) -> Rational {
    Rational::new(p, q)
}

pub(super) fn rational(p: i64, q: i64) -> RealCyclotomic {
    RealCyclotomic::from(r(p, q))
}

pub(super) fn cosine(j: i64, n: i64) -> RealCyclotomic {
    RealCyclotomic::cosine(&r(j, n)).expect("a small conductor")
}

/// Σ c_i cos(2πj_i/n_i), exactly and in f64, with a bound on what f64 loses.
#[derive(Clone, Debug)]
struct Sample {
    number: RealCyclotomic,
    float: f64,
}

const CONDUCTORS: [i64; 10] = [1, 4, 5, 6, 7, 8, 9, 10, 12, 15];

/// Sums of few cosines; rational ones and those of different fields among them.
fn sample() -> impl Strategy<Value = Sample> {
    let term = (-6_i64..7, 1_i64..5, 0_i64..15, prop::sample::select(&CONDUCTORS[..]));
    prop::collection::vec(term, 0..4).prop_map(|terms| {
        let start = Sample { number: rational(0, 1), float: 0.0 };
        terms.into_iter().fold(start, |sum, (p, q, j, n)| {
            #[expect(clippy::cast_precision_loss, reason = "small")]
            let (ratio, angle) = (p as f64 / q as f64, std::f64::consts::TAU * j as f64 / n as f64);
            Sample {
                number: &sum.number + &(&rational(p, q) * &cosine(j, n)),
                float: sum.float + ratio * angle.cos(),
            }
        })
    })
}

/// Coefficients near the ends of words and of what sums of them may be, and the conductor of
/// their field.
fn large() -> impl Strategy<Value = RealCyclotomic> {
    let power = (prop::sample::select(&[0, 30, 59, 60, 61, 62, 63, 64, 130]), -3_i64..4);
    let coefficient = (power, -1_i64..2).prop_map(|((places, off), sign)| {
        &Rational::from(2).pow(places) * &Rational::from(sign) + Rational::from(off)
    });
    let conductors = prop::sample::select(&[5_i64, 12, 28, 105]);
    (conductors, prop::collection::vec((0_i64..105, coefficient), 1..5)).prop_map(|(n, terms)| {
        terms.into_iter().fold(rational(0, 1), |sum, (j, factor)| {
            &sum + &(&RealCyclotomic::from(factor) * &cosine(2 * j, 2 * n))
        })
    })
}

proptest! {
    // Signs and order of numbers that do and do not fit into words, against enclosures of
    // 512 digits.
    #[test]
    fn order_is_that_of_enclosures(a in large(), b in large()) {
        let (x, y) = (a.enclosure(3), b.enclosure(3));
        if x.upper() < y.lower() {
            prop_assert_eq!(a.cmp(&b), Ordering::Less);
            prop_assert_eq!((&a - &b).sign(), -1);
        } else if y.upper() < x.lower() {
            prop_assert_eq!(a.cmp(&b), Ordering::Greater);
            prop_assert_eq!((&a - &b).sign(), 1);
        } else {
            prop_assert_eq!(a.cmp(&b), (&a - &b).sign().cmp(&0));
        }
    }

    #[test]
    fn in_place_as_by_itself(a in large(), b in large(), c in sample()) {
        for (x, y) in [(&a, &b), (&a, &a), (&a, &c.number), (&c.number, &a)] {
            let (mut sum, mut difference) = (x.clone(), x.clone());
            sum.accumulate(y);
            difference.lessen(y);
            prop_assert_eq!(&sum, &(x + y));
            prop_assert_eq!(&difference, &(x + &(y * &rational(-1, 1))));
            prop_assert_eq!(difference.as_rational().is_some(), (x - y).as_rational().is_some());
        }
    }

    #[test]
    fn field_axioms(a in sample(), b in sample(), c in sample()) {
        let (a, b, c) = (&a.number, &b.number, &c.number);
        let (zero, one) = (rational(0, 1), rational(1, 1));
        prop_assert_eq!(a + b, b + a);
        prop_assert_eq!(a * b, b * a);
        prop_assert_eq!(&(a + b) + c, a + &(b + c));
        prop_assert_eq!(&(a * b) * c, a * &(b * c));
        prop_assert_eq!(a * &(b + c), &(a * b) + &(a * c));
        prop_assert_eq!(a + &zero, a.clone());
        prop_assert_eq!(a * &one, a.clone());
        prop_assert_eq!(a - a, zero.clone());
        prop_assert_eq!(&(a - b) + b, a.clone());
        if a.sign() != 0 {
            prop_assert_eq!(a * &a.recip(), one);
            prop_assert_eq!(&(b / a) * a, b.clone());
        } else {
            prop_assert_eq!(a, &zero);
        }
    }

    #[test]
    fn order_fits_arithmetic(a in sample(), b in sample(), c in sample()) {
        let (a, b, c) = (&a.number, &b.number, &c.number);
        prop_assert_eq!(a.cmp(b), b.cmp(a).reverse());
        prop_assert_eq!(a.cmp(b), (a - b).sign().cmp(&0));
        prop_assert_eq!((a + c).cmp(&(b + c)), a.cmp(b));
        prop_assert_eq!((a * b).sign(), a.sign() * b.sign());
        prop_assert_eq!((-a).sign(), -a.sign());
        if a <= b && b <= c {
            prop_assert!(a <= c);
        }
        let size = a.abs();
        prop_assert!(size.sign() >= 0 && (&size == a || size == -a));
        prop_assert!((a + b).abs() <= &size + &b.abs());
        prop_assert_eq!((a * b).abs(), &size * &b.abs());
        prop_assert_eq!(a.greater(b), a.max(b).clone());
        prop_assert_eq!(a.cmp(b) == Ordering::Equal, a == b);
    }

    #[test]
    fn f64_agrees_within_rounding(a in sample(), b in sample()) {
        let near = |x: &RealCyclotomic, y: f64| (nearest(x) - y).abs() <= 1e-12;
        prop_assert!(near(&a.number, a.float), "{} {}", a.number, a.float);
        prop_assert!(near(&(&a.number + &b.number), a.float + b.float));
        prop_assert!((nearest(&(&a.number * &b.number)) - a.float * b.float).abs() <= 1e-10);
        if b.float.abs() > 1e-3 {
            let quotient = a.float / b.float;
            let off = nearest(&a.number.over(&b.number)) - quotient;
            prop_assert!(off.abs() <= 1e-9 * quotient.abs().max(1.0), "{}", off);
        }
        if (a.float - b.float).abs() > 1e-10 {
            prop_assert_eq!(a.number < b.number, a.float < b.float);
        }
    }

    // No f64 is nearer than the nearest one, and no decimal of the length.
    #[test]
    fn conversions_round_correctly(a in sample(), places in 0_u32..25) {
        let a = &a.number;
        let float = nearest(a);
        let off = |x: f64| (a - &RealCyclotomic::from(exact(x).unwrap())).abs();
        prop_assert!(off(float) <= off(float.next_up()) && off(float) <= off(float.next_down()));
        let printed = subcert::exact::parse_decimal(&format::fixed(a, places)).unwrap();
        let (low, high) = printed.interval();
        prop_assert!(RealCyclotomic::from(low) <= *a && *a <= RealCyclotomic::from(high));
    }

    #[test]
    fn enclosures_hold_the_number(a in sample(), level in 0_u32..4) {
        let e = a.number.enclosure(level);
        let (lower, upper) = (e.lower().clone(), e.upper().clone());
        prop_assert!(RealCyclotomic::from(lower) <= a.number);
        prop_assert!(a.number <= RealCyclotomic::from(upper));
        prop_assert_eq!(e.width().is_zero(), a.number.as_rational().is_some());
        prop_assert!(e.width() < r(1 << 10, 1) * Rational::from(2).pow(-(64 << level)));
    }

    #[test]
    fn automorphisms(j in 0_i64..35, k in 0_i64..35, c in -5_i64..6, multiplier in 1_u32..70) {
        prop_assume!(multiplier % 5 != 0 && multiplier % 7 != 0);
        let (a, b) = (cosine(j, 35), &cosine(k, 35) * &rational(c, 3));
        let image = |j: i64| cosine(j * i64::from(multiplier), 35);
        let sigma = |x: &RealCyclotomic| {
            // Conjugate in the field of 35, also where the number's own is smaller.
            let whole = cosine(1, 35);
            &(x + &whole).conjugate(multiplier) - &whole.conjugate(multiplier)
        };
        prop_assert_eq!(sigma(&a), image(j));
        prop_assert_eq!(sigma(&(&a * &b)), &sigma(&a) * &sigma(&b));
        prop_assert_eq!(sigma(&(&a + &b)), &sigma(&a) + &sigma(&b));
    }

    // The polynomial has the number as a root, no rational root, and the product and
    // the sum of all conjugates as coefficients.
    #[test]
    fn minimal_polynomials(a in sample()) {
        let a = &a.number;
        let polynomial = a.minimal_polynomial();
        prop_assert!(value_at(&polynomial, a).as_rational().is_some_and(Rational::is_zero));
        prop_assert_eq!(&polynomial, &polynomial.primitive());
        let n = a.conductor();
        let conjugates: Vec<RealCyclotomic> = (1..=n.div_ceil(2))
            .filter(|&k| num_integer::gcd(k, n) == 1)
            .map(|k| a.conjugate(k))
            .collect();
        let mut different = conjugates.clone();
        different.sort();
        different.dedup();
        prop_assert_eq!(different.len(), polynomial.degree().unwrap());
        let norm = different.iter().fold(rational(1, 1), |product, x| &product * x);
        let trace = different.iter().fold(rational(0, 1), |sum, x| &sum + x);
        let [c0, .., c1, lead] = &monic(&polynomial)[..] else {
            prop_assert_eq!(polynomial.degree(), Some(1));
            return Ok(());
        };
        prop_assert_eq!(lead, &Rational::one());
        let sign = if different.len() % 2 == 1 { -1 } else { 1 };
        prop_assert_eq!(norm, RealCyclotomic::from(c0 * Rational::from(sign)));
        prop_assert_eq!(trace, RealCyclotomic::from(-c1));
    }
}

fn monic(polynomial: &IntegerPolynomial) -> Vec<Rational> {
    let leading = polynomial.leading();
    polynomial.coefficients().iter().map(|c| Rational::new(c.clone(), leading.clone())).collect()
}

fn value_at(polynomial: &IntegerPolynomial, at: &RealCyclotomic) -> RealCyclotomic {
    polynomial.coefficients().iter().rev().fold(rational(0, 1), |value, c| {
        &(&value * at) + &RealCyclotomic::from(Rational::from(c.clone()))
    })
}
