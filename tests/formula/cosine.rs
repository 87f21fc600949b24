//! `cos` in formulas and masks.

use super::{definitions, kind, r, value_in};
use proptest::prelude::*;
use std::collections::BTreeMap;
use subcert::bound::{Order, power_norm, power_norm_generic};
use subcert::diagnostic::SourceText;
use subcert::exact::{CosineError, Polynomial, Rational, RealCyclotomic, common_conductor};
use subcert::formula::{FormulaErrorKind, Parameters, Scope, Value as _, evaluate, parse};
use subcert::scheme::{Mask, SchemeDefinition, read_scheme};

fn number(p: i64, q: i64) -> RealCyclotomic {
    RealCyclotomic::from(r(p, q))
}

fn cosine(j: i64, n: i64) -> RealCyclotomic {
    RealCyclotomic::cosine(&r(j, n)).unwrap()
}

fn value(text: &str) -> Result<RealCyclotomic, FormulaErrorKind> {
    let parameters = Parameters::from([("n", number(5, 1)), ("g", cosine(1, 5))]);
    value_in(text, &parameters).map_err(|error| error.kind)
}

proptest! {
    // A number printed is a formula for it, while it is short enough for one.
    #[test]
    fn what_prints_reads_back(
        terms in prop::collection::vec((-6_i64..7, 1_i64..5, 0_i64..30, 1_i64..25), 0..5),
    ) {
        let sum = terms.into_iter().try_fold(number(0, 1), |sum, (p, q, j, n)| {
            common_conductor(sum.conductor(), cosine(j, n).conductor()).ok()?;
            Some(&sum + &(&number(p, q) * &cosine(j, n)))
        });
        prop_assume!(sum.as_ref().is_some_and(|sum| sum.conductor() < 300));
        prop_assert_eq!(value(&sum.as_ref().unwrap().to_string()).ok(), sum);
    }
}

#[test]
fn angles() {
    for (text, j, n) in [
        ("cos(2*pi/5)", 1, 5),
        ("cos(pi*2/5)", 1, 5),
        ("cos((pi + pi)/5)", 1, 5),
        ("cos(-2*pi/n)", 1, 5),
        ("cos(2*pi*(n + 1)/n)", 1, 5),
        ("cos(2*pi*n^-1)", 1, 5),
        ("cos(pi - 3*pi/n)", 1, 5),
        ("cos(0.4·pi)", 1, 5),
        ("cos(4*pi/10 + 0)", 1, 5),
        ("cos(2*pi*(g + 1 - g)/n)", 1, 5),
        ("cos(2*pi*4*cos(pi/3)*binomial(n, 0)/7)", 2, 7),
        ("cos(2*(pi/(5*3) + pi/15))", 2, 15),
        ("cos(0)", 0, 1),
        ("cos(n - 5)", 0, 1),
        ("cos(pi*0)", 0, 1),
        ("cos(pi*(-3))", 1, 2),
        ("cos(100001*pi/3)", 1, 6),
    ] {
        let j = if text.contains("100001") { 100_001 } else { j };
        assert_eq!(value(text), Ok(cosine(j, n)), "{text}");
    }
    assert_eq!(value("sum(j = 1..n, cos(2*pi*j/n))"), Ok(number(0, 1)));
    assert_eq!(value("abs(cos(4*pi/5)) - max(g, cos(pi/5))"), Ok(number(0, 1)));
    assert_eq!(value("floor(10*g) + ceil(10*g) + floor(-10*g)"), Ok(number(3, 1)));
    assert_eq!(value("(1 - 2*g)/(4*g^2)*g^-1*4*g^3 + 2*g^1"), Ok(number(1, 1)));
    assert_eq!(value("min(g, 1/3) - g"), Ok(number(0, 1)));
    assert_eq!(value("mod(10*g, 3) - 10*g"), Ok(number(-3, 1)));
    assert_eq!(value("kronecker(g, -cos(6*pi/10)) + 2*kronecker(g, 1/3)"), Ok(number(1, 1)));
}

