//! Roots of polynomials: Sturm's theorem and real algebraic numbers.

use super::univariate::polynomial;
use proptest::prelude::*;
use std::cmp::Ordering;
use subcert::exact::{
    Enclosed, Integer, IntegerPolynomial, Rational, RealAlgebraic, SturmSequence, format,
};

fn r(p: i64, q: i64) -> Rational {
    Rational::new(p, q)
}

/// Π (q_i x − p_i) over the given roots p_i/q_i.
fn with_roots(roots: &[Rational]) -> IntegerPolynomial {
    let factor = |root: &Rational| IntegerPolynomial::from([-root.numerator(), root.denominator()]);
    roots.iter().fold(IntegerPolynomial::from([1]), |product, root| &product * &factor(root))
}

fn rationals(most: usize) -> impl Strategy<Value = Vec<Rational>> {
    prop::collection::vec((-20_i64..21, 1_i64..7).prop_map(|(p, q)| r(p, q)), 0..most)
}

/// √`square`.
fn root_of(square: i64) -> RealAlgebraic {
    let roots = RealAlgebraic::roots_of(&IntegerPolynomial::from([-square, 0, 1]));
    roots.into_iter().next_back().expect("a positive number")
}

proptest! {
    // Against known factors: irreducible are x² − p, by Eisenstein, linear ones, and
    // x⁴ + 1 and x⁴ − 10x² + 1, which split modulo every prime.
    #[test]
    fn factors_of_products(choice in prop::collection::vec(0_usize..12, 0..6)) {
        let known: Vec<IntegerPolynomial> = [
            vec![-2, 0, 1], vec![-3, 0, 1], vec![-6, 0, 1], vec![1, 1], vec![-5, 2], vec![7, 3],
            vec![1, 0, 0, 0, 1], vec![1, 0, -10, 0, 1], vec![1, 1, 1], vec![-2, 0, 0, 0, 0, 9],
            vec![1, 1, 1, 1, 1], vec![0, 1],
        ].into_iter().map(|c: Vec<i64>| {
            IntegerPolynomial::new(c.into_iter().map(Integer::from).collect())
        }).collect();
        let product = choice.iter().fold(IntegerPolynomial::from([-6]), |f, &i| &f * &known[i]);
        let found = product.irreducible_factors().expect("few combinations");
        let mut distinct = choice.clone();
        distinct.sort_unstable();
        distinct.dedup();
        prop_assert_eq!(found.len(), distinct.len(), "{:?}", found);
        for i in distinct {
            prop_assert!(found.contains(&known[i]), "{} of {}", known[i], product);
        }
    }

    #[test]
    fn factors_multiply_to_the_square_free_part(p in polynomial(5), q in polynomial(5)) {
        let product = &p * &q;
        prop_assume!(!product.is_zero());
        let one = IntegerPolynomial::from([1]);
        let factors = product.irreducible_factors().expect("few combinations");
        let multiplied = factors.iter().fold(one, |f, g| &f * g);
        prop_assert_eq!(&multiplied, &product.square_free());
        // Those of the product are those of p and of q.
        for factor in [&p, &q].into_iter().flat_map(|f| f.irreducible_factors().unwrap()) {
            prop_assert!(factors.contains(&factor), "{}", factor);
        }
    }

    #[test]
    fn rules_of_descartes_and_sturm(p in polynomial(6), a in rationals(2), width in 1_i64..9) {
        prop_assume!(!p.is_zero());
        for lower in a {
            let upper = &lower + r(width, 3);
            let sturm = SturmSequence::new(&p);
            let inside = sturm.count_roots(&lower, &upper) - usize::from(p.sign_at(&upper) == 0);
            prop_assert!(inside == 0 || p.may_vanish_between(&lower, &upper));
            let all = RealAlgebraic::roots_of(&p).into_iter().filter(|root| {
                root.cmp_rational(&lower).is_ge() && root.cmp_rational(&upper).is_le()
            });
            let found = RealAlgebraic::roots_between(&p, Some(lower.clone()), Some(upper.clone()));
            let at_end = usize::from(p.sign_at(&lower) == 0);
            prop_assert_eq!(found.len(), sturm.count_roots(&lower, &upper) + at_end);
            prop_assert_eq!(found, all.collect::<Vec<_>>());
        }
    }

    // Descartes' rule isolates the roots of dense polynomials, and Sturm's theorem counts them.
    #[test]
    fn every_isolated_interval_holds_one_root(p in polynomial(6), q in polynomial(5), roots in rationals(2)) {
        prop_assume!(!p.is_zero() && !q.is_zero());
        let product = &(&p * &q) * &with_roots(&roots);
        let sturm = SturmSequence::new(&product);
        let found = RealAlgebraic::roots_of(&product);
        prop_assert_eq!(found.len(), sturm.count_real_roots());
        prop_assert!(found.windows(2).all(|pair| pair[0] < pair[1]));
        for root in found {
            let (low, high) = root.bounds();
            let at_end = usize::from(product.sign_at(&low) == 0);
            prop_assert_eq!(sturm.count_roots(&low, &high) + at_end, 1);
        }
    }

    // Products of known linear factors, with a factor without real roots: the roots
    // are known without Sturm.
    #[test]
    fn rational_roots_are_found_as_rationals(
        mut roots in rationals(6), a in rationals(2), b in rationals(2),
    ) {
        let product = &with_roots(&roots) * &IntegerPolynomial::from([1, 1, 1]);
        let sturm = SturmSequence::new(&product);
        roots.sort();
        roots.dedup();
        let found = RealAlgebraic::roots_of(&product);
        prop_assert_eq!(sturm.count_real_roots(), roots.len());
        prop_assert_eq!(found.len(), roots.len());
        for (found, root) in found.iter().zip(&roots) {
            prop_assert_eq!(found.as_rational(), Some(root));
        }
        // Half-open counts, also with roots at the ends.
        for lower in roots.iter().chain(&a) {
            for upper in roots.iter().chain(&b) {
                let inside = roots.iter().filter(|root| lower < *root && *root <= upper).count();
                prop_assert_eq!(sturm.count_roots(lower, upper), inside);
            }
        }
    }

    // Against sign changes on a fine grid: each is a root, and between two roots
    // found there is a point where the sign is known.
    #[test]
    fn isolated_roots_are_roots_and_all_of_them(p in polynomial(6)) {
        prop_assume!(!p.is_zero());
        let roots = RealAlgebraic::roots_of(&p);
        prop_assert!(roots.windows(2).all(|pair| pair[0] < pair[1]));
        prop_assert!(roots.len() <= p.degree().unwrap_or(0));
        let part = p.square_free();
        for root in &roots {
            let e = root.enclosure(0);
            if let Some(value) = root.as_rational() {
                prop_assert_eq!(part.sign_at(value), 0);
                continue;
            }
            prop_assert_eq!(part.sign_at(e.lower()), -part.sign_at(e.upper()));
            prop_assert!(part.sign_at(e.lower()) != 0);
            prop_assert!(e.width() <= Rational::from(2).pow(-64));
            prop_assert_eq!(root.cmp_rational(e.lower()), Ordering::Greater);
            prop_assert_eq!(root.cmp_rational(e.upper()), Ordering::Less);
        }
        for (i, j) in (-320..320).map(|i| (i, i + 1)) {
            let (lower, upper) = (r(i, 32), r(j, 32));
            let (low, high) = (part.sign_at(&lower), part.sign_at(&upper));
            let inside = roots
                .iter()
                .filter(|root| root.cmp_rational(&lower) == Ordering::Greater)
                .filter(|root| root.cmp_rational(&upper) != Ordering::Greater)
                .count();
            if low * high != 0 {
                prop_assert_eq!(inside % 2 == 1, low != high, "in ({}, {}]", lower, upper);
            }
            prop_assert!(inside >= usize::from(high == 0));
        }
    }

    // √a < √b exactly when a < b; and the same number from different polynomials.
    #[test]
    fn square_roots_are_ordered(a in 1_i64..200, b in 1_i64..200, c in 1_i64..50) {
        let (x, y) = (root_of(a), root_of(b));
        prop_assert_eq!(x.cmp(&y), a.cmp(&b));
        prop_assert_eq!(x == y, a == b);
        prop_assert_eq!(x.cmp_rational(&r(c, 3)), (9 * a).cmp(&(c * c)));
        prop_assert_eq!(x.as_rational().is_some(), (0..=a).any(|s| s * s == a));
        // √a as a root of (x² − a)(x² − c)(x + 1), and of x⁴ − a².
        let product = &(&IntegerPolynomial::from([-a, 0, 1]) * &[-c, 0, 1].into()) * &[1, 1].into();
        let fourth = IntegerPolynomial::from([-a * a, 0, 0, 0, 1]);
        for other in [product, fourth] {
            let roots = RealAlgebraic::roots_of(&other);
            prop_assert_eq!(roots.iter().filter(|root| **root == x).count(), 1);
            for root in roots {
                prop_assert_eq!(root.cmp(&x), x.cmp(&root).reverse());
            }
        }
    }
}

