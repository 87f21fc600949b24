//! Every cap: what is just below it works, what is just above it is refused.

use super::{kind, r, value, value_in};
use proptest::prelude::*;
use subcert::exact::{Integer, Polynomial, Rational};
use subcert::formula::{FormulaErrorKind, MAX_FORMULA_LENGTH, MAX_NESTING, Parameters, parse};

#[test]
fn nesting() {
    for (open, core, close) in [
        ("(", "1", ")"),
        ("-", "1", ""),
        ("1^", "1", ""),
        ("abs(", "1", ")"),
        ("min(1, ", "1", ")"),
        ("sum(h = 1..1, ", "1", ")"),
        ("1+(", "1", ")"),
    ] {
        let nested = |depth: usize| open.repeat(depth) + core + &close.repeat(depth);
        assert!(value(&nested(MAX_NESTING)).is_ok(), "{open}");
        assert_eq!(kind(&nested(MAX_NESTING + 1)), FormulaErrorKind::TooDeep, "{open}");
        assert_eq!(kind(&nested(250)), FormulaErrorKind::TooDeep, "{open}");
    }
    // As many tree nodes in a level of nesting as there can be: no stack overflows.
    let heavy = "abs(1+2*".repeat(MAX_NESTING) + "1" + &")^1".repeat(MAX_NESTING);
    assert!(parse(&heavy).is_ok());
    let _ = value(&heavy);
}

#[test]
fn length() {
    let longest = "1".to_owned() + &"+1".repeat((MAX_FORMULA_LENGTH - 1) / 2);
    assert_eq!(value(&longest), Ok(r(i64::try_from(longest.len().div_ceil(2)).unwrap(), 1)));
    let padded = format!("{longest:width$}", width = MAX_FORMULA_LENGTH + 1);
    assert_eq!(kind(&padded), FormulaErrorKind::TooLong(MAX_FORMULA_LENGTH + 1));
}

fn is_too_large(text: &str) -> bool {
    matches!(kind(text), FormulaErrorKind::BeyondCap(_))
}

#[test]
fn powers() {
    assert!(value("2^150000") == Ok(Rational::from(Integer::from(2).pow(150_000))));
    for text in ["2^200000", "(2/3)^-150000", "2^2^40", "10^1000000000000", "2^-4294967297"] {
        assert!(is_too_large(text), "{text}");
    }
    // Powers of 0 and ±1 do not grow.
    assert_eq!(value("(-1)^2147483647"), Ok(r(-1, 1)));
    assert_eq!(value("0^2147483647 + 1^-2147483647"), Ok(r(1, 1)));
    // Repeated squares are no way around: each is capped before it is computed.
    let squares = "(".repeat(30) + "3" + &")^2".repeat(30);
    assert!(is_too_large(&squares));
    assert!(is_too_large("3^150000*3^150000*3^150000"));
    assert!(is_too_large("1/3^150000/5^100000/7^100000"));
}

#[test]
fn work() {
    assert_eq!(value("sum(h = 1..300000, 1)"), Ok(r(300_000, 1)));
    for text in [
        "sum(h = 1..2000000, 1)",
        "sum(h = -1000000000..1000000000, 0)",
        "sum(h = 1..1100, sum(k = 1..1100, 1))",
        // Few steps, but each with large numbers.
        "sum(h = 1..1000000, 3^150000)",
        "sum(h = 1..100000, 1/h)",
    ] {
        assert!(is_too_large(text), "{text}");
    }
}

#[test]
fn binomials() {
    // C(20000, 10000), from factorials.
    let factorial = |n: u32| (1..=n).fold(Integer::one(), |product, i| product * Integer::from(i));
    let central = factorial(20_000).div_floor(&factorial(10_000).pow(2));
    assert!(value("binomial(20000, 10000)") == Ok(Rational::from(central)));
    for text in ["binomial(20000, 10001)", "binomial(2^100, 10000)", "binomial(1, 2^60)"] {
        assert!(is_too_large(text), "{text}");
    }
    assert_eq!(value("binomial(5, -2^30)"), Ok(r(0, 1)));
}

proptest! {
    /// C(p/q, k) = Π (p/q − i)/(i + 1), factor by factor.
    #[test]
    fn binomials_of_fractions(p in -60..60_i64, q in 1..40_i64, k in 0..24_i64) {
        let factor = |i: i64| (r(p, q) - r(i, 1)) / r(i + 1, 1);
        let product = (0..k).fold(r(1, 1), |product, i| product * factor(i));
        prop_assert_eq!(value(&format!("binomial(({p})/{q}, {k})")), Ok(product));
    }
}

#[test]
fn symbols() {
    let names = ["a", "b", "c", "d"];
    let symbols = Parameters(
        names.iter().map(|name| ((*name).to_owned(), Polynomial::variable(name))).collect(),
    );
    let value = |text: &str| value_in(text, &symbols);
    assert_eq!(value("(a + b)^64").unwrap().term_count(), 65);
    assert_eq!(value("binomial(a, 64)").unwrap().degree(), 64);
    assert_eq!(value("((a^64)^64)^64").unwrap().degree(), 1 << 18);
    for text in [
        "a^65",
        "binomial(a, 65)",
        "(a + b + c + d)^60",
        "(1 + a + b + c + d)^12*(1 + a + b + c + d)^12",
        // Exponents never wrap around: a^(2^36) is not 1.
        "(((((a^64)^64)^64)^64)^64)^64",
        "((2^2000*a)^64)^64",
    ] {
        let error = value(text).unwrap_err();
        assert!(matches!(error.kind, FormulaErrorKind::BeyondCap(_)), "{text}: {error}");
    }
}