#[test]
fn errors_say_what_is_wrong_and_where() {
    let parameters = Parameters::from([("n", number(5, 1)), ("g", cosine(1, 5))]);
    for (text, place, message) in [
        ("1 + cos(1/2)", "1/2", "a rational multiple of `pi`, such as cos(2*pi*j/n); this is 1/2"),
        ("cos(pi + 1)", "pi + 1", "this is 1 + 1*pi"),
        ("cos(g*pi)", "g*pi", "this is (cos(2*pi/5))*pi"),
        ("cos(2*pi*pi)", "pi", "a multiple of pi^2"),
        ("cos(2/pi)", "pi", "divided by pi"),
        ("cos(pi/0)", "0", "division by zero"),
        ("cos(pi^2)", "pi", "only inside `cos`"),
        ("2*pi", "pi", "only inside `cos`"),
        ("sum(pi = 1..2, pi)", "pi", "only inside `cos`"),
        ("cos(abs(pi))", "pi", "only inside `cos`"),
        ("cos()", "cos()", "`cos` takes one argument, and was given 0"),
        ("cos(pi, pi)", "cos(pi, pi)", "`cos` takes one argument, and was given 2"),
        ("cos(pi, order = forward)", "cos(pi, order = forward)", "no option `order`"),
        ("cos(2*pi/100003)", "cos(2*pi/100003)", "n = 100003"),
        ("cos(2*pi*v)", "v", "unknown name `v`"),
        ("cos(2*pi/101) + cos(2*pi/103)", "cos(2*pi/103)", "n = 10403"),
        ("max(cos(2*pi/101), cos(2*pi/103))", "max(cos(2*pi/101), cos(2*pi/103))", "n = 10403"),
        ("sum(h = 90..110, cos(2*pi/h))", "cos(2*pi/h)", "at most n = 10000"),
        ("g^65", "g^65", "the power of a symbol or cosine"),
        ("2^g", "2^g", "must be an integer, and is cos(2*pi/5)"),
        ("cost(1)", "cost(1)", "sum, product, cos"),
        ("1/(1 + cos(2*pi/9973))", "(1 + cos(2*pi/9973))", "the number of bits"),
        ("sum(h = 1..300000, cos(2*pi*h/9973))", "", "the work of this formula"),
    ] {
        let error = value_in(text, &parameters).expect_err(text);
        assert!(error.to_string().contains(message), "{text}: {error}");
        if !place.is_empty() {
            assert_eq!(&text[error.span.clone()], place, "{text}");
        }
    }
}

#[test]
fn rational_cosines_are_there_over_every_type() {
    assert_eq!(super::value("cos(pi/3) + 2*cos(2*pi*7/3)"), Ok(r(-1, 2)));
    let irrational = kind("1 + cos(2*pi/5)");
    assert!(matches!(&irrational, FormulaErrorKind::Cosine(CosineError::Irrational { .. })));
    assert_eq!(irrational.to_string(), "cos(2*pi/5) is not rational");
    let symbols = Parameters::from([("w", Polynomial::variable("w"))]);
    assert_eq!(value_in("w*cos(pi)", &symbols).unwrap().to_string(), "-w");
    assert_eq!(value_in("cos(w*pi - w*pi)", &symbols).unwrap().to_string(), "1");
    let error = value_in("cos(w*pi)", &symbols).unwrap_err();
    assert!(error.to_string().contains("this is (w)*pi"), "{error}");
    assert_eq!(value_in("w*cos(pi/4)", &symbols).unwrap().to_string(), "(cos(pi/4))*w");
}

#[test]
fn definitions_may_hold_cosines_and_not_angles() {
    let some = definitions([("theta", "2*cos(2*pi/n)"), ("angle", "2*pi/n"), ("n", "7")]);
    let scope = Scope::<RealCyclotomic>::new(&some, &());
    let value = |text: &str| evaluate(&parse(text).unwrap(), &scope);
    assert_eq!(value("theta^3 + theta^2 - 2*theta"), Ok(number(1, 1)));
    let error = value("cos(angle)").unwrap_err();
    assert_eq!(error.kind, FormulaErrorKind::PiOutsideCosine);
}

#[test]
fn nesting_is_capped() {
    let nested = |depth: usize| "cos(pi*".repeat(depth) + "1" + &")".repeat(depth);
    // cos(π), cos(cos(π)π) = cos(−π), …
    assert_eq!(value(&nested(64)), Ok(number(-1, 1)));
    assert!(parse(&nested(65)).is_err());
    let heavy = "cos(pi*(1 + 2*".repeat(32) + "1" + &"))".repeat(32);
    assert_eq!(value(&heavy), Ok(number(-1, 1)));
}

