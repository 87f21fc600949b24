//! Numbers of real fields: roots of roots, and fields that contain several numbers.

use proptest::prelude::*;
use subcert::exact::{
    AlgebraicNumber, Enclosed as _, FieldElement, FieldError, Rational, RealAlgebraic, Scalar,
    format::fixed,
};

fn number(x: i64) -> FieldElement {
    FieldElement::from_rational(&Rational::from(x))
}

fn square_root(x: &FieldElement) -> FieldElement {
    let square = [FieldElement::zero().minus(x), number(0), number(1)];
    FieldElement::root(&square, 2).expect("a positive number of a low degree")
}

fn minimal_polynomial(x: &FieldElement) -> String {
    x.field().expect("an irrational number").1.to_string()
}

#[test]
fn fields_are_as_small_as_they_can_be() {
    let ten = square_root(&number(10));
    let nested = square_root(&number(5).plus(&number(2).times(&ten)));
    assert_eq!(minimal_polynomial(&nested), "x^4 - 10x^2 - 15");
    // √10 is in the field of √(5 + 2√10).
    let both = FieldElement::together(&[ten, nested.clone()]).expect("degree 4");
    assert_eq!(minimal_polynomial(&both[0]), "x^4 - 10x^2 - 15");
    assert_eq!(both[0].to_string(), "-5/2 + 1/2*t^2");
    // √(3 + 2√2) = 1 + √2 needs no larger field.
    let two = square_root(&number(2));
    let denested = square_root(&number(3).plus(&number(2).times(&two)));
    assert_eq!(denested, number(1).plus(&two));
    assert_eq!(minimal_polynomial(&denested), "x^2 - 2");
    // Galois: Q(√2, √3) = Q(√2 + √3).
    let sum = FieldElement::together(&[two, square_root(&number(3))]).expect("degree 4");
    assert_eq!(sum[0].field().expect("irrational").1.degree(), Some(4));
    let six = AlgebraicNumber::from(square_root(&number(6)));
    assert_eq!(AlgebraicNumber::from(sum[0].times(&sum[1])), six);
}

#[test]
fn roots_are_counted_from_below() {
    let two = square_root(&number(2));
    // (x² − √2)(x − 3): −2^{1/4}, 2^{1/4}, 3.
    let [a, b] = [number(3).times(&two), number(0).minus(&two)];
    let polynomial = [a, b, number(-3), number(1)];
    let roots = FieldElement::real_roots(&polynomial).expect("a low degree");
    let decimals: Vec<String> = roots.iter().map(|root| fixed(root, 5)).collect();
    assert_eq!(decimals, ["-1.18921", "1.18921", "3.00000"]);
    // A multiple root counts once: (x − √2)².
    let double = [number(2), number(-2).times(&two), number(1)];
    assert_eq!(FieldElement::root(&double, 1), Ok(two));
    assert_eq!(FieldElement::root(&double, 2), Err(FieldError::NoSuchRoot { found: 1, asked: 2 }));
    let none = FieldElement::root(&[number(1), number(0), number(1)], 1);
    assert_eq!(none, Err(FieldError::NoSuchRoot { found: 0, asked: 1 }));
    assert_eq!(FieldElement::root(&[number(0)], 1), Err(FieldError::Zero));
}

#[test]
fn the_degree_is_capped() {
    let roots = [2, 3, 5, 7].map(|x| square_root(&number(x)));
    assert!(FieldElement::together(&roots).is_ok());
    let fifth = |x: i64| {
        let power = [-x, 0, 0, 0, 0, 1].map(number);
        FieldElement::root(&power, 1).expect("degree 5")
    };
    let error = FieldElement::together(&[fifth(2), fifth(3)]).expect_err("degree 25");
    assert_eq!(error, FieldError::Degree);
}

/// a + b√2 + c√3 + d√6 in the basis of the products, multiplied by hand.
fn naive_product(a: [i64; 4], b: [i64; 4]) -> [i64; 4] {
    [
        a[0] * b[0] + 2 * a[1] * b[1] + 3 * a[2] * b[2] + 6 * a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + 3 * (a[2] * b[3] + a[3] * b[2]),
        a[0] * b[2] + a[2] * b[0] + 2 * (a[1] * b[3] + a[3] * b[1]),
        a[0] * b[3] + a[3] * b[0] + a[1] * b[2] + a[2] * b[1],
    ]
}

/// The number with these coordinates, its roots taken anew: each in a field of its own.
fn combined(c: [i64; 4]) -> AlgebraicNumber {
    let term = |x: i64, root: i64| {
        AlgebraicNumber::from(number(x)).times(&square_root(&number(root)).into())
    };
    let terms = [(1, 2), (2, 3), (3, 6)].map(|(i, root)| term(c[i], root));
    terms.iter().fold(number(c[0]).into(), |sum: AlgebraicNumber, term| sum.plus(term))
}

proptest! {
    #![proptest_config(crate::common::cases(24))]

    #[test]
    fn products_across_fields_are_those_of_coordinates(
        a in prop::array::uniform4(-9_i64..10),
        b in prop::array::uniform4(-9_i64..10),
    ) {
        let (x, y) = (combined(a), combined(b));
        prop_assert_eq!(x.times(&y), combined(naive_product(a, b)));
        let decimal = |c: [i64; 4]| {
            let f = |i: usize| f64::from(i32::try_from(c[i]).expect("a small number"));
            f(0) + f(1) * 2_f64.sqrt() + f(2) * 3_f64.sqrt() + f(3) * 6_f64.sqrt()
        };
        let gap = decimal(a) - decimal(b);
        let sign = if gap.abs() < 1e-9 { 0 } else { gap.total_cmp(&0.0) as i8 };
        prop_assert_eq!(x.minus(&y).sign(), sign);
    }

    /// The roots of a polynomial over Q(√2) are zeros of it, and there are as many as its changes of sign on a fine grid
    /// show at least.
    #[test]
    fn roots_are_zeros(c in prop::collection::vec((-6_i64..7, -6_i64..7), 2..5)) {
        let two = square_root(&number(2));
        let mut p: Vec<FieldElement> =
            c.iter().map(|(a, b)| number(*a).plus(&number(*b).times(&two))).collect();
        p.push(number(1));
        let value = |x: &FieldElement| p.iter().rev().fold(FieldElement::zero(), |v, c| v.times(x).plus(c));
        let roots = FieldElement::real_roots(&p).expect("a low degree");
        for root in &roots {
            let (inside, root) = FieldElement::adjoined(&p, root).expect("a low degree");
            let v = inside.iter().rev().fold(FieldElement::zero(), |v, c| v.times(&root).plus(c));
            prop_assert_eq!(v.sign(), 0);
        }
        let signs = (-200_i64..=200).map(|i| value(&FieldElement::from_rational(&Rational::new(i, 10))).sign());
        let signs: Vec<i8> = signs.filter(|sign| *sign != 0).collect();
        let changes = signs.windows(2).filter(|pair| pair[0] != pair[1]).count();
        prop_assert!(changes <= roots.len());
        let ascending = |pair: &[RealAlgebraic]| pair[0].enclosure(0).lower() < pair[1].enclosure(0).upper();
        prop_assert!(roots.windows(2).all(ascending));
    }
}
