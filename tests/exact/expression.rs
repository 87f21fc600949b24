//! Expressions with square roots and roots of polynomials: laws, facts, and f64.

use crate::common::{int, r};
use proptest::prelude::*;
use std::cmp::Ordering;
use subcert::exact::{
    Integer, Rational, Real, RealAlgebraic, RealCyclotomic, RealExpression, RootError, Scalar,
    format::{fixed, short},
};
use subcert::float::{exact, nearest, nearest_f32};

fn number(value: i64) -> RealExpression {
    RealExpression::from(Rational::from(value))
}

fn cosine(p: i64, q: i64) -> RealExpression {
    RealExpression::from(RealCyclotomic::cosine(&r(p, q)).expect("a small field"))
}

fn root(value: &RealExpression) -> RealExpression {
    value.sqrt().unwrap_or_else(|error| panic!("{error}"))
}

/// A conversion by `as` rounds once, to nearest, half to even.
#[expect(clippy::cast_possible_truncation, reason = "it rounds on purpose")]
fn single(value: f64) -> f32 {
    value as f32
}

/// Random numbers of several fields, with an f64 computed beside them.
fn expression() -> impl Strategy<Value = (RealExpression, f64)> {
    let angle = (0_i32..7, prop_oneof![Just(5_i32), Just(7), Just(12)]);
    let leaf = prop_oneof![
        (-9_i32..10, 1_i32..5).prop_map(|(p, q)| {
            let value = RealExpression::from(r(p.into(), q.into()));
            (value, f64::from(p) / f64::from(q))
        }),
        angle.prop_map(|(p, q)| {
            let turn = f64::from(p) / f64::from(q);
            (cosine(p.into(), q.into()), (2.0 * std::f64::consts::PI * turn).cos())
        }),
    ];
    leaf.prop_recursive(2, 5, 2, |inner| {
        prop_oneof![
            (inner.clone(), inner.clone()).prop_map(|((a, x), (b, y))| (a.plus(&b), x + y)),
            (inner.clone(), inner.clone()).prop_map(|((a, x), (b, y))| (a.minus(&b), x - y)),
            (inner.clone(), inner.clone()).prop_map(|((a, x), (b, y))| (a.times(&b), x * y)),
            inner.prop_map(|(a, x)| {
                let square = a.times(&a).plus(&number(1));
                (root(&square), (x * x + 1.0).sqrt())
            }),
        ]
    })
}

proptest! {
    #![proptest_config(crate::common::cases(40))]

    #[test]
    fn values_are_those_of_f64((a, x) in expression()) {
        prop_assert!((nearest(&a) - x).abs() < 1e-9 * (1.0 + x.abs()), "{a} is not {x}");
    }

    // Both sides are other expressions, so that equality comes from the bound that separates.
    #[test]
    fn laws_of_an_ordered_field((a, _) in expression(), (b, _) in expression(), (c, _) in expression()) {
        prop_assert_eq!(a.plus(&b).times(&c), a.times(&c).plus(&b.times(&c)));
        prop_assert_eq!(a.cmp(&b), a.plus(&c).cmp(&b.plus(&c)));
        let positive = b.times(&b).plus(&number(1));
        prop_assert_eq!(a.over(&positive).times(&positive), a.clone());
        let square = a.times(&a);
        prop_assert_eq!(root(&square), a.magnitude());
    }

    #[test]
    fn nested_roots(a in 1_i64..60, b in 1_i64..60) {
        // √(a + b + 2√(ab)) = √a + √b
        let inner = number(a + b).plus(&number(2).times(&root(&number(a * b))));
        prop_assert_eq!(root(&inner), root(&number(a)).plus(&root(&number(b))));
    }

    #[test]
    fn f32_is_nearest(bits in any::<u32>(), wide in any::<u64>()) {
        for value in [f64::from(f32::from_bits(bits)), f64::from_bits(wide)] {
            let Some(value_exact) = exact(value) else { continue };
            prop_assert_eq!(nearest_f32(&value_exact).to_bits(), single(value).to_bits());
            let around = [single(value), single(value).next_up()].map(f64::from);
            let half_way = f64::midpoint(around[0], around[1]);
            if let Some(middle) = exact(half_way) {
                prop_assert_eq!(nearest_f32(&middle).to_bits(), single(half_way).to_bits());
            }
        }
    }

    // The minimal polynomial has the number as a root, and is that of a number written in another way.
    #[test]
    fn minimal_polynomials((a, _) in expression()) {
        let Some(polynomial) = a.minimal_polynomial() else { return Ok(()) };
        let value = polynomial.coefficients().iter().rev().fold(number(0), |value, c| {
            value.times(&a).plus(&RealExpression::from(Rational::from(c.clone())))
        });
        prop_assert_eq!(value.sign(), 0);
        prop_assert_eq!(polynomial.irreducible_factors().map(|factors| factors.len()), Some(1));
        let algebraic = a.to_algebraic().expect("the field is small enough");
        prop_assert_eq!(algebraic.cmp_rational(&r(1, 3)), a.cmp(&RealExpression::from(r(1, 3))));
        if polynomial.degree() == Some(1) {
            prop_assert!(a.as_rational().is_some());
        }
    }
}

