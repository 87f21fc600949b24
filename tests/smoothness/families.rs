//! Families of symbols against their single members.

use proptest::prelude::*;
use std::collections::BTreeMap;
use subcert::diagnostic::SourceText;
use subcert::exact::{Polynomial, Rational, RationalPolynomial};
use subcert::scheme::{Mask, SchemeDefinition, read_scheme};
use subcert::smoothness::{Smoothness, Symbol, SymbolFamily, reproduction_degree};

/// Factors whose value at z = 1 is 1.
const FACTORS: [&str; 9] = [
    "((1+z)/2)",
    "((1+z+z^2)/3)",
    "((1+z^2)/2)",
    "((1-z^6)/(1-z)/6)",
    "(2-z)",
    "((-1+4*z-z^2)/2)",
    "(z-k*(1-z)^2)",
    "(k+1-k*z)",
    "((1+z^3)/2)",
];

/// A product of factors with exponents ak + b, and its arity.
fn symbols() -> impl Strategy<Value = (usize, String)> {
    let factor = (0..FACTORS.len(), 0_i64..=2, 0_i64..=2);
    (2_usize..=4, proptest::collection::vec(factor, 1..4)).prop_map(|(n, factors)| {
        let text = factors.iter().map(|(at, a, b)| {
            // What depends on k stands once, or many coefficients become large.
            let (a, b) = if FACTORS[*at].contains('k') { (0, 1) } else { (*a, *b) };
            format!("*{}^({a}*k+{b})", FACTORS[*at])
        });
        let sigma = ["(1+z)/2", "(1+z+z^2)/3", "(1+z+z^2+z^3)/4"][n - 2];
        (n, format!("{n}*({sigma})^(k+1)/z^k{}", text.collect::<String>()))
    })
}

fn definition(text: &str) -> SchemeDefinition {
    let text = format!("name = 's'\nparameters.k = {{}}\nsymbol = '{text}'\n");
    read_scheme(&SourceText::new("s.toml", text)).expect("a scheme")
}

fn member(scheme: &SchemeDefinition, k: i64) -> Mask {
    let values = BTreeMap::from([("k".to_owned(), Rational::from(k))]);
    scheme.mask(&values).expect("a mask")
}

proptest! {
    #[test]
    fn values_are_those_of_each_member((arity, text) in symbols(), first in 1_i64..4) {
        let scheme = definition(&text);
        let open = BTreeMap::from([("k".to_owned(), Polynomial::variable("k"))]);
        let family = scheme.powers(&open, ("k", first)).and_then(|powers| SymbolFamily::of(&powers, first));
        let family = family.expect("masks of one arity");
        prop_assert_eq!(family.arity(), arity);
        for k in first..first + 4 {
            let at = |value: RationalPolynomial| value.value_at(&Rational::from(k));
            let mask = member(&scheme, k);
            let symbol = Symbol::of(&mask);
            let (low, high) = symbol.support();
            prop_assert_eq!(family.support().map(at), [low, high]);
            if let Some(order) = family.sum_rules() {
                prop_assert_eq!(at(order), Rational::from(symbol.sum_rules().0), "{} at {}", text, k);
            }
            if let Some(degree) = family.reproduction() {
                let known = Rational::from(reproduction_degree(&mask));
                prop_assert_eq!(at(degree), known, "{} at {}", text, k);
            }
            let coefficients = symbol.coefficients();
            let symmetric = coefficients.iter().eq(coefficients.iter().rev());
            prop_assert!(symmetric || !family.is_symmetric());
        }
    }
}

#[test]
fn smoothness_grows_by_what_is_added() {
    for (text, added) in [
        ("2*((1+z)/2)^(k+2)", Some(1)),
        ("2*((1+z)/2)^(2*k+2)*(-1+4*z-z^2)/2", Some(2)),
        ("3*((1+z+z^2)/3)^(k+1)*(4-z)/3", Some(1)),
        // σ is 1 + z + z², and 1 + z is none of its powers.
        ("3*((1+z+z^2)/3)^2*((1+z)/2)^k", None),
        ("2*((1+z)/2)^k*(z-k*(1-z)^2)", None),
        ("2*((1+z)/2)^2*(2-z)^k", None),
    ] {
        let scheme = definition(text);
        let open = BTreeMap::from([("k".to_owned(), Polynomial::variable("k"))]);
        let powers = scheme.powers(&open, ("k", 1)).expect("a product");
        let family = SymbolFamily::of(&powers, 1).expect("masks");
        assert_eq!(family.added(), added, "{text}");
        let Some(added) = added else { continue };
        let known = |k: i64| Smoothness::of(&member(&scheme, k)).expect("small").continuity;
        for k in 1..4 {
            let start = known(k).expect("continuous limits");
            let more = usize::try_from(added).expect("positive");
            assert_eq!(known(k + 1), Some(start + more), "{text} at {k}");
        }
    }
}

#[test]
fn a_parameter_is_not_less_than_its_least_value() {
    let text = "name = 's'\nparameters.k = { least = '3' }\nsymbol = '(1+z)^(k+1)/2^k'\n";
    let scheme = read_scheme(&SourceText::new("s.toml", text)).expect("a scheme");
    let open = BTreeMap::from([("k".to_owned(), Polynomial::variable("k"))]);
    assert_eq!(scheme.powers(&open, ("k", 2)), None);
    assert!(scheme.powers(&open, ("k", 3)).is_some());
}
