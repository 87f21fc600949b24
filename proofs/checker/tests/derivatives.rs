//! Derivatives and integrals of limits.

use crate::masks::{outcome, values};
use subcert_check::Outcome;

#[test]
fn derivatives() {
    values(&[
        ("limit_value(cubic, 0)", "2/3"),
        ("limit_value(cubic, 0, derivative = 0)", "2/3"),
        ("limit_value(cubic, 0, derivative = 1)", "0"),
        ("limit_value(cubic, -1, derivative = 1)", "1/2"),
        ("limit_value(cubic, 1, derivative = 1)", "-1/2"),
        // (2 − x)³/6 from 1 to 2, and 2/3 − x² + x³/2 before.
        ("limit_value(cubic, 3/2, derivative = 1)", "-1/8"),
        ("limit_value(cubic, 1/2, derivative = 1)", "-5/8"),
        ("limit_value(cubic, 0, derivative = 2)", "-2"),
        ("limit_value(cubic, 1, derivative = 2)", "1"),
        ("limit_value(cubic, 3/4, derivative = 2)", "1/4"),
        ("limit_value(cubic, -7/4, derivative = 2)", "1/4"),
        ("limit_value(cubic, 10^200, derivative = 2)", "0"),
        ("limit_value(cubic, -10^200, derivative = 1)", "0"),
        // The four-point scheme gives the usual difference quotient.
        ("limit_value(four, 0, derivative = 1)", "0"),
        ("limit_value(four, 1, derivative = 1)", "-2/3"),
        ("limit_value(four, -2, derivative = 1)", "-1/12"),
        ("limit_value(four, 2, derivative = 1)", "1/12"),
        ("limit_value(four, 3, derivative = 1)", "0"),
        // Polynomials are kept, whose derivatives are known.
        ("sum(k = -9..9, k*limit_value(bell, -k, derivative = 1))", "1"),
        ("sum(k = -10..10, k^7*limit_value(bell, 1/2 - k, derivative = 7))", "5040"),
        ("sum(k = -10..10, k^3*limit_value(bell, 1/2 - k, derivative = 7))", "0"),
        ("limit_value(1/3, scheme = ternary, derivative = 0)", "2/3"),
    ]);
}

#[test]
fn integrals() {
    values(&[
        ("integral(cubic, -2, 2)", "1"),
        ("integral(cubic, -10^90, 10^90)", "1"),
        ("integral(cubic, 2, -2)", "-1"),
        ("integral(cubic, 0, 2)", "1/2"),
        ("integral(cubic, 0, 1)", "11/24"),
        ("integral(cubic, 1, 3/2)", "5/128"),
        ("integral(cubic, 5, 7)", "0"),
        ("integral(cubic, -9, -5)", "0"),
        ("integral(hat, 1/4, 3/4)", "1/4"),
        ("integral(ternary, 1/9, 1/3)", "14/81"),
        ("integral(four, -3, 3)", "1"),
        ("integral(four, 0, 3)", "1/2"),
        ("integral(four, -1/2, 1/2) + integral(four, 1/2, 3)", "1 - integral(four, -3, -1/2)"),
        ("sum(k = -5..5, integral(four, 1/4 + k, 7/8 + k))", "5/8"),
        ("sum(k = -1..10, integral(bell, 1/4 + k, 1/2 + k))", "1/4"),
    ]);
}

#[test]
fn what_does_not_exist() {
    let found = |states: &str| outcome(states, "holds 1");
    for states in [
        "limit_value(cubic, 0, derivative = 3) = 0",
        "limit_value(hat, 1/2, derivative = 1) = -1",
        "limit_value(four, 0, derivative = 2) = 0",
        "limit_value(four, 0, derivative = 4) = 0",
        "limit_value(cubic, 0, derivative = 17) = 0",
        "limit_value(cubic, 1/3, derivative = 1) = 0",
        "limit_value(haar, 0, derivative = 1) = 0",
        "integral(haar, 0, 1) = 1",
        "integral(cubic, 0, 1/3) = 0",
        "integral(wild, 0, 1) = 1",
        "integral(cubic, 0, 2*cos(pi/6)) = 0",
    ] {
        assert!(matches!(found(states), Outcome::Incomplete(_)), "{states}: {:?}", found(states));
    }
    for states in [
        "limit_value(cubic, 0, derivative = 5) = 0",
        "limit_value(cubic, 0, derivative = -1) = 0",
        "limit_value(cubic, 0, derivative = one) = 0",
        "limit_value(cubic, 0, order = 1) = 0",
        "integral(cubic, 1) = 0",
        "integral(cubic, 0, 1, 2) = 0",
        "integral(cubic, 0, 1, derivative = 1) = 0",
    ] {
        assert!(matches!(found(states), Outcome::Invalid(..)), "{states}: {:?}", found(states));
    }
}
