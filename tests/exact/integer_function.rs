//! Functions of an integer against their values.

use proptest::prelude::*;
use subcert::exact::{IntegerFunction, Rational, RealExpression, Scalar};
use subcert::formula::{Parameters, RealValue, evaluate, parse};

const FIRST: i64 = 27;

/// Formulas in n.
fn formulas() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        (-3_i64..=3).prop_map(|n| n.to_string()),
        Just("n".to_owned()),
        (1_i64..=4).prop_map(|k| format!("cos({k}*pi/n)")),
        Just("cos(pi - 2*pi/n)".to_owned()),
    ];
    leaf.prop_recursive(4, 12, 2, |inner| {
        prop_oneof![
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a} + {b})")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a} - {b})")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a} * {b})")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a} / ({b}))")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("max({a}, {b})")),
            inner.clone().prop_map(|a| format!("sqrt(abs({a}))")),
            inner.clone().prop_map(|a| format!("floor({a})")),
            inner.prop_map(|a| format!("abs({a})")),
        ]
    })
}

fn sign(value: &RealValue) -> Option<std::cmp::Ordering> {
    value.compare(&RealValue::from_rational(&Rational::zero()))
}

proptest! {
    #[test]
    fn a_sign_is_that_of_every_value(text in formulas()) {
        let formula = parse(&text).expect("a formula");
        let all = Parameters::from([("n", IntegerFunction::index(FIRST))]);
        let Ok(function) = evaluate(&formula, &all) else { return Ok(()) };
        let Some(found) = function.sign() else { return Ok(()) };
        for n in [27, 28, 30, 36, 60] {
            let one = Parameters::from([("n", RealValue::from_rational(&Rational::from(n)))]);
            let value = evaluate(&formula, &one);
            prop_assert!(value.is_ok(), "{text} has no value at {n}: {value:?}");
            let value = value.unwrap();
            prop_assert_eq!(sign(&value), Some(found), "{} at {}", text, n);
            let at = function.value_at(n).expect("a value");
            // Whether two such numbers are equal may be beyond a cap; other numbers are told apart.
            prop_assert_ne!(value.compare(&at.clone().into()), Some(std::cmp::Ordering::Less));
            prop_assert_ne!(value.compare(&at.into()), Some(std::cmp::Ordering::Greater));
        }
    }
}

#[test]
fn most_functions_have_a_sign() {
    let t = IntegerFunction::index(FIRST);
    let number = |p: i64, q: i64| IntegerFunction::from_rational(&Rational::new(p, q));
    // t²(1 − cos(π/t)) lies between 4.9 and π²/2.
    let distance = t.times(&t).times(&number(1, 1).minus(&IntegerFunction::half_cosine(FIRST, 1)));
    for (bound, sign) in [((49, 10), 1), ((492, 100), 1), ((4935, 1000), -1), ((5, 1), -1)] {
        let difference = distance.minus(&number(bound.0, bound.1));
        assert_eq!(difference.sign().map(|sign| sign as i8), Some(sign), "{bound:?}");
    }
    // The limit itself is below every rational bound that is near enough, but not for all t.
    assert_eq!(distance.minus(&number(4932, 1000)).sign(), None);
    let root = |n: i64| number(n, 1).square_root().expect("of a positive number");
    let sum = root(2).plus(&root(3)).minus(&root(5).plus(&number(9, 10)));
    assert_eq!(sum.sign(), Some(std::cmp::Ordering::Greater));
    assert_eq!(root(2).times(&root(3)).minus(&root(6)).sign(), Some(std::cmp::Ordering::Equal));
    assert_eq!(
        root(6).inverse().unwrap().value_at(30),
        RealExpression::from(Rational::new(1, 6)).sqrt().ok()
    );
}