#[test]
fn close_numbers_are_told_apart() {
    // √10 + √11 − √5 − √18 = 0.00019…
    let sum = |a, b| root(&number(a)).plus(&root(&number(b)));
    assert!(sum(10, 11) > sum(5, 18));
    // √(x² + 1) is below x + 1/(2x) by about 1/(8x³).
    let x = RealExpression::from(Rational::power_of_ten(40));
    let near = root(&x.times(&x).plus(&number(1)));
    let bound = x.plus(&number(1).over(&number(2).times(&x)));
    assert!(near < bound);
    let gap = RealExpression::from(Rational::power_of_ten(-122));
    assert!(bound.minus(&near) > gap && bound.minus(&near) < gap.times(&number(100)));
}

#[test]
fn rational_values_are_found() {
    // (√2 + √3)² − 2√6 = 5
    let sum = root(&number(2)).plus(&root(&number(3)));
    let five = sum.times(&sum).minus(&number(2).times(&root(&number(6))));
    assert_eq!(five.as_number(), None);
    assert_eq!(five.as_rational(), Some(&r(5, 1)));
    assert_eq!((fixed(&five, 3), short(&five, 6)), ("5.000".to_owned(), "5".to_owned()));
    assert_eq!(sum.as_rational(), None);
    // Half-way between two decimals.
    assert_eq!(fixed(&five.over(&number(2)), 0), "2");
}

#[test]
fn roots_of_polynomials() {
    let polynomial = [1, -3, 0, 1].map(RealCyclotomic::from);
    let roots: Vec<RealExpression> =
        (1..=3).map(|i| RealExpression::root(&polynomial, i).expect("three roots")).collect();
    // 2cos 160°, 2cos 80°, 2cos 40°
    for (root, turn) in roots.iter().zip([4, 2, 1]) {
        assert_eq!(*root, number(2).times(&cosine(turn, 9)));
        assert_eq!(root.minimal_polynomial().expect("of degree 3").to_string(), "x^3 - 3x + 1");
    }
    assert_eq!(roots[0].plus(&roots[1]).plus(&roots[2]), number(0));

    // (x² − 2)²(x − 2cos 72°): the double roots count once.
    let c = cosine(1, 5).as_number().expect("a cosine").clone();
    let (four, minus) = (RealCyclotomic::from(4), -&c.times(&RealCyclotomic::from(2)));
    let times = |k: i64| minus.times(&RealCyclotomic::from(k));
    let product =
        [times(4), four, times(-4), RealCyclotomic::from(-4), times(1), RealCyclotomic::from(1)];
    let found: Vec<RealExpression> =
        (1..=3).map(|i| RealExpression::root(&product, i).expect("three roots")).collect();
    let two = root(&number(2));
    assert_eq!(found, [number(0).minus(&two), number(2).times(&cosine(1, 5)), two]);

    let error = |coefficients: &[i64], index| {
        let given: Vec<RealCyclotomic> =
            coefficients.iter().map(|c| RealCyclotomic::from(*c)).collect();
        RealExpression::root(&given, index).unwrap_err()
    };
    assert_eq!(error(&[1, 0, 1], 1), RootError::Index { index: 1, count: 0 });
    assert_eq!(error(&[-2, 0, 1], 0), RootError::Index { index: 0, count: 2 });
    assert_eq!(error(&[-2, 0, 1], 3), RootError::Index { index: 3, count: 2 });
    assert_eq!(error(&[3, 0], 1), RootError::Constant);
    assert_eq!(error(&[0; 3], 1), RootError::Constant);
    assert_eq!(error(&[[1; 10], [1; 10]].concat(), 1), RootError::Degree(19));
}