fn scheme(text: &str) -> SchemeDefinition {
    read_scheme(&SourceText::new("circle.toml", text)).unwrap()
}

/// Weights that turn with the valence n; those of n = 6 are rational.
const CIRCLE: &str = r#"
name = "circle"
parameters.n = { about = "valence" }
arity = '2'
width = 'n'
entry = 'first*(1 - alpha) + second*alpha'
[let]
first = '(3 + 2*cos(2*pi*r/n) + delta*n)/(4*n)'
second = '(3 + 2*cos(2*pi*(r + 1)/n) + last*n)/(4*n)'
delta = '1 - min(r, 1)'
last = 'max(r + 2 - n, 0)'
"#;

fn mask(n: i64) -> Mask<RealCyclotomic> {
    scheme(CIRCLE).mask(&BTreeMap::from([("n".to_owned(), number(n, 1))])).unwrap()
}

#[test]
fn masks_agree_with_their_rational_path() {
    let rational: Mask = scheme(CIRCLE).mask(&BTreeMap::from([("n".to_owned(), r(6, 1))])).unwrap();
    let cyclotomic = mask(6);
    assert_eq!(rational.map(|a| RealCyclotomic::from(a.clone())), cyclotomic);
    for order in [Order::Adjoint, Order::Forward] {
        for levels in 0..4 {
            let kernel = power_norm(&rational.difference(), levels, order).unwrap().value;
            let generic = power_norm_generic(&cyclotomic.difference(), levels, order).unwrap();
            assert_eq!(generic, RealCyclotomic::from(kernel), "{levels}");
        }
    }
    // For n = 5 there is no rational path.
    let missing = scheme(CIRCLE).mask(&BTreeMap::from([("n".to_owned(), r(5, 1))])).unwrap_err();
    assert!(missing.to_string().contains("cos(2*pi/5) is not rational"), "{missing}");
}

// The first row of Doo–Sabin weights has sum 1 and sum of magnitudes 1; norms in
// the field are those in f64, within rounding.
#[test]
fn norms_of_masks_with_cosines() {
    for n in [5, 7, 12] {
        let mask = mask(n);
        let scheme_norm = power_norm_generic(mask.rules(), 2, Order::Adjoint).unwrap();
        assert_eq!(scheme_norm, number(1, 1), "{n}");
        let difference = mask.difference();
        for levels in 1..=3 {
            let exact = power_norm_generic(&difference, levels, Order::Adjoint).unwrap();
            let float = difference.map(subcert::float::nearest);
            let float = power_norm_generic(&float, levels, Order::Adjoint).unwrap();
            assert!((subcert::float::nearest(&exact) - float).abs() < 1e-13, "{n}: {exact}");
        }
    }
}

#[test]
fn masks_in_fields_too_large_are_refused() {
    let text = r#"
name = "apart"
mask = [
  ['cos(2*pi/101)', '1 - cos(2*pi/101)'],
  ['cos(2*pi/103)', '1 - cos(2*pi/103)'],
]
"#;
    let error = scheme(text).mask::<RealCyclotomic>(&BTreeMap::new()).unwrap_err();
    assert!(error.to_string().contains("n = 10403; at most n = 10000"), "{error}");
}

#[test]
fn pi_is_no_name() {
    for text in [
        "name = 'x'\nparameters.pi = { default = '3' }\nmask = [['1'], ['1']]",
        "name = 'x'\nmask = [['1'], ['1']]\nlet.pi = '3'",
    ] {
        let error = read_scheme(&SourceText::new("x.toml", text)).unwrap_err();
        assert!(error.to_string().contains("reserved for the angles"), "{error}");
    }
}

#[test]
fn sizes_are_counted() {
    let dense = |n: i64| (1..n / 2).fold(number(0, 1), |sum, j| &sum + &cosine(j, n));
    let (small, large) = (dense(101), dense(1009));
    assert!(small.size() < large.size() && small.product_size(&small) < 500_000);
    assert_eq!(Rational::from(1).conductor(), 1);
    assert_eq!(small.conductor(), 101);
}