#[test]
fn close_roots_are_told_apart() {
    // Mignotte: x⁸ − 2(ax − 1)² has two roots within a^(−5) of 1/a.
    let a = 100_000_i64;
    let square = IntegerPolynomial::from([1, -2 * a, a * a]);
    let mignotte = &IntegerPolynomial::from([0, 0, 0, 0, 0, 0, 0, 0, 1]) - &(&square + &square);
    let roots = RealAlgebraic::roots_of(&mignotte);
    assert_eq!(roots.len(), 4);
    let close = (&roots[1], &roots[2]);
    assert!(close.0 < close.1);
    assert_eq!(close.0.cmp_rational(&r(1, a)), Ordering::Less);
    assert_eq!(close.1.cmp_rational(&r(1, a)), Ordering::Greater);
    let off = Rational::from(a).pow(-5);
    assert_eq!(close.0.cmp_rational(&(r(1, a) - &off)), Ordering::Greater);
    assert_eq!(close.1.cmp_rational(&(r(1, a) + &off)), Ordering::Less);
}

#[test]
fn decimals_and_f64() {
    let two = root_of(2);
    // From the literature.
    assert_eq!(format::fixed(&two, 40), "1.4142135623730950488016887242096980785697");
    assert_eq!(format::scientific(&two, 12), "1.41421356237e0");
    assert_eq!(subcert::float::nearest(&two).to_bits(), 2_f64.sqrt().to_bits());
    // The root near 10^−30 of 10^30 x + x³ − 1.
    let tiny =
        IntegerPolynomial::from([-Integer::one(), Integer::power_of_ten(30), 0.into(), 1.into()]);
    let [root] = &RealAlgebraic::roots_of(&tiny)[..] else { panic!("one root") };
    assert_eq!(format::scientific(root, 5), "1.0000e-30");
    assert_eq!(subcert::float::nearest(root).to_bits(), 1e-30_f64.to_bits());
    assert_eq!((two.sign(), root.sign()), (1, 1));
    // A tie is a rational number, and so seen as one: 5/2 rounds to even.
    let tie =
        &RealAlgebraic::roots_of(&(&IntegerPolynomial::from([-5, 2]) * &[-3, 0, 1].into()))[2];
    assert_eq!(format::fixed(tie, 0), "2");
}

#[test]
fn forms() {
    assert!(RealAlgebraic::roots_of(&IntegerPolynomial::from([7])).is_empty());
    assert!(RealAlgebraic::roots_of(&IntegerPolynomial::from([1, 0, 1])).is_empty());
    let zero = &RealAlgebraic::roots_of(&IntegerPolynomial::from([0, 0, 5]))[0];
    assert_eq!((zero.to_string().as_str(), zero.sign()), ("0", 0));
    assert_eq!(zero.polynomial().to_string(), "x");
    assert_eq!(root_of(2).polynomial().to_string(), "x^2 - 2");
    assert!(root_of(2).to_string().starts_with("root of x^2 - 2 in ("));
}

#[test]
#[should_panic(expected = "every number is a root of 0")]
fn zero_has_every_root() {
    let _ = RealAlgebraic::roots_of(&IntegerPolynomial::default());
}