/// Where a root is to be known to many places, each step doubles them; what it proves is what signs at the ends say.
#[test]
fn roots_to_many_places() {
    let c = cosine(1, 7).as_number().expect("a cosine").clone();
    let whole = RealCyclotomic::from;
    // x⁶ + x − 3, x³ − 2cos(2π/7)x − 1, and (3x − 1)(x² − 2), whose first root above 0 is rational.
    let six = [-3, 1, 0, 0, 0, 0, 1].map(whole);
    let three = [whole(-1), c.times(&whole(-2)), whole(0), whole(1)];
    let product = [2, -6, -1, 3].map(whole);
    for (polynomial, index) in [(&six[..], 2), (&three, 1), (&product, 3)] {
        let root = RealExpression::root(polynomial, index).expect("a root");
        let near = root.near(6);
        assert!(near.width() < r(1, 2).pow(4095), "{root}");
        let value = |at: &Rational| {
            let at = RealCyclotomic::from(at.clone());
            polynomial.iter().rev().fold(whole(0), |sum, c| sum.times(&at).plus(c)).sign()
        };
        assert_eq!(value(near.lower()) * value(near.upper()), -1, "{root}");
        // Horner's rule gives 0, which takes as many places as the bound on its size says.
        let powers = polynomial
            .iter()
            .rev()
            .fold(number(0), |sum, c| sum.times(&root).plus(&RealExpression::from(c.clone())));
        assert_eq!(powers.sign(), 0, "{root}");
    }
    let third = RealExpression::root(&product, 2).expect("a root");
    assert_eq!(third.to_algebraic(), Some(RealAlgebraic::from(r(1, 3))));
}

#[test]
fn forms() {
    let half = RealExpression::from(r(1, 2));
    let sum = half.plus(&half.times(&root(&number(5))));
    assert_eq!(sum.to_string(), "1/2 + 1/2*sqrt(5)");
    assert_eq!(half.minus(&root(&sum)).to_string(), "1/2 - sqrt(1/2 + 1/2*sqrt(5))");
    assert_eq!(sum.times(&sum).to_string(), "(1/2 + 1/2*sqrt(5))*(1/2 + 1/2*sqrt(5))");
    assert_eq!(number(1).over(&root(&number(2))).to_string(), "1/sqrt(2)");
    assert_eq!(root(&number(72)).to_string(), "6*sqrt(2)");
    assert_eq!(root(&cosine(1, 5).plus(&number(1))).to_string(), "1/2*sqrt(4 + 4*cos(2*pi/5))");
    let error = number(-2).sqrt().unwrap_err();
    assert!(matches!(error, RootError::Negative { .. }) && error.to_string().contains("-2"));
}

// The golden ratio by its square root, by its cosine, and as a root of its polynomial.
#[test]
fn one_number_in_three_ways() {
    let by_root = RealExpression::from(r(1, 2)).times(&number(1).plus(&root(&number(5))));
    let by_cosine = number(2).times(&cosine(1, 10));
    let polynomial = [-1, -1, 1].map(RealCyclotomic::from);
    let by_polynomial = RealExpression::root(&polynomial, 2).expect("two roots");
    assert_eq!(by_root.cmp(&by_cosine), Ordering::Equal);
    assert_eq!(by_root, by_polynomial);
    let algebraic: RealAlgebraic = by_root.to_algebraic().expect("a small field");
    assert_eq!(algebraic.polynomial().to_string(), "x^2 - x - 1");
    assert_eq!(by_root.degree_bound(), 2);
    assert!(Integer::from(int(2)).bits() < by_root.minus(&by_cosine).separation());
}
